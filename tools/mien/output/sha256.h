#pragma once
// SHA-256 (FIPS 180-4) of bytes, by nettle.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace mien::command {

/// In 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::span<const std::byte> bytes);

/// A file's, which may be of any size. An interrupt ends it with the Error `cancelled`, without an address; other errors
/// have the file's name.
Expected<std::string> sha256_of_file(const std::filesystem::path& path);

}  // namespace mien::command
