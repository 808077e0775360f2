#include "render/shade/light/lit_pixel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/brute_light.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

/// Pixels on the spine of a stroke, where the surface has a crest.
TEST(LitPixel, KnowsCrests) {
  test::Random random(17);
  LitPixel pixel;
  for (int k = 0; k < 60; ++k) {
    auto scene = test::random_lit(random, 6, 40, Profile::bevel, Blend::srgb);
    scene.paint.relief->width = 20, scene.paint.relief->domes.clear();
    const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
    const auto& stroke = std::get<QuadStroke>(scene.distances[0].shapes()[0]);
    const glm::dvec2 on = 0.25 * stroke.spine.p0 + 0.5 * stroke.spine.p1 + 0.25 * stroke.spine.p2;
    const int x = int(std::floor(on.x)), y = int(std::floor(on.y));
    if (stroke.half_width < 1.5) continue;
    const FeetArea area(scene.distances[0], {0, 0});
    NearFeet feet;
    const glm::dvec2 middle{x + 3, y - 2};
    feet.narrow(area, middle, 13.0);
    LampLanes lamp;
    set_lamp(surface, 1, middle, 13.0, lamp);
    const glm::vec2 at{glm::dvec2{x + 0.5, y + 0.5} - middle};
    const glm::vec3 got =
        pixel.mean({&lamp, &feet, 0.0f, 20.0f, at, {}, false, 0.3f / 255}, nullptr);
    const test::LitPart truth = test::BruteLight(surface).part(1, x, y, 200);
    EXPECT_LT(
        test::levels_apart(Mix{got.x, got.y, got.z, scene.paint.color.a}, truth.mean, Blend::srgb),
        0.3)
        << k;
  }
}

}  // namespace
}  // namespace mien
