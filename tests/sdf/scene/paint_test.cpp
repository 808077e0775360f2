#include <mien/paint.h>

#include <gtest/gtest.h>

#include <mien/scene.h>

namespace mien {
namespace {

TEST(Paint, IsOneColourUnlessSaidOtherwise) {
  const Paint paint{{0.1, 0.2, 0.3, 0.4}};
  EXPECT_EQ(paint.color, (Color{0.1, 0.2, 0.3, 0.4}));
  EXPECT_EQ(paint.gradient, nullptr);
  EXPECT_EQ(paint.relief, nullptr);
}

TEST(Paint, IsPrintedWithItsSceneWholly) {
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.3});
  build.open_group("glasses", 0.5, disc);
  build.layer("lens", build.everywhere(),
              {.color = {0, 0, 0, 0.25},
               .gradient = shared(Gradient{DistanceGradient{disc, -0.1, 0},
                                           {{0, {1, 0, 0, 1}}, {1, {0, 0, 1, 0.5}}},
                                           Extend::reflect}),
               .relief = shared(
                   Relief{.area = disc,
                          .profile = Profile::round,
                          .width = 0.1,
                          .height = 0.05,
                          .domes = {{.center = {0.1, 0}, .radii = {0.2, 0.1}, .height = 0.02}}})});
  build.close_group();
  build.light({.direction = {1, 2, 3}, .ambient = 0.25});
  EXPECT_EQ(std::move(build).finish().text(),
            "canvas -0.5,-0.5 0.5,0.5 y up\n"
            "background 1 1 1 1\n"
            "a0 = disc center 0,0 radius 0.3\n"
            "a1 = path nonzero\n"
            "a2 = complement a1\n"
            "a3 = intersect a2 a0\n"
            "light 1,2,3 ambient 0.25\n"
            "group g0 glasses opacity 0.5\n"
            "layer lens area a3 distance a0 -0.1 to 0 reflect (0: 1 0 0 1) (1: 0 0 1 0.5) opacity "
            "0.25 relief "
            "round a0 width 0.1 height 0.05 dome (center 0.1,0 radii 0.2,0.1 axis 1,0 height 0.02) "
            "specular 0 "
            "shininess 30 in g0 (bound outside, exact inside)\n");
}

}  // namespace
}  // namespace mien
