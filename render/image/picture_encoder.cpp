#include "render/image/picture_encoder.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {

int slots_within(const PieceBudget& budget, std::uint64_t fixed, std::uint64_t each) {
  if (budget.bytes < fixed) return 0;
  return int(std::min(std::uint64_t(budget.slots), (budget.bytes - fixed) / each));
}

std::string bytes_text(std::uint64_t bytes) {
  static constexpr const char* kUnits[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  double value = double(bytes);
  int unit = 0;
  for (; value >= 1000 && unit < 6; ++unit) value /= 1024;
  return bytes == 1 ? "1 byte" : fmt::format("{:.3g} {}", value, kUnits[unit]);
}

Error too_little_memory(std::uint64_t needed, std::uint64_t allowed) {
  return {"", fmt::format("needs at least {} of memory, more than the {} allowed",
                          bytes_text(needed), bytes_text(allowed))};
}

}  // namespace mien
