// Ramps of many stops, which means over pixels take from integrals: no channel off by more than 1 of 255 or 32 of 65535
// from a count of very many places.

#include <mien/render.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "render/blend/ramp.h"
#include "tests/support/exact/exact_mix.h"
#include "tests/support/pictures/rendered.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random_ramp.h"

namespace mien {
namespace {

double place(const Gradient& gradient, const Scene& scene, glm::dvec2 p) {
  if (const auto* g = std::get_if<LinearGradient>(&gradient.along))
    return glm::dot(p - g->from, g->to - g->from) / glm::dot(g->to - g->from, g->to - g->from);
  if (const auto* g = std::get_if<RadialGradient>(&gradient.along)) {
    const glm::dvec2 d = p - g->center;
    return std::hypot(glm::dot(d, g->axis) / g->radii.x,
                      (g->axis.x * d.y - g->axis.y * d.x) / g->radii.y);
  }
  const auto& g = std::get<DistanceGradient>(gradient.along);
  return (scene.distance(g.area, p) - g.from) / (g.to - g.from);
}

/// A painted area over a white ground.
struct Painted {
  Gradient gradient;
  Scene scene;
  bool everywhere;
};

Painted random_painted(std::uint64_t seed) {
  test::Random r(seed);
  Gradient gradient = test::random_gradient(r);
  const double length = std::pow(10, r.between(-3, -0.7)), way = r.between(0, 1);
  const double turn = way < 0.2 ? 0.0 : way < 0.4 ? 0.5 * 3.141592653589793 : r.between(0, 6.3);
  const glm::dvec2 axis{std::cos(turn), std::sin(turn)}, at{r.between(0, 1), r.between(0, 1)};
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 1, 1, 1});
  const Area shape = seed % 2 ? build.shape(Ellipse{{.5, .5}, {.31, .42}, {0.6, 0.8}})
                              : build.shape(Triangle{{.1, .2}, {.95, .3}, {.45, .9}});
  const Area disc = build.shape(Disc{{.4, .55}, .3});
  if (seed % 3 == 0) gradient.along = LinearGradient{at, at + length * axis};
  if (seed % 3 == 1) gradient.along = RadialGradient{at, {length, 0.7 * length}, axis};
  if (seed % 3 == 2) gradient.along = DistanceGradient{seed % 2 ? disc : shape, 0, length};
  const bool everywhere = r.between(0, 1) < 0.3;
  build.layer("ramp", everywhere ? build.everywhere() : shape,
              {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  return {gradient, std::move(build).finish(), everywhere};
}

Mix counted(const Painted& painted, const Ramp& ramp, int side, int x, int y) {
  constexpr int kSide = 500;
  const Area area = painted.scene.layers()[0].area;
  Mix sum{0.0};
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double shift = double((j * 7919 + i * 104729) % 997) / 997 - 0.5;
      const glm::dvec2 p{(x + (i + 0.5 + shift) / kSide) / side,
                         1 - (y + (j + 0.5 - shift) / kSide) / side};
      Mix mix{1.0};
      if (painted.everywhere || painted.scene.distance(area, p) <= 0)
        mix = over(ramp.color(place(painted.gradient, painted.scene, p)), mix);
      sum += mix;
    }
  return sum / double(kSide * kSide);
}

TEST(ExactRamps, AreMeansOverPixelsAndParts) {
  for (int seed = 1; seed <= test::times(24); ++seed) {
    const Painted painted = random_painted(std::uint64_t(seed));
    test::Random r(std::uint64_t(seed) + 1000);
    const int side = seed % 5 ? 19 : 160;
    const Blend blend = seed % 2 ? Blend::linear : Blend::srgb;
    const Ramp ramp(painted.gradient, 1, blend);
    const View view{.width = side, .height = side, .blend = blend, .dither = false};
    const Image coarse = test::rendered(painted.scene, view, {.depth = Depth::u8}),
                fine = test::rendered(painted.scene, view, {.depth = Depth::u16});
    for (int k = 0; k < 4; ++k) {
      const int x = int(r.between(0, side - 0.01)), y = int(r.between(0, side - 0.01));
      const Mix mean = counted(painted, ramp, side, x, y);
      for (int c = 0; c < 3; ++c) {
        const double want = blend == Blend::linear ? test::encoded(mean[c]) : mean[c];
        EXPECT_NEAR(coarse.row(y)[4 * x + c], 255 * want, 1) << seed << ' ' << x << ' ' << y;
        const auto* row = reinterpret_cast<const std::uint16_t*>(fine.row(y));
        EXPECT_NEAR(row[4 * x + c], 65535 * want, 32 + 16)
            << seed << ' ' << x << ' ' << y;  // 16: counting
      }
    }
  }
}

/// Where two sides of a triangle are equally near, from a corner to its middle.
TEST(ExactRamps, AlongADistanceAreRightOnRidges) {
  const std::vector<Stop> stops{
      {0, {1, 1, 1, 1}}, {0.5, {1, 1, 1, 1}}, {0.5, {0, 0, 0, 1}}, {1, {0.5, 0, 0, 1}}};
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 1, 1, 1});
  const Area shape = build.shape(Triangle{{.1, .2}, {.95, .3}, {.45, .9}});
  const Gradient gradient{DistanceGradient{shape, 0, 0.02}, stops, Extend::repeat};
  build.layer("ramp", shape, {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  const Painted painted{gradient, std::move(build).finish(), false};
  const View view{.width = 60, .height = 60, .blend = Blend::srgb, .dither = false};
  const Image image = test::rendered(painted.scene, view, {.depth = Depth::u16});
  const glm::dvec2 corner{.1, .8}, middle{.49875, .52004};
  for (double along = 0.2; along < 1; along += 0.025)
    for (const double beside : {-0.6, 0.0, 0.6}) {
      const glm::ivec2 p{60.0 * glm::mix(corner, middle, along) + beside};
      const Mix mean = counted(painted, Ramp(gradient, 1, Blend::srgb), 60, p.x, p.y);
      const auto* row = reinterpret_cast<const std::uint16_t*>(image.row(p.y));
      for (int c = 0; c < 2; ++c)
        EXPECT_NEAR(row[4 * p.x + c], 65535 * mean[c], 32 + 16) << along << ' ' << beside;
    }
}

/// Plaid: the mean of a product is not the product of means.
TEST(ExactRamps, OverRampsThatCrossAreMeansOfBoth) {
  const auto along = [](glm::dvec2 to, double opacity) {
    return Gradient{LinearGradient{{0, 0}, to},
                    {{0, {0.9, 0.2, 0.1, 1}},
                     {0.5, {0.9, 0.2, 0.1, 1}},
                     {0.5, {0.1, 0.3, 0.8, opacity}},
                     {1, {0.1, 0.3, 0.8, opacity}}},
                    Extend::repeat};
  };
  const Gradient below = along({-0.02, 0.06}, 1), above = along({0.06, 0.02}, 0.2);
  SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 1, 1, 1});
  for (const Gradient& g : {below, above})
    build.layer("ramp", build.everywhere(),
                {.color = {0, 0, 0, 1}, .gradient = shared(Gradient(g))});
  const Scene scene = std::move(build).finish();
  const View view{.width = 32, .height = 32, .blend = Blend::srgb, .dither = false};
  RenderStats stats;
  const Image image = test::rendered(scene, view, {.depth = Depth::u16}, &stats);
  EXPECT_EQ(stats.resolved_pixels, 0);
  const Ramp ramps[] = {Ramp(below, 1, Blend::srgb), Ramp(above, 1, Blend::srgb)};
  constexpr int kSide = 600;
  for (int x = 1; x < 32; x += 2) {
    Mix sum{0.0};
    for (int k = 0; k < kSide * kSide; ++k) {
      const double shift = double(k * 7919ll % 997) / 997 - 0.5;
      const glm::dvec2 p{(x + (k % kSide + 0.5 + shift) / kSide) / 32,
                         1 - (x + (k / kSide + 0.5 - shift) / kSide) / 32};
      sum += over(ramps[1].color(place(above, scene, p)), ramps[0].color(place(below, scene, p)));
    }
    const auto* row = reinterpret_cast<const std::uint16_t*>(image.row(x));
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(row[4 * x + c], 65535 * sum[c] / (kSide * kSide), 32 + 16) << x;
  }
}

