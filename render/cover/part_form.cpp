#include "render/cover/part_form.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr int kMostChords = 24;   // leave 2e-4 px² for bulges up to 0.17 px
constexpr float kNoArea = 1e-6f;  // [px²] what rounding leaves of an empty area

/// As many chords as leave less than 2e-4 px² between them and the parabola: with a bulge b in the middle, k chords leave
/// 2/3 b / k².
template <class Add>
void for_each_chord(const PartStretch& s, Add add) {
  const float bulge = std::abs(s.xm - 0.5f * (s.xp + s.xq)) + std::abs(s.ym - 0.5f * (s.yp + s.yq));
  const int chords = std::clamp(int(std::ceil(std::sqrt(3300.0f * bulge))), 1, kMostChords);
  float x = s.xp, y = s.yp;
  for (int i = 1; i < chords; ++i) {
    const float t = float(i) / float(chords), p = (1.0f - t) * (1.0f - 2.0f * t),
                m = 4.0f * t * (1.0f - t), q = t * (2.0f * t - 1.0f);
    const float to_x = std::clamp(p * s.xp + m * s.xm + q * s.xq, 0.0f, 1.0f);
    const float to_y = std::clamp(p * s.yp + m * s.ym + q * s.yq, y, s.yq);
    add(PartChord{x, y, to_x, to_y, s.sign});
    x = to_x, y = to_y;
  }
  add(PartChord{x, y, s.xq, s.yq, s.sign});
}

/// Sums of a form's cells: areas and first moments about their middles, and what fills all cells from a
/// column on.
struct CellSums {
  static constexpr int kMostSide = PartCells::kMostSide;
  int side;
  float cell;
  float area[kMostSide][kMostSide], mx[kMostSide][kMostSide], my[kMostSide][kMostSide];
  float from[kMostSide][kMostSide + 1], from_y[kMostSide][kMostSide + 1];

  explicit CellSums(int n) : side(n), cell(1.0f / float(n)) {
    for (int j = 0; j < n; ++j) {
      std::fill_n(area[j], n, 0.0f), std::fill_n(mx[j], n, 0.0f), std::fill_n(my[j], n, 0.0f);
      std::fill_n(from[j], n + 1, 0.0f), std::fill_n(from_y[j], n + 1, 0.0f);
    }
  }

  void add_left(const PartEntry& left);
  void add_chord(float xp, float yp, float xq, float yq, float sign);
  void add_in_row(int row, float xp, float yp, float xq, float yq, float sign);
  void add_in_cell(int row, int column, float xp, float yp, float xq, float yq, float sign);
};

void CellSums::add_left(const PartEntry& left) {
  const int rows = PartEntry::kRows / side;
  std::size_t k = 0;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < rows; ++i, ++k) {
      const float y = (float(i) + 0.5f) / PartEntry::kRows - 0.5f * cell, height = left.height[k];
      from[j][0] += height, from_y[j][0] += height * y + left.moment[k];
    }
}

void CellSums::add_chord(float xp, float yp, float xq, float yq, float sign) {
  if (!(yq > yp)) return;
  const float n = float(side), slope = (xq - xp) / (yq - yp);
  const int last = std::clamp(int(yq * n), 0, side - 1);
  for (int row = std::clamp(int(yp * n), 0, side - 1); row <= last; ++row) {
    const float top = std::max(yp, float(row) * cell),
                bottom = row == last ? yq : std::min(yq, float(row + 1) * cell);
    if (!(bottom > top)) continue;
    const auto x_at = [&](float y) { return std::clamp(xp + slope * (y - yp), 0.0f, 1.0f); };
    add_in_row(row, top == yp ? xp : x_at(top), top, bottom == yq ? xq : x_at(bottom), bottom,
               sign);
  }
}

void CellSums::add_in_row(int row, float xp, float yp, float xq, float yq, float sign) {
  const float n = float(side);
  const auto column_of = [&](float x) { return std::clamp(int(x * n), 0, side - 1); };
  const int last = column_of(xq), step = xq > xp ? 1 : -1;
  int column = column_of(xp);
  const float rate = xq != xp ? (yq - yp) / (xq - xp) : 0.0f;
  float x = xp, y = yp;
  for (; column != last; column += step) {
    const float border = float(step > 0 ? column + 1 : column) * cell;
    const float at = std::clamp(yp + rate * (border - xp), y, yq);
    add_in_cell(row, column, x, y, border, at, sign);
    x = border, y = at;
  }
  add_in_cell(row, column, x, y, xq, yq, sign);
}

/// With u, v from the cell's middle and its half side s the stretch leaves to its right s − u over dv: so much
/// area, and moments (s² − u²)/2 and v (s − u).
void CellSums::add_in_cell(int row, int column, float xp, float yp, float xq, float yq,
                           float sign) {
  const float s = 0.5f * cell, h = sign * (yq - yp);
  const float x = (float(column) + 0.5f) * cell, y = (float(row) + 0.5f) * cell;
  const float up = xp - x, uq = xq - x, u = 0.5f * (up + uq), v = 0.5f * (yp + yq) - y;
  area[row][column] += h * (s - u);
  mx[row][column] += 0.5f * h * (s * s - (up * up + up * uq + uq * uq) * (1.0f / 3));
  my[row][column] += h * (v * (s - u) - (uq - up) * (yq - yp) * (1.0f / 12));
  from[row][column + 1] += h, from_y[row][column + 1] += h * v;
}

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

/// What enters by a thirty-second is one chord around its middle; those that are full make longer ones.
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
    for_each_chord(s, [&](const PartChord& c) {
      if (c.yq > c.yp) to.push_back(c);
    });
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

void cells_of_form(const PartForm& form, int side, PartCells& to) {
  whole_cells(side, to);
  CellSums sums(side);
  sums.add_left(form.left);
  for (const PartStretch& s : form.stretches)
    for_each_chord(s, [&](const PartChord& c) { sums.add_chord(c.xp, c.yp, c.xq, c.yq, c.sign); });
  const float cell = sums.cell, half = 0.5f * cell;
  float height[PartCells::kMostSide], height_y[PartCells::kMostSide];  // of what fills each cell
  for (int j = 0; j < side; ++j) {
    height[0] = sums.from[j][0], height_y[0] = sums.from_y[j][0];
    for (int i = 1; i < side; ++i) {
      height[i] = height[i - 1] + sums.from[j][i];
      height_y[i] = height_y[i - 1] + sums.from_y[j][i];
    }
    float* const areas = &to.area[std::size_t(j * side)];
    float* const xs = &to.x[std::size_t(j * side)];
    float* const ys = &to.y[std::size_t(j * side)];
    for (int i = 0; i < side; ++i) {
      const float area = sums.area[j][i] + height[i] * cell;
      const bool any = area > kNoArea;
      const float over = any ? area : 1.0f;
      areas[i] = any ? area : 0.0f;
      const float x = std::clamp(sums.mx[j][i] / over, -half, half),
                  y = std::clamp((sums.my[j][i] + height_y[i] * cell) / over, -half, half);
      xs[i] += any ? x : 0.0f, ys[i] += any ? y : 0.0f;
    }
  }
}

}  // namespace mien
