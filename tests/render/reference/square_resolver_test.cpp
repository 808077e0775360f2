#include <mien/render/reference/square_resolver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mien {
namespace {

constexpr Color kBlack{0, 0, 0, 1}, kWhite{1, 1, 1, 1};

/// The red of every pixel of a picture with one pixel per face unit.
double sum_of_red(const Scene& scene, int side, double& bound) {
  const View view{.width = side, .height = side};
  PaintTable paints;
  paints.make(scene, view, Depth::u8);
  SquareResolver resolver(scene, view, paints, 1e-5);
  double sum = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Resolved found = resolver.pixel(x, y);
      sum += found.mix.r;
      bound += found.bound;
    }
  return sum;
}

TEST(SquareResolver, KnowsTheAreaOfADisc) {
  SceneBuilder build({.box = {{0, 0}, {12, 12}}}, kBlack);
  build.layer("disc", build.shape(Disc{{6.1, 5.7}, 3.3}), {kWhite});
  double bound = 0;
  EXPECT_NEAR(sum_of_red(std::move(build).finish(), 12, bound), std::numbers::pi * 3.3 * 3.3, 1e-3);
  EXPECT_LT(bound, 0.2);
}

TEST(SquareResolver, LetsNothingShineThroughBetweenLayersThatAbut) {
  SceneBuilder build({.box = {{0, 0}, {4, 4}}}, kBlack);
  const Area left = build.shape(HalfPlane{{0.6, 0.8}, 2.9});
  build.layer("left", left, {kWhite});
  build.layer("right", build.complement(left), {kWhite});
  double bound = 0;
  EXPECT_NEAR(sum_of_red(std::move(build).finish(), 4, bound), 16, 1e-3);
}

TEST(SquareResolver, TakesTheMeanOfARadialGradientWithAJump) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, kBlack);
  build.layer("all", build.everywhere(),
              {.color = kBlack,
               .gradient = shared(Gradient{RadialGradient{{0.1, 0}, {0.5, 0.25}},
                                           {{0, kBlack}, {1, kWhite}, {1, kBlack}}})});
  double bound = 0;  // a cone within the ellipse: 2/3 of its area
  EXPECT_NEAR(4 * sum_of_red(std::move(build).finish(), 1, bound),
              2.0 / 3 * std::numbers::pi * 0.5 * 0.25, 4e-3);
}

}  // namespace
}  // namespace mien
