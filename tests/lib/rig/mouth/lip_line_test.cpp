#include "lib/rig/mouth/lip_line.h"

#include <gtest/gtest.h>

namespace mien {
namespace {

constexpr MouthMeasures kMeasures{0.2, 1, 0.32};

LipLine resting() {
  return {.corners = {{{0.2, 0}, {-0.2, 0}}},
          .upper = {{{0.1, -0.02}, {0, -0.01}, {-0.1, -0.02}}},
          .lower = {{{0.1, -0.02}, {0, -0.01}, {-0.1, -0.02}}},
          .has_handles = true};
}

LipLine shaped(const MouthNumbers& n, const std::optional<TeethEdge>& teeth = {}) {
  LipLine line = resting();
  shape_lips(n, kMeasures, teeth, line);
  return line;
}

void expect_mirrored(const LipLine& line) {
  const auto image = [](glm::dvec2 p) { return glm::dvec2(-p.x, p.y); };
  EXPECT_EQ(line.corners[0], image(line.corners[1]));
  EXPECT_EQ(line.upper[0], image(line.upper[2]));
  EXPECT_EQ(line.lower[0], image(line.lower[2]));
}

TEST(LipLine, GoesWithTheJawByItsShares) {
  const LipLine line = shaped({.jaw = 1});
  EXPECT_EQ(line.upper[1].y, -0.01);
  EXPECT_DOUBLE_EQ(line.lower[1].y, -0.21);
  EXPECT_DOUBLE_EQ(line.corners[0].y, -0.32 * 0.2);
  EXPECT_LT(line.corners[0].x, 0.2);
  expect_mirrored(line);
  const LipLine aside = shaped({.aside = 1});
  EXPECT_GT(aside.lower[1].x, aside.upper[1].x + 0.03);
}

TEST(LipLine, ShutOnADroppedJawIsTheRestingLineLowered) {
  const LipLine rest = resting();
  for (const double jaw : {0.2, 0.6, 1.0}) {
    const LipLine shut = closed(shaped({.jaw = jaw}), 1, 0.32);
    EXPECT_EQ(shut.upper, shut.lower);
    EXPECT_NEAR(shut.corners[0].y - shut.upper[1].y, rest.corners[0].y - rest.upper[1].y, 1e-12);
  }
}

TEST(LipLine, OfARoundMouthIsNarrowAndLevel) {
  const LipLine line = shaped({.pucker = 1});
  EXPECT_NEAR(line.corners[0].x, 0.1, 1e-12);
  EXPECT_EQ(line.upper, line.lower);  // puckered lips stay shut
  EXPECT_LT(std::abs(line.corners[0].y - line.upper[1].y), 0.015);
  expect_mirrored(line);
  EXPECT_GT(shaped({.funnel = 1}).upper[1].y, shaped({.funnel = 1}).lower[1].y + 0.03);
}

/// Lips that lie over the teeth do not part for a breath of a sound.
TEST(LipLine, ATongueBaresTheTeethByAsMuchAsItShows) {
  const TeethEdge teeth{{0.25, -0.08}, {0, -0.12}, {-0.25, -0.08}};
  const double rest = shaped({}, teeth).lower[1].y;
  const double up = rest - shaped({.tongue_up = 1}, teeth).lower[1].y;
  const double between = rest - shaped({.tongue_between = 1}, teeth).lower[1].y;
  EXPECT_GT(up, 0.1);
  EXPECT_GT(between, up);
  for (const double share : {1e-6, 1e-3, 0.1, 0.5, 0.9}) {
    EXPECT_LE(rest - shaped({.tongue_up = share}, teeth).lower[1].y, share * up + 1e-12);
    EXPECT_LE(rest - shaped({.tongue_between = share}, teeth).lower[1].y, share * between + 1e-12);
  }
}

TEST(LipLine, MeetsTheTeeth) {
  const TeethEdge teeth{{0.25, -0.02}, {0, -0.06}, {-0.25, -0.02}};
  EXPECT_NEAR(teeth.y(0), -0.05, 1e-12);
  const LipLine bitten = shaped({.jaw = 0.5, .bite = 1}, teeth);
  EXPECT_NEAR(bitten.lower[1].y, teeth.y(0) + 0.020, 1e-12);
  EXPECT_NEAR(bitten.upper[1].y, bitten.lower[1].y + 0.030, 1e-12);
  const LipLine between = shaped({.tongue_between = 1}, teeth);
  EXPECT_NEAR(between.lower[1].y, teeth.y(0) - 0.036, 1e-12);
}

/// Numbers that go beyond 1 part the lips farther, and do not carry them past where the tongue lies.
TEST(LipLine, ATongueBeyondItsWholeIsNotDoubled) {
  const TeethEdge teeth{{0.25, -0.02}, {0, -0.06}, {-0.25, -0.02}};
  EXPECT_NEAR(shaped({.tongue_between = 2}, teeth).lower[1].y, teeth.y(0) - 2 * 0.036, 1e-12);
}

TEST(LipLine, KnowsItsLength) {
  const LipLine rest = resting();
  EXPECT_NEAR(edge_length(rest, true, 0), 0.2018, 0.001);
  EXPECT_EQ(edge_length(rest, true, 0), edge_length(rest, true, 1));
  LipLine plain = rest;
  plain.has_handles = false;
  EXPECT_NEAR(edge_length(plain, false, 0), 0.2, 0.001);
}

}  // namespace
}  // namespace mien
