#pragma once
// An amount of memory as people read it.

#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace mien {

/// "999 bytes", "39 KiB", "1.46 GiB": three digits.
inline std::string bytes_text(std::uint64_t bytes) {
  constexpr const char* kUnits[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  double value = double(bytes);
  int unit = 0;
  for (; value >= 1000 && unit < 6; ++unit) value /= 1024;
  return bytes == 1 ? "1 byte" : fmt::format("{:.3g} {}", value, kUnits[unit]);
}

}  // namespace mien
