#include "render/shade/ramp/softness.h"
#include "render/shade/paint_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

/// Along the distance from a line, 20 px long in a picture of 10 px a unit; falls from 1 to 0.25 to 0.
RampSoftness soft(Extend extend, const std::vector<Stop>& stops, bool between_kinks = false) {
  SceneBuilder build({.box = {{0, 0}, {2, 2}}, .y_up = false}, {1, 1, 1, 1});
  const Area line = build.shape(HalfPlane{{1, 0}, 1});
  build.layer("all", build.everywhere(),
              {.color = {0, 0, 0, 1},
               .gradient = shared(Gradient{DistanceGradient{line, 0, 2}, stops, extend})});
  PaintTable table;
  table.make(std::move(build).finish(), {.width = 20, .height = 20, .blend = Blend::linear},
             Depth::u8);
  const GridPaint& paint = table.varied.at(0).paint;
  RampIntegral integral;
  integral.make(*paint.ramp);
  RampSoftness softness;
  softness.make(paint.field, integral, 0.01, between_kinks ? nullptr : &*paint.ramp);
  return softness;
}

const std::vector<Stop> kFalls{{0, {1, 1, 1, 1}}, {0.5, {0.25, 0.25, 0.25, 1}}, {1, {0, 0, 0, 1}}};

TEST(RampSoftness, AllowsAsMuchAsTheRampIsSoft) {
  EXPECT_NEAR(soft(Extend::pad, kFalls).allowed(), 0.01 / (1.5 / 20), 1e-9);
}

TEST(RampSoftness, CountsKinksWithinReachAsSharesOfTheSteepestSlope) {
  const RampSoftness softness = soft(Extend::pad, kFalls);
  EXPECT_NEAR(softness.turns(5, 4.9), 0, 1e-12);
  EXPECT_NEAR(softness.turns(5, 5.1), 1 + 2.0 / 3, 1e-9);
  EXPECT_NEAR(softness.turns(10.2, 0.3), 2.0 / 3, 1e-9);
  EXPECT_NEAR(softness.turns(20, 1), 1.0 / 3, 1e-9);
  EXPECT_NEAR(softness.turns(30, 5), 0, 1e-12);
  EXPECT_EQ(soft(Extend::pad, kFalls, true).turns(5, 5.1), 0);
  // Repeated, at least as many as there are.
  EXPECT_GE(soft(Extend::reflect, kFalls).turns(5, 30), 2 * (1 + 2.0 / 3));
}

TEST(RampSoftness, IsEndlessForJumps) {
  const std::vector<Stop> jumps{{0, {1, 1, 1, 1}}, {0.5, {0.5, 0.5, 0.5, 1}}, {0.5, {0, 0, 0, 1}}};
  EXPECT_EQ(soft(Extend::pad, jumps).turns(10, 1), HUGE_VAL);
}

}  // namespace
}  // namespace mien
