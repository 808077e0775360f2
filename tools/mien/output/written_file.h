#pragma once
// Files that are no pictures: whole or not at all, too.

#include <mien/npy.h>

#include <functional>
#include <string>

namespace mien::command {

/// Lets `write` fill the file at `path` ("-": standard output); nothing is left of it after an
/// error, and what was there before stays.
Expected<Done> write_file(const std::string& path,
                          const std::function<Expected<Done>(const ByteSink&)>& write);

}  // namespace mien::command
