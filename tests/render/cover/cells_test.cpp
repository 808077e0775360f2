#include "render/cover/cells.h"
#include "sdf/arrange/piece_place.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/random/random_piece.h"

namespace mien::test {
namespace {

constexpr int kWidth = 12;

using Cells = std::map<std::pair<int, int>, CellStretch>;  // by row and column

Cells cells(const OutlinePiece& p, double top, double bottom) {
  Cells found;
  cells_of(p, top, bottom, kWidth, [&](const CellStretch& c) {
    const bool is_new = found.try_emplace({c.row, c.column}, c).second;
    EXPECT_TRUE(is_new) << "a cell told twice: " << c.row << ", " << c.column;
  });
  return found;
}

/// What lies right of the piece in a pixel, between two heights, by thin slices.
double area_by_slices(const OutlinePiece& p, int column, double top, double bottom) {
  constexpr int kSlices = 20'000;
  const double h = (bottom - top) / kSlices;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i)
    sum += h * std::clamp(column + 1.0 - x_at(p, top + (i + 0.5) * h), 0.0, 1.0);
  return sum;
}

/// Per row: each pixel's area is the cells' own, and all heights of those left of it.
void expect_areas(const OutlinePiece& p, double top, double bottom, double tolerance) {
  const Cells found = cells(p, top, bottom);
  for (int row = int(std::floor(top)); row < bottom; ++row) {
    const double from = std::max(top, double(row)), to = std::min(bottom, row + 1.0);
    double left = 0.0;
    if (const auto at = found.find({row, -1}); at != found.end()) {
      EXPECT_EQ(at->second.area, at->second.yq - at->second.yp);
      left = at->second.area;
    }
    for (int column = 0; column < kWidth; ++column) {
      double area = left;
      if (const auto at = found.find({row, column}); at != found.end()) {
        area += at->second.area, left += at->second.yq - at->second.yp;
        EXPECT_LE(at->second.yp, at->second.yq);
        EXPECT_GE(at->second.yp, from - 1e-12);
        EXPECT_LE(at->second.yq, to + 1e-12);
      }
      ASSERT_NEAR(area, area_by_slices(p, column, from, to), tolerance) << row << ", " << column;
    }
  }
}

TEST(Cells, AreasAreThoseOfThinSlices) {
  Random r(1);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const OutlinePiece p = random_piece(r, kWidth);
    expect_areas(p, p.y0, p.y1, 1e-4);
    if (HasFailure()) return;
  }
}

TEST(Cells, APartOfAPieceIsCutAtItsHeights) {
  Random r(2);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const OutlinePiece p = random_piece(r, kWidth);
    const double a = r.between(p.y0, p.y1), b = r.between(p.y0, p.y1);
    if (a == b) continue;
    expect_areas(p, std::min(a, b), std::max(a, b), 1e-4);
    if (HasFailure()) return;
  }
}

TEST(Cells, WhatIsLeftOfThePictureCountsForAllItsRow) {
  expect_areas(piece_between({-5, 1}, {4, 7}, 0.2, 0.8), 1, 7, 1e-4);
  expect_areas(piece_between({4, 1.5}, {-5, 6.25}, 0.9, 0.3), 1.5, 6.25, 1e-4);
  const Cells outside = cells(piece_between({-5, 1}, {-3, 4}), 1, 4);
  ASSERT_EQ(outside.size(), 3u);
  for (const auto& [at, cell] : outside) EXPECT_EQ(at.second, -1);
}

TEST(Cells, WhatIsRightOfThePictureIsLeftOut) {
  EXPECT_TRUE(cells(piece_between({kWidth + 0.5, 0}, {kWidth + 9.0, 5}), 0, 5).empty());
  EXPECT_TRUE(cells(piece_between({kWidth, 0}, {kWidth, 5}), 0, 5).empty());
  expect_areas(piece_between({kWidth - 3.0, 0}, {kWidth + 4.0, 5}, 0.7, 0.1), 0, 5, 1e-4);
}

TEST(Cells, PiecesAlongPixelBordersAreExact) {
  for (const double x : {0.0, 3.0, double(kWidth) - 1}) {
    expect_areas(piece_between({x, 1}, {x, 5}), 1, 5, 1e-12);
    expect_areas(piece_between({x, 1.25}, {x, 1.75}), 1.25, 1.75, 1e-12);
  }
  expect_areas(piece_between({2, 1}, {6, 5}), 1, 5, 1e-4);  // from corner to corner
  expect_areas(piece_between({6, 1}, {2, 5}), 1, 5, 1e-4);
}

TEST(Cells, AllButLevelPiecesCrossManyColumns) {
  for (const double height : {1e-3, 1e-9, 0x1p-20}) {
    const OutlinePiece p = piece_between({0.5, 2.25}, {kWidth - 0.5, 2.25 + height}, 0.3, 0.6);
    expect_areas(p, p.y0, p.y1, 1e-4 * height + 1e-15);
  }
}

TEST(Cells, PiecesThatStartOrEndLevelAreExact) {
  expect_areas(piece_between({1, 1}, {9, 4}, 0.5, 0.0), 1, 4, 1e-4);
  expect_areas(piece_between({1, 1}, {9, 4}, 0.5, 1.0), 1, 4, 1e-4);
  expect_areas(piece_between({9, 1}, {1, 4}, 0.0, 0.5), 1, 4, 1e-4);
  expect_areas(piece_between({9, 1}, {1, 4}, 1.0, 0.5), 1, 4, 1e-4);
}

TEST(Cells, HeightsOfARowSumToIt) {
  Random r(3);
  for (int i = 0; i < 500; ++i) {
    OutlinePiece p = random_piece(r, kWidth);
    std::map<int, double> heights;
    for (const auto& [at, cell] : cells(p, p.y0, p.y1)) heights[at.first] += cell.yq - cell.yp;
    for (const auto& [row, height] : heights)
      ASSERT_NEAR(height, std::min(p.y1, row + 1.0) - std::max(p.y0, double(row)), 1e-12) << i;
  }
}

}  // namespace
}  // namespace mien::test
