#include "render/cover/row_roots.h"
#include "render/cover/cells.h"
#include "sdf/arrange/piece_place.h"

#include <gtest/gtest.h>

#include "tests/support/random/random_piece.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::test {
namespace {

TEST(RowRoots, AreWhereThePieceMeetsItsEndsAndTheBordersBetweenOnEverySet) {
  on_every_set([] {
    Random r(3);
    for (int i = 0; i < 2000; ++i) {
      OutlinePiece p = random_piece(r, 12);
      if (!(p.y1 > p.y0)) continue;
      const double shift = 40.0 - std::floor(p.y0);
      p.y0 += shift, p.y1 += shift;
      p.x0 -= 2, p.x1 -= 2;
      const double top = p.y0 + r.between(0, 0.3) * (p.y1 - p.y0),
                   bottom = top + r.between(0.1, 1.0) * (p.y1 - top);
      const int first = int(top), rows = std::min(int(std::ceil(bottom)) - first, RowRoots::kRows);
      const double end = std::min(bottom, double(first + rows));
      RowRoots at;
      row_roots(p, {top, end, first, rows, 9}, at);
      for (int k = 0; k <= rows; ++k) {
        const double y = k == 0 ? top : k == rows ? end : first + k, t = parameter_at(p, y);
        ASSERT_NEAR(at.t[std::size_t(k)], t, 1e-9) << i;
        ASSERT_NEAR(at.x[std::size_t(k)], x_of(p, t), 1e-9) << i;
        const double x = at.x[std::size_t(k)];
        ASSERT_EQ(at.column[std::size_t(k)], x < 0 ? -1 : x >= 9 ? 9 : int(x)) << x;
      }
    }
  });
}

TEST(RowRoots, TellTheCellsOfRowsThatMeetOneBorderAsTheyAreTold) {
  on_every_set([] {
    Random r(5);
    int alone = 0, two = 0;
    for (int i = 0; i < 2000; ++i) {
      OutlinePiece p = random_piece(r, 12);
      p.x0 -= 2, p.x1 -= 2, p.y0 += 20, p.y1 += 20;
      if (!(p.y1 > p.y0)) continue;
      ranges_of(p.y0, p.y1, 9, [&](const RowRange& range) {
        RowRoots at;
        row_roots(p, range, at, true);
        for (int k = 0; k < range.rows; ++k) {
          const RowStretch s = row_stretch(range, at, k);
          if (std::abs(s.last - s.column) > 1) continue;
          ++(s.last == s.column ? alone : two);
          const auto row = std::size_t(k);
          cells_of_row(p, s, 9, [&](const CellStretch& c) {
            const RowRoots::Cells& cells = c.column == s.column ? at.first : at.second;
            ASSERT_EQ(cells.part(row).area, float(c.area)) << i;
            ASSERT_EQ(cells.part(row).height, float(c.yq - c.yp)) << i;
            const PartStretch in = cells.stretch(row);
            const auto held = [&](double at_x) {  // left of the picture at the border
              return c.column < 0 ? 0.0f : std::clamp(float(at_x - c.column), 0.0f, 1.0f);
            };
            const auto along = [&](double at_y) { return float(at_y - c.row); };
            ASSERT_EQ(in.xp, held(c.xp)) << i;
            ASSERT_EQ(in.xm, held(c.xm)) << i;
            ASSERT_EQ(in.xq, held(c.xq)) << i;
            ASSERT_EQ(in.yp, along(c.yp)) << i;
            ASSERT_EQ(in.ym, along(c.ym)) << i;
            ASSERT_EQ(in.yq, along(c.yq)) << i;
            ASSERT_EQ(in.sign, 1.0f);
          });
        }
      });
    }
    EXPECT_GT(alone, 1000);
    EXPECT_GT(two, 500);
  });
}

TEST(RowRoots, OneRowAloneIsAsInLanes) {
  on_every_set([] {
    Random r(6);
    for (int i = 0; i < 2000; ++i) {
      OutlinePiece p = random_piece(r, 3);
      p.x0 -= 2, p.x1 -= 2;
      const double top = std::max(p.y0, 0.0), bottom = std::min(p.y1, 1.0);
      if (!(bottom > top)) continue;
      const RowRange range{top, bottom, 0, 1, 2};
      const RowStretch alone = row_stretch(p, range);
      RowRoots at;
      row_roots(p, range, at);
      ASSERT_EQ(alone.t, at.t[0]) << i;
      ASSERT_EQ(alone.next_t, at.t[1]) << i;
      ASSERT_EQ(alone.x, at.x[0]) << i;
      ASSERT_EQ(alone.next_x, at.x[1]) << i;
      ASSERT_EQ(alone.column, at.column[0]) << i;
      ASSERT_EQ(alone.last, at.column[1]) << i;
    }
  });
}

}  // namespace
}  // namespace mien::test