/// The time of every length and extension is bounded: pictures of what took minutes.
TEST(ExactRamps, OfNoLengthOrNextToNoneAreDrawnAtOnce) {
  const std::vector<Stop> stops{{0.2, {1, 0, 0, 1}}, {0.8, {0, 0, 1, 1}}};
  for (const double length : {0.0, 1e-300, 1e-12, 1e-9, 1e-6})
    for (const Extend extend : {Extend::pad, Extend::repeat, Extend::reflect})
      for (int kind = 0; kind < 3; ++kind) {
        Gradient gradient{LinearGradient{{.5, .5}, {.5 + length, .5}}, stops, extend};
        SceneBuilder build({.box = {{0, 0}, {1, 1}}}, {1, 1, 1, 1});
        const Area disc = build.shape(Disc{{.5, .5}, .3});
        if (kind == 1) gradient.along = RadialGradient{{.5, .5}, {length, length}};
        if (kind == 2) gradient.along = DistanceGradient{disc, 0, length};
        build.layer("l", build.everywhere(), {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
        RenderStats stats;
        const Image image =
            test::rendered(std::move(build).finish(),
                           {.width = 64, .height = 64, .blend = Blend::srgb}, {}, &stats);
        EXPECT_LT(stats.resolved_pixels, 64) << length << ' ' << int(extend) << ' ' << kind;
        // Right of the middle: beyond the last stop, or a mean of both.
        const bool mean = extend != Extend::pad && length > 0 && !(kind == 0 && length < 1e-100);
        EXPECT_NEAR(image.row(20)[4 * 60 + 2], mean ? 127.5 : 255, 2)
            << length << ' ' << int(extend) << ' ' << kind;
      }
}

}  // namespace
}  // namespace mien
