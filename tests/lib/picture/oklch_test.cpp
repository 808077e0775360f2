#include "lib/picture/oklch.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

TEST(Oklch, KnownColours) {
  // bottosson.github.io/posts/oklab: white, and sRGB's red at (0.628, 0.2577, 29.23), blue at (0.452, 0.3132, 264.05).
  EXPECT_EQ(hex_of({1, 0, 0}), "#ffffff");
  EXPECT_EQ(hex_of({0, 0, 0}), "#000000");
  EXPECT_EQ(hex_of({0.62796, 0.25768, 29.2339}), "#ff0000");
  EXPECT_EQ(hex_of({0.45201, 0.31321, 264.0520}), "#0000ff");
  EXPECT_EQ(hex_of({1, 0, 0}, 0.5), "#ffffff80");
  EXPECT_EQ(hex_of({1, 0, 0}, -0.5), "#ffffff00");
}

TEST(Oklch, WhatCannotBeShownKeepsItsLightness) {
  const std::string shown = hex_of({0.7, 0.4, 150});
  EXPECT_EQ(shown.size(), 7u);
  EXPECT_NE(shown, hex_of({0.7, 0.0, 150}));  // not grey
  EXPECT_EQ(shown, hex_of({0.7, 0.5, 150}));  // the edge of what can be shown
}

TEST(Oklch, LabAndBack) {
  const Oklch c{0.6, 0.1, -70};
  const Oklch back = Oklch::from_lab(c.lab());
  EXPECT_NEAR(back.chroma, 0.1, 1e-15);
  EXPECT_NEAR(back.hue, -70, 1e-12);
  EXPECT_NEAR(apart(c, {0.6, 0.1, 110}), 0.2, 1e-15);
}

}  // namespace
}  // namespace mien
