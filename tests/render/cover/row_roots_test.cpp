#include <mien/render/cover/row_roots.h>
#include <mien/sdf/arrange/sweep_piece.h>

#include <gtest/gtest.h>

#include "tests/support/every_instruction_set.h"
#include "tests/support/random_piece.h"

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

}  // namespace
}  // namespace mien::test
