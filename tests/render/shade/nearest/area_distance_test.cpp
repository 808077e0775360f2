#include "render/shade/nearest/area_distance.h"

#include <gtest/gtest.h>

#include <mien/view.h>

#include <random>

namespace mien {
namespace {

TEST(AreaDistance, IsTheScenesOwnInPixels) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0.2, 0.1}, 0.4}), unused = build.shape(Disc{{9, 9}, 1});
  const Area band = build.shape(HalfPlane{{0, 1}, 0.1});
  const Area tree =
      build.shell(build.unite(build.subtract(disc, band), build.offset(band, -0.5)), 0.07);
  (void)unused;
  const Scene scene = std::move(build).finish();
  const auto map = pixel_from_face(scene.canvas(), {.width = 300, .height = 200});
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.5, 1.5);
  for (const Area area : {disc, tree}) {
    const AreaDistance distance(scene, area, map);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 p{unit(random), unit(random)};
      EXPECT_NEAR(distance.at(map(p)), 100 * scene.distance(area, p), 1e-12);
    }
  }
}

TEST(AreaDistance, OfATreeOfAnySize) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  Area many = build.shape(Disc{{0, 0}, 0.01});
  for (int i = 1; i < 100; ++i) many = build.unite(many, build.shape(Disc{{0.01 * i, 0}, 0.01}));
  const Scene scene = std::move(build).finish();
  const auto map = pixel_from_face(scene.canvas(), {.width = 200, .height = 200});
  EXPECT_NEAR(AreaDistance(scene, many, map).at(map({0.5, 0.3})), 29, 1e-9);
}

}  // namespace
}  // namespace mien
