// Distances of cubic Béziers, in lanes, where they are hard.

#include <mien/distance.h>

#include <gtest/gtest.h>

#include <vector>

#include "sdf/distance/instruction_sets.h"
#include "tests/support/shapes/every_instruction_set.h"
#include "tools/accuracy/reference.h"
#include "tools/accuracy/tally.h"

namespace mien {
namespace {

/// The nearest of two feet, not proven in double lanes, was forgotten when the other one was proven.
TEST(CubicDistances, OfCurvesWithTwoFeetKeepBoth) {
  const accuracy::Case k{CubicBezier{{0.5063651204109192, 0.3398219347000122},
                                     {0.9191915392875671, 0.38563665747642517},
                                     {0.22635763883590698, 0.3015172779560089},
                                     {0.08159564435482025, 0.31240591406822205}},
                         {0.607609748840332, 0.3508329391479492}};
  for (const accuracy::Solver& s : accuracy::own_solvers()) {
    if (s.figure != k.figure.index()) continue;
    s.prepare();
    EXPECT_LE(accuracy::error_units(s.judge, true, k, accuracy::true_distance(k), s.solve(k)), 1)
        << s.name << ' ' << s.instruction_set;
  }
  batch::use_instruction_set(0);
}

/// Curves of every shape, points on a grid with the borders of pieces and the curve's own mirror on it.
TEST(CubicDistances, OfEveryShapeOnAGrid) {
  const CubicBezier curves[] = {
      {{0, 0}, {1, 1}, {0, 1}, {1, 0}},                  // a cusp
      {{0, 0}, {1.5, 1}, {-0.5, 1}, {1, 0}},             // a loop
      {{0, 0}, {1, 0}, {-1, 0}, {0.5, 0}},               // a line, gone over three times
      {{0, 0}, {0.25, 0}, {0.75, 0}, {1, 0}},            // a line
      {{0, 0}, {0.25, 0.25}, {0.5, 0.5}, {0.75, 0.75}},  // a line run at an even speed
      {{0, 0}, {0, 0}, {1, 1}, {1, 1}},                  // a line that starts and ends at rest
      {{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {0.5, 1}},
      {{0, 0}, {1.0 / 3, 2.0 / 3}, {2.0 / 3, 2.0 / 3}, {1, 0}},  // a parabola
      {{0.5, 0}, {1.5, 1}, {-0.5, 1}, {0.5, 0}},                 // closed
  };
  std::vector<float> x, y, f(33 * 33);
  for (int i = 0; i < 33 * 33; ++i) {
    x.push_back(float(i % 33) / 16 - 0.5f), y.push_back(float(i / 33) / 16 - 0.5f);
  }
  const std::vector<double> dx(x.begin(), x.end()), dy(y.begin(), y.end());
  std::vector<double> d(f.size());
  test::on_every_set([&] {
    for (const CubicBezier& curve : curves) {
      distances(curve, std::span<const float>(x), y, std::span<float>(f));
      distances(curve, std::span<const double>(dx), dy, std::span<double>(d));
      for (size_t i = 0; i < f.size(); ++i) {
        const double truth = distance(curve, {x[i], y[i]});
        ASSERT_NEAR(f[i], truth, 2 * 0x1p-23) << x[i] << ' ' << y[i];
        ASSERT_NEAR(d[i], truth, 16 * 0x1p-52) << x[i] << ' ' << y[i];
      }
    }
  });
}

}  // namespace
}  // namespace mien
