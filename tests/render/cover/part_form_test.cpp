#include "render/cover/part_form.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/random/random.h"

namespace mien {
namespace {

/// Right of a chord from (a, 0) to (b, 1), by very many places.
struct Counted {
  std::vector<double> area, x, y;

  Counted(int side, float a, float b)
      : area(std::size_t(side * side)), x(std::size_t(side * side)), y(std::size_t(side * side)) {
    constexpr int kRows = 4096;
    for (int k = 0; k < kRows; ++k) {
      const double v = (k + 0.5) / kRows, cut = a + (b - a) * v;
      for (int i = 0; i < side; ++i) {
        const double left = std::max(cut, double(i) / side), right = double(i + 1) / side;
        if (left >= right) continue;
        const auto c = std::size_t(int(v * side) * side + i);
        const double w = (right - left) / kRows;
        area[c] += w, x[c] += w * (0.5 * (left + right) - 0.5), y[c] += w * (v - 0.5);
      }
    }
  }
};

TEST(PartForm, GivesCellsTheirAreasAndCentroids) {
  test::Random random(5);
  for (int k = 0; k < 60; ++k) {
    const int side = 4 << k % 3;
    const float a = float(random.between(0, 1)), b = float(random.between(0, 1)),
                m = 0.5f * (a + b);
    const PartStretch stretch{a, 0, m, 0.5f, b, 1, 1};
    PartCells cells;
    cells_of_form({.stretches = {&stretch, 1}}, side, cells);
    const Counted want(side, a, b);
    for (std::size_t c = 0; c < std::size_t(cells.count()); ++c) {
      EXPECT_NEAR(cells.area[c], want.area[c], 2e-5);
      if (want.area[c] < 1e-3) continue;
      EXPECT_NEAR(cells.x[c], want.x[c] / want.area[c], 1e-3);
      EXPECT_NEAR(cells.y[c], want.y[c] / want.area[c], 1e-3);
    }
  }
}

/// Squares of a 64th and a 128th, one by one, have together what the cell of a thirty-second has: areas and moments, of
/// what enters from the left, too.
TEST(PartForm, GivesSmallSquaresWhatTheirCellHas) {
  test::Random random(6);
  for (int k = 0; k < 200; ++k) {
    const float a = float(random.between(0, 1)), b = float(random.between(0, 1));
    const float top = float(random.between(0, 0.4)), bottom = float(random.between(0.6, 1));
    const float m = 0.5f * (a + b) + float(random.between(-0.1, 0.1));
    const PartStretch stretch{a, top, m, 0.5f * (top + bottom), b, bottom, k % 2 ? -1.0f : 1.0f};
    PartForm form{.stretches = {&stretch, 1}};
    if (k % 2) form.left.add({0, 0.01f, 0, 0.5f, 0, 0.99f, 1});
    PartCells cells;
    cells_of_form(form, 32, cells);
    const std::size_t cell = std::size_t(random.below(1024));
    const int by = 2 << k % 2;  // and each way
    PartSquares squares;
    squares.side = 1.0f / float(32 * by);
    for (std::size_t i = 0; i < PartSquares::kCount; ++i) {
      squares.left[i] = float(cell % 32) / 32 + float(int(i) % by) * squares.side;
      squares.top[i] = float(cell / 32) / 32 + float(int(i) / by % by) * squares.side;
    }
    squares_of_form(form, squares);
    double area = 0, x = 0, y = 0;
    for (std::size_t i = 0; i < std::size_t(by * by); ++i) {
      area += squares.area[i];
      x += squares.area[i] * squares.x[i], y += squares.area[i] * squares.y[i];
    }
    EXPECT_NEAR(area, cells.area[cell], 3e-6) << k;
    EXPECT_NEAR(x, cells.area[cell] * cells.x[cell], 3e-6) << k;
    EXPECT_NEAR(y, cells.area[cell] * cells.y[cell], 3e-6) << k;
  }
}

TEST(PartForm, IsWhatEntersFromTheLeftLessWhatStretchesTake) {
  const PartStretch entry{0.3f, 0.25f, 0.4f, 0.5f, 0.5f, 0.75f, 1};
  PartEntry left;
  left.add(entry);
  float height = 0;
  for (const float h : left.height) height += h;
  EXPECT_FLOAT_EQ(height, 0.5f);
  EXPECT_EQ(left.height[7], 0);
  EXPECT_FLOAT_EQ(left.height[8], 1.0f / 32);
  PartStretch exit = entry;
  exit.sign = -1;
  PartCells cells;
  cells_of_form({left, {&exit, 1}}, 8, cells);  // beside it, the same outline again
  const PartCells& whole = whole_cells(8);
  double area = 0;
  for (std::size_t c = 0; c < 64; ++c) {
    area += double(cells.area[c]);
    EXPECT_LE(cells.area[c], whole.area[c] + 1e-6f);
  }
  EXPECT_NEAR(area, 0.5 * 0.4, 1e-6);
  EXPECT_EQ(cells.area[0], 0);
  EXPECT_FLOAT_EQ(cells.area[16], 1.0f / 64);
}

/// Outlines seldom enter a pixel at a thirty-second of its height.
TEST(PartForm, KnowsWhereInACellAnEntryBegins) {
  const float top = 10.3f / 32;
  const PartStretch before{0.5f, top, 0.5f, 0.5f * (top + 1), 0.5f, 1, 1};
  PartEntry left;
  left.add(before);
  for (const int side : {4, 8, 16, 32}) {
    PartCells cells;
    cells_of_form({left, {}}, side, cells);
    const auto first = std::size_t(int(top * float(side)) * side);
    const float bottom = std::floor(top * float(side) + 1) / float(side);
    EXPECT_NEAR(cells.area[first], (bottom - top) / float(side), 1e-6) << side;
    EXPECT_NEAR(cells.y[first], 0.5f * (top + bottom) - 0.5f, 1e-5) << side;
  }
}

/// Of a bulge of a seventh of a pixel, as tips of strokes in small pictures have.
TEST(PartForm, FollowsAStrongBend) {
  const PartStretch bow{0.2f, 0, 0.34f, 0.5f, 0.2f, 1, 1};
  PartCells cells;
  cells_of_form({{}, {&bow, 1}}, 8, cells);
  double area = 0;
  for (int k = 0; k < cells.count(); ++k) area += double(cells.area[std::size_t(k)]);
  EXPECT_NEAR(area, 0.8 - 2.0 / 3 * 0.14, 2e-4);
}

}  // namespace
}  // namespace mien
