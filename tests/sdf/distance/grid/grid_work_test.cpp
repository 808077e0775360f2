#include "sdf/distance/grid/grid_work.h"
#include <mien/distance.h>

#include <gtest/gtest.h>

#include "sdf/distance/instruction_sets.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace mien::batch {
namespace {

/// The largest error over the grid, in the fast kernel's units.
double worst_error(const QuadBezier& c, const Grid& g, const std::vector<float>& d) {
  const double size =
      std::max({std::abs(c.p0.x - c.p1.x), std::abs(c.p1.x - c.p2.x), std::abs(c.p0.x - c.p2.x),
                std::abs(c.p0.y - c.p1.y), std::abs(c.p1.y - c.p2.y), std::abs(c.p0.y - c.p2.y)});
  double worst = 0;
  for (size_t k = 0; k < d.size(); ++k) {
    const float x = float(g.origin.x + double(k % g.columns) * g.step);
    const float y = float(g.origin.y + double(k / g.columns) * g.step);
    const double truth = distance(c, {x, y});
    const float near = float(truth);
    const double ulp = double(std::nextafter(near, INFINITY)) - double(near);
    worst = std::max(worst, std::abs(double(d[k]) - truth) / std::max(0x1p-23 * size, ulp));
  }
  return worst;
}

TEST(GridWork, KeepsTheFastKernelsBoundOnEveryInstructionSetAndProvesMostTiles) {
  for (const auto& set : instruction_sets()) {
    SCOPED_TRACE(set.name);
    use_instruction_set(set.id);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<float> unit(0, 1);
    size_t tiles = 0, certified = 0;
    double worst = 0;
    for (int trial = 0; trial < 40; ++trial) {
      const auto any = [&] { return glm::dvec2{unit(random), unit(random)}; };
      const QuadBezier c{any(), any(), any()};
      const Grid g{any() - 0.1, (trial % 4 + 1) / 2048.0, 53, trial % 3 ? size_t{37} : size_t{29}};
      std::vector<float> d(g.columns * g.rows, -1);
      certified += distances_on_grid(c, g, d);
      tiles += trial % 3 ? 12 : 8;
      worst = std::max(worst, worst_error(c, g, d));
    }
    EXPECT_LE(worst, DistancesContract::kFastError);
    EXPECT_GE(double(certified), 0.75 * double(tiles));
  }
  use_instruction_set(0);
}

/// Certificates in lanes: strips of 3 to 22 tiles.
TEST(GridWork, TallGridsKeepTheBoundToo) {
  for (const auto& set : instruction_sets()) {
    SCOPED_TRACE(set.name);
    use_instruction_set(set.id);
    std::mt19937_64 random(2);
    std::uniform_real_distribution<float> unit(0, 1);
    size_t certified = 0;
    double worst = 0;
    for (int trial = 0; trial < 20; ++trial) {
      const auto any = [&] { return glm::dvec2{unit(random), unit(random)}; };
      const QuadBezier c{any(), any(), any()};
      const Grid g{any(), 1 / 1024.0, 16, 16 * size_t(3 + trial)};
      std::vector<float> d(g.columns * g.rows, -1);
      certified += distances_on_grid(c, g, d);
      worst = std::max(worst, worst_error(c, g, d));
    }
    EXPECT_LE(worst, DistancesContract::kFastError);
    EXPECT_GE(certified, 250u * 2 / 3);  // of 250 tiles
  }
  use_instruction_set(0);
}

TEST(GridWork, AnyStepOfAnySignAndAnyShapeOfGrid) {
  const QuadBezier c{{0.1, 0.2}, {0.8, 1.1}, {0.9, -0.4}};
  for (const double step : {1e-9, 0.01, -0.003, 0.4, 7.0, 0.0})
    for (const auto& [columns, rows] :
         {std::pair<size_t, size_t>{1, 1}, {16, 16}, {17, 1}, {1, 33}}) {
      const Grid g{{0.3, 0.4}, step, columns, rows};
      std::vector<float> d(columns * rows, -1);
      distances_on_grid(c, g, d);
      EXPECT_LE(worst_error(c, g, d), DistancesContract::kFastError) << step << ' ' << columns;
    }
}

TEST(GridWork, DegenerateCurvesAndNonsense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const QuadBezier dot{{3, 0}, {3, 0}, {3, 0}}, line{{-1, 0}, {0, 0}, {1, 0}};
  std::vector<float> d(400);
  mien::distances_on_grid(dot, {0, 0}, 1, 20, 20, d);
  EXPECT_EQ(d[0], 3);
  EXPECT_EQ(d[20 * 4 + 3], 4);
  mien::distances_on_grid(line, {-0.5, 0}, 0.001, 20, 20, d);
  EXPECT_FLOAT_EQ(d[20 * 7 + 3], 0.007f);
  mien::distances_on_grid(dot, {nan, 0}, 1, 20, 20, d);
  EXPECT_EQ(d[5], INFINITY);
  mien::distances_on_grid(line, {0, 0}, nan, 20, 20, d);
  EXPECT_EQ(d[5], INFINITY);
  mien::distances_on_grid(line, {0, 0}, 1, 0, 20, std::span<float>(d).first(0));
}

#ifdef NDEBUG  // else an assertion ends the program
TEST(GridWork, ASpanOfAnotherSizeIsLeftAlone) {
  std::vector<float> d(399, -7);
  mien::distances_on_grid({}, {0, 0}, 1, 20, 20, d);
  EXPECT_EQ(d, std::vector<float>(399, -7));
}
#endif

}  // namespace
}  // namespace mien::batch
