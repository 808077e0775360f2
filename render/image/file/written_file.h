#pragma once
// Files other than pictures of pixels, also written whole or not at all.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <functional>

namespace mien {

/// Takes bytes, one behind the other.
using PutBytes = std::function<Expected<Done>(const void* bytes, std::size_t size)>;

/// Lets `write` fill the file at `path` ("-": standard output). After an error nothing of it is left, and a
/// file that was there before stays.
Expected<Done> write_file(const std::filesystem::path& path,
                          const std::function<Expected<Done>(const PutBytes&)>& write);

}  // namespace mien
