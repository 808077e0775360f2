#include "render/image/picture_encoder.h"
#include "lib/base/bytes_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {

int slots_within(const PieceBudget& budget, std::uint64_t fixed, std::uint64_t each) {
  if (budget.bytes < fixed) return 0;
  return int(std::min(std::uint64_t(budget.slots), (budget.bytes - fixed) / each));
}

Error too_little_memory(std::uint64_t needed, std::uint64_t allowed) {
  return {"", fmt::format("needs at least {} of memory, more than the {} allowed",
                          bytes_text(needed), bytes_text(allowed))};
}

}  // namespace mien
