#include <mien/render/shade/lamp_lanes.h>
#include <mien/render/shade/lit_cells.h>

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

TEST(LampLanes, ShineAsTheSurfaceDoes) {
  test::on_every_set([] {
    test::Random random(8);
    for (int k = 0; k < 600; ++k) {
      const Blend blend = k % 2 ? Blend::srgb : Blend::linear;
      const auto scene = test::random_lit(random, 3, 40, Profile(1 + random.below(3)), blend);
      const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
      const glm::dvec2 middle{32, 32}, n = random.direction();
      const int zone = 1 + random.below(int(surface.levels().size()) - 1);
      const auto levels = surface.levels();
      const double shallow = -levels[std::size_t(zone) - 1], deep = -levels[std::size_t(zone)];
      const double depth = random.between(shallow + 0.1, deep);
      // Cells so small that their means are their middles' colours.
      LitCells cells;
      cells.x = float(random.between(-5, 5)), cells.y = float(random.between(-5, 5));
      cells.side = 1e-4f, cells.shallow = -1e9f, cells.deep = 1e9f;
      cells.d.fill(float(-depth)), cells.bend.fill(0.0f);
      cells.nx.fill(float(n.x)), cells.ny.fill(float(n.y));
      LampLanes lamp;
      set_lamp(surface, zone, middle, 13.0, lamp);
      color_cells(lamp, cells);
      const Mix expected = surface.color(zone, middle + glm::dvec2{cells.x, cells.y}, {-depth, n});
      EXPECT_NEAR(cells.r[5], expected.r, 1e-4) << k;
      EXPECT_NEAR(cells.g[5], expected.g, 1e-4) << k;
      EXPECT_NEAR(cells.b[5], expected.b, 1e-4) << k;
    }
  });
}

}  // namespace
}  // namespace mien
