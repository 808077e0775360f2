#pragma once
// Files other than pictures, also written whole or not at all.

#include <mien/npy.h>

#include <functional>
#include <string>

namespace mien::command {

/// Lets `write` fill the file at `path` ("-": standard output). After an error nothing of it is left, and a
/// file that was there before stays.
Expected<Done> write_file(const std::string& path,
                          const std::function<Expected<Done>(const ByteSink&)>& write);

}  // namespace mien::command
