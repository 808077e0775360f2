#include "render/shade/nearest/near_area.h"
#include "render/shade/light/light_tile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "sdf/shape/curve/band.h"

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"
#include "tests/support/tile_cells.h"

namespace mien {
namespace {

constexpr glm::dvec2 kMiddle{24.0, 24.0};

void set_distance(const FeetArea& area, LightTile& tile) {
  tile.x = tile.y = 16, tile.rises = true, tile.channels = 1, tile.tolerance = 1e-3f;
  tile.lamp.distance_alone = true;
  tile.area.narrow(area, kMiddle, 12.0);
  tile.crowded = tile.area.crowded();
  if (!tile.crowded) tile.begin();
}

bool expect_distances(const AreaDistance& area, const char* what) {
  const FeetArea feet(area, {0, 0});
  LightTile tile;
  set_distance(feet, tile);
  if (tile.crowded) return false;  // smaller tiles are asked
  test::SeenCells seen;
  for (int k = 0; k < 256; k += 7) {
    const int i = k % 16, j = k / 16;
    test::see(tile, i, j, seen);
    for (std::size_t q = 0; q < 16; ++q)
      EXPECT_NEAR(seen.c[0][q], area.at(test::place(seen, i, j, q)), 2e-3)
          << what << " " << i << " " << j;
  }
  return true;
}

TEST(NearArea, DistancesAreTheAreasOwn) {
  test::on_every_set([] {
    test::Random random(5);
    int crowded = 0;
    for (int k = 0; k < 240; ++k) {
      SCOPED_TRACE(k);
      const auto area = test::random_area(random, k % test::kLitShapes, random.between(6, 60));
      crowded += !expect_distances(area, "a random area");
    }
    EXPECT_LT(crowded, 4);
  });
}

AreaDistance distance_of(SceneBuilder scene, Area area) {
  return AreaDistance(std::move(scene).finish(), area, {});
}

TEST(NearArea, KnowsEveryKindOfShape) {
  test::Random random(6);
  int crowded = 0;
  for (int k = 0; k < 40; ++k) {
    const glm::dvec2 up = random.direction();
    const ParabolaSide low{random.point(14, 34), up, random.between(-0.2, 0.2)},
        high{random.point(14, 34) + 6.0 * up, -up, random.between(-0.2, 0.2)};
    Path eight{{{{}}}, FillRule::even_odd};
    auto& sides = eight.loops[0].sides;
    std::array<glm::dvec2, 5> at;
    for (glm::dvec2& p : at) p = random.point(8, 40);
    for (std::size_t i = 0; i < at.size(); ++i) {
      const glm::dvec2 a = at[i], b = at[(i + 1) % 5];
      sides.push_back({a, random.point(8, 40), b});
    }
    const std::pair<const char*, Shape> shapes[] = {
        {"half plane", HalfPlane{up, glm::dot(up, random.point(16, 32))}},
        {"parabola", low},
        {"band", Band{low, high}},
        {"cut disc", CutDisc{random.point(16, 32), random.between(3, 30), random.between(0.1, 1.2),
                             random.between(0.1, 1.2), up}},
        {"crossing path", eight}};
    for (const auto& [name, shape] : shapes) {
      const auto* band = std::get_if<Band>(&shape);
      if (band && is_empty(*band)) continue;  // it has no outline
      SceneBuilder scene({}, {});
      const Area area = scene.shape(shape);
      crowded += !expect_distances(distance_of(std::move(scene), area), name);
    }
  }
  EXPECT_LT(crowded, 20);
}

TEST(NearArea, KnowsWhatCombinationsMakeOfDistances) {
  test::Random random(7);
  for (int k = 0; k < 40; ++k) {
    SceneBuilder scene({}, {});
    const Area a = scene.shape(Disc{random.point(16, 32), random.between(2, 12)});
    const Area b =
        scene.shape(Line{random.point(10, 38), random.point(10, 38), random.between(1, 4)});
    const Area both = k % 3 == 0   ? scene.unite(a, b)
                      : k % 3 == 1 ? scene.intersect(a, b)
                                   : scene.subtract(a, b);
    const Area made = k % 2 ? scene.shell(both, random.between(0.5, 3))
                            : scene.offset(both, random.between(-1, 3));
    EXPECT_TRUE(expect_distances(distance_of(std::move(scene), made), "a combination"));
  }
}

/// Spines that all but turn back, in a few pixels. Strokes that widen about as fast as their spine goes may settle beside
/// their foot.
TEST(NearArea, KnowsHairpins) {
  test::Random random(8);
  long all = 0, off = 0;
  for (int k = 0; k < 300; ++k) {
    const glm::dvec2 a = random.point(14, 34), way = random.direction();
    const double length = random.between(3, 30), aside = random.between(0, 0.15);
    const glm::dvec2 tip = a + length * way;
    const glm::dvec2 c =
        a + random.between(0, 0.4) * length * way + aside * length * glm::dvec2{way.y, -way.x};
    SceneBuilder scene({}, {});
    const double w = random.between(0.05, 2.5);
    const Area area = k % 2 ? scene.shape(QuadStroke{{a, tip, c}, w})
                            : scene.shape(TaperedStroke{
                                  {a, tip, c}, {w, random.between(0, 3), random.between(0, 3)}});
    const AreaDistance distance = distance_of(std::move(scene), area);
    const FeetArea feet(distance, {0, 0});
    LightTile tile;
    set_distance(feet, tile);
    ASSERT_FALSE(tile.crowded);
    test::SeenCells seen;
    for (int at = 0; at < 256; at += 7) {
      test::see(tile, at % 16, at / 16, seen);
      for (std::size_t q = 0; q < 16; ++q) {
        const double own = distance.at(test::place(seen, at % 16, at / 16, q));
        const double by = std::abs(double(seen.c[0][q]) - own);
        ++all, off += by > 2e-3;
        EXPECT_LT(by, 0.05);
      }
    }
  }
  EXPECT_LE(double(off), 1e-5 * double(all));
}

}  // namespace
}  // namespace mien
