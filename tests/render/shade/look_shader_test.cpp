#include "render/shade/look_shader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

struct Shaded {
  PaintTable paints;
  Looks looks;
  Regions regions;
  LookShader shader;
  int look = 0;

  explicit Shaded(const Gradient& gradient, int inside) {
    SceneBuilder build({.box = {{0, 0}, {128, 128}}, .y_up = false}, {1, 1, 1, 1});
    build.layer("ramp", build.everywhere(), {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
    paints.make(std::move(build).finish(), {.width = 128, .height = 128, .blend = Blend::linear},
                Depth::u8);
    looks.begin(paints);
    regions.begin(int(paints.programs.outlines().size()), looks);
    look = regions.look(regions.across(0, inside));
    shader.begin(looks);
  }
};

const std::vector<Stop> kStops{{0, {0, 0, 0, 1}}, {1, {1, 0.5, 0, 1}}};

TEST(LookShader, TakesALinearGradientAtTheCentroid) {
  Shaded s({LinearGradient{{-10, 0}, {200, 0}}, kStops}, 0);
  Shaded whole({LinearGradient{{10, 0}, {110, 0}}, kStops}, 1);
  EXPECT_NEAR(whole.shader.part(whole.look, 60.25, 7.5, 0.3).r, 0.5025, 1e-6);
  const ColorRow& row = whole.shader.pixels(whole.look, 64, 3, 20);
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(row.r[std::size_t(i)], (54.5 + i) / 100, 1e-6);
}

TEST(LookShader, CountsHowARadialGradientBendsWithinAPixel) {
  Shaded s({RadialGradient{{64, 64}, {50, 50}}, kStops}, 1);
  for (const auto& [x, y] : {std::pair{66, 64}, {70, 61}, {90, 30}}) {
    double mean = 0;
    constexpr int kPlaces = 200;
    for (int j = 0; j < kPlaces; ++j)
      for (int i = 0; i < kPlaces; ++i)
        mean += std::hypot(x + (i + 0.5) / kPlaces - 64, y + (j + 0.5) / kPlaces - 64) / 50 /
                (kPlaces * kPlaces);
    EXPECT_NEAR(s.shader.pixels(s.look, x, y, 1).r[0], mean, 2e-4) << x << ' ' << y;
  }
}

TEST(LookShader, SaysTheSameOfAPixelWhereverARunBegins) {
  Shaded s({RadialGradient{{60.3, 61.7}, {50, 40}}, kStops}, 1);
  const float alone = s.shader.pixels(s.look, 77, 60, 1).r[0];
  EXPECT_EQ(s.shader.pixels(s.look, 70, 60, 20).r[7], alone);
}

/// Floats are counted from the block's first pixel, whose middle is the place of this part.
TEST(LookShader, APlainLooksPartHasTheBitsOfARow) {
  const Gradient ramps[] = {{LinearGradient{{10, 5}, {110, 30}}, kStops},
                            {RadialGradient{{60.3, 61.7}, {50, 40}}, kStops}};
  for (const Gradient& ramp : ramps) {
    Shaded s(ramp, 1);
    ASSERT_TRUE(s.looks.plain(s.look));
    for (const int x : {0, LookShader::kBlock}) {
      const ColorRow& row = s.shader.pixels(s.look, x, 60, 1);
      const glm::vec4 alone = s.shader.part(s.look, x + 0.5, 60.5, 1.0);
      EXPECT_EQ(alone, glm::vec4(row.r[0], row.g[0], row.b[0], row.a[0]));
    }
  }
}

}  // namespace
}  // namespace mien
