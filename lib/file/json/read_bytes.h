#pragma once
// Files into memory, whole.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace mien {

/// All bytes of a file, or of a pipe up to its end. Errors: a directory; a file that cannot be read, and
/// why; more than `most` bytes, which are then not read. Their `where` is the file's name.
Expected<std::string> read_bytes(const std::filesystem::path& path, std::size_t most);

/// Gives `take` the bytes of a file or pipe in blocks, until its end or until it answers false. Errors as above.
Expected<Done> read_in_blocks(const std::filesystem::path& path,
                              const std::function<bool(std::string_view)>& take);

}  // namespace mien
