#include "render/cover/part_form.h"

#include <algorithm>

namespace mien {
PartEntry PartEntry::whole() {
  PartEntry all;
  all.height.fill(1.0f / kRows);
  return all;
}

void PartEntry::add(const PartStretch& s) {
  constexpr float kRow = 1.0f / kRows;
  for (int k = 0; k < kRows; ++k) {
    const float top = float(k) * kRow, from = std::max(s.yp, top), to = std::min(s.yq, top + kRow),
                by = s.sign * std::max(to - from, 0.0f);
    height[std::size_t(k)] += by;
    moment[std::size_t(k)] += by * (0.5f * (from + to) - (top + 0.5f * kRow));
  }
}

void whole_cells(int side, PartCells& to) {
  to.side = side;
  const float cell = 1.0f / float(side);
  const auto middle = [&](int i) { return (float(i) + 0.5f) * cell - 0.5f; };
  std::fill_n(to.area.begin(), side * side, cell * cell);
  for (int j = 0; j < side; ++j) {
    const std::size_t row = std::size_t(j * side);
    for (int i = 0; i < side; ++i) to.x[row + std::size_t(i)] = middle(i);
    std::fill_n(&to.y[row], side, middle(j));
  }
}

}  // namespace mien
