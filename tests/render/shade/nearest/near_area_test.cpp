#include "render/shade/nearest/near_area.h"
#include "render/shade/light/light_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "sdf/shape/curve/band.h"

#include "tests/support/scenes/lit_scene.h"
#include "tests/support/shapes/every_instruction_set.h"
#include "tests/support/shapes/tile_cells.h"

namespace mien {
namespace {

constexpr glm::dvec2 kMiddle{24.0, 24.0};

/// A level paint whose opacity tells the distance.
constexpr float kPerOpacity = 400.0f;
double told(float opacity) {
  return double(kPerOpacity * (opacity - 0.5f));
}

void set_distance(const FeetArea& area, LightGround& ground, CellScratch& scratch,
                  LightTile& tile) {
  tile.x = tile.y = 16, tile.apart = true, tile.channels = 4, tile.tolerance = 1e-3f / kPerOpacity;
  tile.lamp.ambient = 0.5f, tile.lamp.diffuse = 0.0f;
  LampRamp& ramp = tile.lamp.ramp;
  ramp.kind = LampRamp::Kind::distance, ramp.xx = 1.0f / kPerOpacity;
  ramp.at.fill(0.5f), ramp.slope.fill(1.0f);
  ground.gradient.narrow(area, kMiddle, 12.0);
  ground.crowded = ground.gradient.crowded(), tile.ground = &ground, tile.scratch = &scratch;
  if (!ground.crowded) tile.begin_ground(), tile.begin();
}

bool expect_distances(const AreaDistance& area, const char* what) {
  const FeetArea feet(area, {0, 0});
  CellScratch scratch;
  LightGround ground;
  LightTile tile;
  set_distance(feet, ground, scratch, tile);
  if (ground.crowded) return false;  // smaller tiles are asked
  test::SeenCells seen;
  for (int k = 0; k < 256; k += 7) {
    const int i = k % 16, j = k / 16;
    test::see(tile, i, j, seen);
    for (std::size_t q = 0; q < 16; ++q)
      EXPECT_NEAR(told(seen.c[3][q]), area.at(test::place(seen, i, j, q)), 2e-3)
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

/// Behind its begin a spine turns at once, and widens: a place beside it has the begin, held, and a foot on the far side
/// of the turn, which is nearer. Where both are equally near to within that either may be told.
TEST(NearArea, FeetPastATurnAreFound) {
  test::on_every_set([] {
    SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
    const glm::dvec2 middle{16, 16};
    const TaperedStroke stroke{
        {middle + glm::dvec2{0.712, 1.157}, middle + glm::dvec2{1.329, 0.084},
         middle + glm::dvec2{9.030, 13.653}},
        {0.2087, 0.5602, 0.4614}};
    const Area area = scene.shape(stroke);
    const AreaDistance distance(std::move(scene).finish(), area, {});
    const FeetArea feet(distance, {0, 0});
    CellScratch scratch;
    LightGround ground;
    LightTile tile;
    set_distance(feet, ground, scratch, tile);
    test::SeenCells seen;
    seen.cells = whole_cells(32);
    for (const auto& [i, j] : {std::pair{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}}) {
      colors_of_cells(tile, i, j, seen.cells,
                      {seen.c[0].data(), seen.c[1].data(), seen.c[2].data(), seen.c[3].data()});
      for (std::size_t q = 0; q < 1024; ++q)
        EXPECT_NEAR(told(seen.c[3][q]), distance.at(test::place(seen, i, j, q)), 4e-3)
            << i << ' ' << j;
    }
  });
}

/// Far beyond the vertex of a side, which lies before its end, places have a least distance at the end and one within.
TEST(NearArea, EndsOfSidesCountBesideTheirFeet) {
  test::on_every_set([] {
    SceneBuilder scene({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
    const glm::dvec2 a{-0.6088, -0.3561}, b{-0.3570, 0.7939}, c{-0.0967, 0.9455};
    const Path path{
        {{{{a, {-0.1946, 0.3701}, b}, {b, 0.5 * (b + c), c}, {c, {0.9002, -0.2023}, a}}}},
        FillRule::nonzero};
    const Area area = scene.shape(path);
    const Scene made = std::move(scene).finish();
    for (const double turn : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
      const glm::dmat2 linear =
          8.5 * glm::dmat2{std::cos(turn), std::sin(turn), -std::sin(turn), std::cos(turn)};
      for (const glm::dvec2 shift : {glm::dvec2{24, 24}, {14, 24}, {34, 24}, {24, 14}, {24, 34}})
        expect_distances(AreaDistance(made, area, {linear, shift}), "a path");
    }
  });
}

/// Of the fold |d| - amount the farther end of a range counts.
TEST(NearArea, LeavesOutOnlyWhatIsFartherThanTheWholeRange) {
  SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
  const auto disc = [&](double x) { return scene.shape(Disc{{x, 24.0}, 2.0}); };
  const Area folded = scene.shell(scene.unite(disc(23), disc(24)), 0.2);
  const Area whole = scene.unite(folded, disc(25));
  const AreaDistance distance(std::move(scene).finish(), whole, {});
  const FeetArea feet(distance, {0, 0});
  NearArea area;
  area.narrow(feet, kMiddle, 12.0);
  ASSERT_EQ(area.nodes().size(), 6u);
  const auto left_out = [&](float of_third) {
    // The union is between -1 and 0.5, so the fold is 0.8 at most.
    const std::array<NearArea::Range, 3> of_leaves{
        {{-1.0f, 1.0f}, {0.5f, 0.5f}, {of_third, of_third}}};
    std::vector<NearNode> nodes(area.nodes().size());
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (area.nodes()[k].op == Op::shape)
        area.ranges()[k] = of_leaves.at(std::size_t(area.nodes()[k].b));
    area.leave_out(1.0f, nodes.data());
    return std::count_if(nodes.begin(), nodes.end(),
                         [](const NearNode& node) { return node.asks == NearNode::Asks::nothing; });
  };
  EXPECT_EQ(left_out(3.2f), 0) << "both may be nearest within 1 px";
  EXPECT_EQ(left_out(3.4f), 1);
}

/// How far means over every fifth pixel are from those of many places, rising: in smooth squares, and in others.
struct MeansOff {
  std::vector<double> smooth, other;

  void judge(const AreaDistance& area) {
    const FeetArea feet(area, {0, 0});
    CellScratch scratch;
    LightGround ground;
    LightTile tile;
    set_distance(feet, ground, scratch, tile);
    for (int p = 0; p < 256 && !ground.crowded; p += 5) {
      const int i = p % 16, j = p / 16;
      find_mean(tile, i, j);
      constexpr int kPlaces = 24;
      double sum = 0.0;
      for (int q = 0; q < kPlaces * kPlaces; ++q)
        sum += area.at(glm::dvec2{16 + i, 16 + j} +
                       (glm::dvec2{q % kPlaces, q / kPlaces} + 0.5) / double(kPlaces));
      (test::in_a_smooth_square(tile, i, j) ? smooth : other)
          .push_back(std::abs(told(tile.mean[3][std::size_t(p)]) - sum / (kPlaces * kPlaces)));
    }
  }
  static double all_but(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values.at(std::size_t(double(values.size() - 1) * (1.0 - share)));
  }
};

/// Squares keep what their bounds permit.
TEST(NearArea, MeansOfDistancesAreTheAreasOwn) {
  test::on_every_set([] {
    test::Random random(12);
    MeansOff off;
    for (int k = 0; k < 48; ++k)
      off.judge(test::random_area(random, k % test::kLitShapes, random.between(6, 60)));
    EXPECT_LT(MeansOff::all_but(off.smooth, 0.01), 2e-4) << off.smooth.size();
    EXPECT_LT(MeansOff::all_but(off.smooth, 0.0), 3e-3);
    EXPECT_LT(MeansOff::all_but(off.other, 0.02), 2e-3) << off.other.size();
    EXPECT_LT(MeansOff::all_but(off.other, 0.0), 0.015);
  });
}

AreaDistance distance_of(SceneBuilder scene, Area area) {
  return AreaDistance(std::move(scene).finish(), area, {});
}

/// A ridge cuts a pixel where two sides are equally near, and each part is seen by its own side.
TEST(NearArea, MeansOverRidgesBetweenSidesAreTheAreasOwn) {
  test::on_every_set([] {
    test::Random random(13);
    MeansOff off;
    for (int k = 0; k < 24; ++k) {
      Path triangle{{Path::Loop{}}, FillRule::nonzero};
      const double turn = random.between(0, 6);
      const auto corner = [&](int i) {
        const double at = turn + 2.0943951023931953 * (i % 3);
        return kMiddle + 9.0 * glm::dvec2{std::cos(at), std::sin(at)};
      };
      for (int i = 0; i < 3; ++i)
        triangle.loops[0].sides.push_back(
            {corner(i), 0.5 * (corner(i) + corner(i + 1)), corner(i + 1)});
      SceneBuilder scene({.box = {{0, 0}, {48, 48}}}, {1, 1, 1, 1});
      const Area area = scene.shape(triangle);
      off.judge(distance_of(std::move(scene), area));
    }
    EXPECT_GT(off.other.size(), 100u);
    EXPECT_LT(MeansOff::all_but(off.other, 0.1), 4e-4);
    EXPECT_LT(MeansOff::all_but(off.other, 0.03), 5e-4);
  });
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
    CellScratch scratch;
    LightGround ground;
    LightTile tile;
    set_distance(feet, ground, scratch, tile);
    ASSERT_FALSE(ground.crowded);
    test::SeenCells seen;
    for (int at = 0; at < 256; at += 7) {
      test::see(tile, at % 16, at / 16, seen);
      for (std::size_t q = 0; q < 16; ++q) {
        const double own = distance.at(test::place(seen, at % 16, at / 16, q));
        const double by = std::abs(told(seen.c[3][q]) - own);
        ++all, off += by > 2e-3;
        EXPECT_LT(by, 0.05);
      }
    }
  }
  EXPECT_LE(double(off), 1e-5 * double(all));
}

}  // namespace
}  // namespace mien
