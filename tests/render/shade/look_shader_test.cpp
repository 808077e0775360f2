#include "render/shade/look_shader.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

struct Shaded {
  PaintTable paints;
  Looks looks;
  Regions regions;
  LookShader shader;
  int look = 0;

  explicit Shaded(const Gradient& gradient, int inside, int width = 128) {
    SceneBuilder build({.box = {{0, 0}, {width, 128}}, .y_up = false}, {1, 1, 1, 1});
    build.layer("ramp", build.everywhere(), {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
    paints.make(std::move(build).finish(), {.width = width, .height = 128, .blend = Blend::linear},
                Depth::u8);
    looks.begin(paints);
    regions.begin(int(paints.programs.outlines().size()), looks);
    look = regions.look(regions.across(0, inside));
    shader.begin(looks);
  }
  /// Red of a part that is as good as its pixel, but for its centroid.
  float part(int x, int y, glm::vec2 from_middle) {
    using Plane = std::array<float, 1 + kColorSpare>;
    const Plane column{float(x)}, dx{from_middle.x}, dy{from_middle.y}, v{1.0f / 12}, none{},
        area{1};
    const LanePlaces at{1, column.data(), dx.data(), dy.data(), v.data(), none.data(), v.data()};
    return shader.parts(look, y, {at, area.data(), {}}).r[0];
  }
};

const std::vector<Stop> kStops{{0, {0, 0, 0, 1}}, {1, {1, 0.5, 0, 1}}};

TEST(LookShader, TakesALinearGradientAtTheCentroid) {
  Shaded s({LinearGradient{{-10, 0}, {200, 0}}, kStops}, 0);
  Shaded whole({LinearGradient{{10, 0}, {110, 0}}, kStops}, 1);
  EXPECT_NEAR(whole.part(60, 7, {-0.25f, 0.0f}), 0.5025, 1e-6);
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

/// One that is all of its pixel, whatever lies beside it.
TEST(LookShader, APartHasTheBitsOfARow) {
  const Gradient ramps[] = {{LinearGradient{{10, 5}, {110, 30}}, kStops},
                            {RadialGradient{{60.3, 61.7}, {50, 40}}, kStops}};
  for (const Gradient& ramp : ramps) {
    Shaded s(ramp, 1);
    for (const int x : {0, 37, 64})
      EXPECT_EQ(s.part(x, 60, {0.0f, 0.0f}), s.shader.pixels(s.look, x, 60, 1).r[0]);
  }
}

/// Where opacities of ramps fall together within a cell, the mean of what they leave is more than what means leave.
TEST(LookShader, CountsWhatProductsOfRampsVaryByWithinCells) {
  SceneBuilder build({.box = {{0, 0}, {20, 20}}, .y_up = false}, {1, 1, 1, 1});
  const glm::dvec2 ways[] = {{0.6, 0.8}, {0.8, 0.6}};
  const double opacities[] = {1, 0.4, 0.3, 0};
  constexpr double kLength = 2.4;
  for (int layer = 0; layer < 2; ++layer) {
    const Area area = build.shape(HalfPlane{ways[layer], 3});
    const double light = layer;
    std::vector<Stop> stops;
    for (int i = 0; i < 4; ++i) stops.push_back({i / 3.0, {light, light, light, opacities[i]}});
    build.layer(
        layer ? "upper" : "lower", build.everywhere(),
        {.color = {light, light, light, 1},
         .gradient = shared(Gradient{DistanceGradient{area, 0, kLength}, stops, Extend::reflect})});
  }
  PaintTable paints;
  paints.make(std::move(build).finish(), {.width = 20, .height = 20, .blend = Blend::linear},
              Depth::u8);
  Looks looks;
  looks.begin(paints);
  Regions regions;
  regions.begin(int(paints.programs.outlines().size()), looks);
  LookShader shader;
  shader.begin(looks);
  const auto opacity = [&](int layer, glm::dvec2 p) {
    const double t = (glm::dot(ways[layer], p) - 3) / kLength;
    const double run = std::abs(t - 2 * std::round(t / 2)) * 3;
    const int i = std::min(int(run), 2);
    return opacities[i] + (run - i) * (opacities[i + 1] - opacities[i]);
  };
  for (int x = 5; x < 12; ++x) {
    double mean = 0;
    constexpr int kPlaces = 200;
    for (int k = 0; k < kPlaces * kPlaces; ++k) {
      const glm::dvec2 p{x + (k % kPlaces + 0.5) / kPlaces, 9 + (k / kPlaces + 0.5) / kPlaces};
      const double upper = opacity(1, p);
      mean += ((1 - opacity(0, p)) * (1 - upper) + upper) / (kPlaces * kPlaces);
    }
    EXPECT_NEAR(shader.by_cells(regions.look(0), x, 9, nullptr, 4, true).r, mean, 5e-4) << x;
  }
}

/// Far from its beginning a steep ramp has as many digits as near it.
TEST(LookShader, TakesASteepRampFarFromThePicturesCorner) {
  Shaded s({LinearGradient{{16000, 0}, {16001, 5}}, kStops}, 1, 16384);
  const float r = s.shader.pixels(s.look, 15994, 2, 20).r[6];
  EXPECT_NEAR(r, (0.5 + 5 * 2.5) / 26, 1e-6);
}

}  // namespace
}  // namespace mien
