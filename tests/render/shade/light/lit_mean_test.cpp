#include "render/shade/light/lit_mean.h"

#include <gtest/gtest.h>

#include "tests/support/brute_light.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

TEST(LitMean, OfWholePixelsIsThatOfManyPlaces) {
  test::Random random(11);
  for (int k = 0; k < 40; ++k) {
    const auto scene =
        test::random_lit(random, k % test::kLitShapes, 40, Profile::round, Blend::srgb);
    const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
    test::BruteLight brute(surface);
    const int x = 16 + random.below(32), y = 16 + random.below(32);
    const double d = brute.middle(x, y);
    const int zone = surface.zone_of(d);
    if (zone == 0 || surface.zone_of(d - 0.71) != zone || surface.zone_of(d + 0.71) != zone)
      continue;
    const Mix got = square_mean(surface, zone, {x, y}, 1.0, 1e-4);
    EXPECT_LT(test::levels_apart(got, brute.part(zone, x, y, 64).mean, Blend::srgb), 0.5);
  }
}

}  // namespace
}  // namespace mien
