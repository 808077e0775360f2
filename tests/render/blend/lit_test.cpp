#include "render/blend/lit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

constexpr Mix kGrey{0.4, 0.4, 0.4, 1};

TEST(Lamp, LeavesALevelSurfaceAsItIs) {  // G3
  const Lamp lamp({.direction = {0.3, -0.7, 0.5}, .ambient = 0.2}, 0.8, 40);
  const Mix odd{0.123, 0.456, 0.0789, 0.5};
  for (const Blend blend : {Blend::linear, Blend::srgb})
    EXPECT_EQ(lamp.lit(odd, {0, 0}, blend), odd);
}

TEST(Lamp, FollowsItsLaw) {  // G3
  const glm::dvec3 to_lamp{0.48, 0.6, 0.64};
  const Lamp lamp({.direction = to_lamp, .ambient = 0.25}, 0, 30);
  const double length = std::sqrt(1 + 0.09 + 0.04);
  const double facing = (0.64 + 0.3 * 0.48 - 0.2 * 0.6) / length;  // n = (0.3, −0.2, 1) / length
  EXPECT_NEAR(lamp.lit(kGrey, {-0.3, 0.2}, Blend::linear).r, 0.4 * (0.25 + 0.75 * facing / 0.64),
              1e-15);
}

TEST(Lamp, OnTheOtherSideMirrorsTheLight) {  // G3
  const Lamp left({.direction = {-0.5, 0.4, 0.7}}, 0.6, 20),
      right({.direction = {0.5, 0.4, 0.7}}, 0.6, 20);
  for (const double x : {-2.0, -0.3, 0.1, 0.8})
    for (const double y : {-0.6, 0.0, 1.5})
      EXPECT_EQ(left.lit(kGrey, {x, y}, Blend::linear), right.lit(kGrey, {-x, y}, Blend::linear));
}

TEST(Lamp, ShinesMostHalfwayBetweenItselfAndTheViewer) {
  const Lamp lamp({.direction = {0.6, 0, 0.8}, .ambient = 1}, 0.5, 30);  // halfway: (0.3, 0, 0.9)·k
  const double best = lamp.lit(kGrey, {-1.0 / 3, 0}, Blend::linear).r;
  EXPECT_NEAR(best, 0.4 + 0.5, 1e-12);
  EXPECT_LT(lamp.lit(kGrey, {-0.2, 0}, Blend::linear).r, best);
  EXPECT_LT(lamp.lit(kGrey, {-0.5, 0}, Blend::linear).r, best);
}

TEST(Lamp, FromBehindShinesStraightOn) {
  const Lamp behind({.direction = {1, 0, -1}}, 0, 30), front({.direction = {0, 0, 1}}, 0, 30);
  EXPECT_EQ(behind.lit(kGrey, {0.5, 0.1}, Blend::linear),
            front.lit(kGrey, {0.5, 0.1}, Blend::linear));
}

TEST(Lamp, WorksInLinearLightWhateverIsBlended) {
  const Lamp lamp({}, 0.3, 10);
  const Color color{0.2, 0.5, 0.7, 0.6};
  const Mix linear = lamp.lit(mix_from_color(color, Blend::linear), {0.4, 0.3}, Blend::linear);
  const Mix srgb = lamp.lit(mix_from_color(color, Blend::srgb), {0.4, 0.3}, Blend::srgb);
  const Color back{linear.r / 0.6, linear.g / 0.6, linear.b / 0.6, 0.6};
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mix_from_color(back, Blend::srgb)[i], srgb[i], 1e-9);
}

}  // namespace
}  // namespace mien
