#include "render/cover/part_form.h"
#include "render/cover/part_chords.h"

#include <algorithm>

namespace mien {
namespace {

constexpr float kNoArea = 1e-6f;  // [px²] what rounding leaves of an empty area

}  // namespace

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

void chords_of_form(const PartForm& form, std::vector<PartChord>& to) {
  constexpr float kRow = 1.0f / PartEntry::kRows;
  to.clear();
  bool goes_on = false;
  for (int k = 0; k < PartEntry::kRows; ++k) {
    const float height = form.left.height[std::size_t(k)], top = float(k) * kRow;
    const bool full = std::abs(height - kRow) < kNoArea;
    if (full && goes_on) {
      to.back().yq = top + kRow;
    } else if (std::abs(height) > kNoArea) {
      const float half = full ? 0.5f * kRow : 0.5f * std::min(std::abs(height), kRow),
                  middle =
                      top + 0.5f * kRow + (full ? 0.0f : form.left.moment[std::size_t(k)] / height);
      to.push_back({0.0f, middle - half, 0.0f, middle + half, 0.5f * height / half});
    }
    goes_on = full;
  }
  for (const PartStretch& s : form.stretches)
    for_each_chord(s, kFineChords, [&](const PartChord& c) {
      if (c.yq > c.yp) to.push_back(c);
    });
}

namespace {

PartCells cells_of_whole(int side) {
  PartCells made;
  made.side = side;
  const float cell = made.cell();
  for (int k = 0; k < side * side; ++k) {
    const auto at = std::size_t(k);
    made.area[at] = cell * cell;
    made.x[at] = (float(k % side) + 0.5f) * cell - 0.5f;
    made.y[at] = (float(k / side) + 0.5f) * cell - 0.5f;
  }
  return made;
}

}  // namespace

const PartCells& whole_cells(int side) {
  static const std::array<PartCells, 6> made{cells_of_whole(1),  cells_of_whole(2),
                                             cells_of_whole(4),  cells_of_whole(8),
                                             cells_of_whole(16), cells_of_whole(32)};
  return *std::find_if(made.begin(), made.end(),
                       [&](const PartCells& cells) { return cells.side == side; });
}

}  // namespace mien
