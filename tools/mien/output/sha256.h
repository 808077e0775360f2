#pragma once
// SHA-256 (FIPS 180-4) of bytes, by nettle.

#include <cstddef>
#include <span>
#include <string>

namespace mien::command {

/// In 64 hexadecimal digits, as sha256sum prints it.
std::string sha256(std::span<const std::byte> bytes);

}  // namespace mien::command
