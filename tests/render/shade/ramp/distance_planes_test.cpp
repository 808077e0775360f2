#include "render/shade/ramp/distance_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

// Round a point the gradient turns all about, so no cell that holds it has a plane: only its neighbours tell.
TEST(DistancePlanes, HaveTheMeanRoundAPoint) {
  SceneBuilder build({.box = {{0, 0}, {20, 20}}, .y_up = false}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{10.4, 10.45}, 5});
  std::vector<Stop> stops;
  for (int i = 0; i <= 50; ++i) stops.push_back({i / 50.0, {i * i / 2500.0, 0, 0, 1}});
  build.layer("all", build.everywhere(),
              {.color = {0, 0, 0, 1},
               .gradient = shared(Gradient{DistanceGradient{disc, -6, 6}, stops, Extend::pad})});
  PaintTable table;
  table.make(std::move(build).finish(), {.width = 20, .height = 20}, Depth::u16);
  const VariedPaint& varied = table.varied.at(0);
  ASSERT_TRUE(varied.integral);
  RampSoftness soft;
  soft.make(varied, 1e-4);
  DistancePlanes planes;
  std::vector<RampPlane> cells;
  ASSERT_GT(planes.of(table.lit[std::size_t(varied.lit)].gradient_area(), 10, 10, 1, soft, cells),
            4);
  double sum = 0, counted = 0;
  for (const RampPlane& cell : cells) sum += cell.t / double(cells.size());
  constexpr int kSide = 400;
  for (int k = 0; k < kSide * kSide; ++k)
    counted += std::hypot((k % kSide + 0.5) / kSide - 0.4, (k / kSide + 0.5) / kSide - 0.45) - 5;
  EXPECT_NEAR(sum, counted / (kSide * kSide), soft.allowed());
}

}  // namespace
}  // namespace mien
