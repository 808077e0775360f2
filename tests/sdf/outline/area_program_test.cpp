#include "sdf/outline/area_program.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/process/effort.h"
#include "tests/support/process/runs_true.h"
#include "tests/support/random/random.h"
#include "tests/support/random/random_plain_scene.h"
#include "tests/support/shapes/shape_examples/all.h"

namespace mien::test {
namespace {

const Canvas kCanvas{{{-2, -2}, {2, 2}}, true};

/// A program's answer at a point, its outlines' bits by their shapes' distances; none where one of
/// them is too near to tell.
std::optional<bool> holds(const AreaPrograms& programs, const AreaProgram& program, glm::dvec2 p) {
  std::vector<std::uint64_t> bits(programs.outlines().size() / 64 + 1, 0);
  for (std::size_t i = 0; i < programs.outlines().size(); ++i) {
    const OutlineSource& of = programs.outlines()[i];
    double d = distance(programs.shape(of), p);
    for (int k = 1; k < of.count; ++k)
      d = std::min(d, distance(programs.shape({of.shape + k, 0.0, false}), p));
    const double e = of.rim ? std::abs(d) - of.amount : d - of.amount;
    if (std::abs(e) < 1e-9) return {};
    if (e < 0.0) bits[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  return runs_true(programs.steps(program), bits.data());
}

void expect_the_same_as_the_distance(const Scene& scene, Area area, double level, Random& r) {
  AreaPrograms programs;
  programs.begin(scene);
  const AreaProgram program = programs.add(area, level);
  for (int i = 0; i < 200; ++i) {
    const glm::dvec2 p = r.point(-2, 2);
    const double d = scene.distance(area, p) - level;
    const auto found = holds(programs, program, p);
    if (!found || std::abs(d) < 1e-9) continue;
    ASSERT_EQ(*found, d < 0.0) << p.x << ", " << p.y << " at level " << level;
  }
}

TEST(AreaProgram, OfEveryAreaOfRandomScenesItHoldsWhereTheDistanceIsAtMostTheLevel) {
  Random r(1);
  for (std::uint64_t seed = 0; seed < std::uint64_t(times(300)); ++seed) {
    const Scene scene = random_plain_scene(seed);
    SCOPED_TRACE(seed);
    for (const Layer& layer : scene.layers())
      for (const double level : {0.0, 0.07, -0.05})
        expect_the_same_as_the_distance(scene, layer.area, level, r);
    if (HasFatalFailure()) return;
  }
}

TEST(AreaProgram, OutlinesOfAnotherSceneAreTheSameIfAllTheirNumbersAre) {
  const auto made = [](std::vector<Disc> discs, double grown, AreaPrograms& programs) {
    SceneBuilder build(kCanvas, {});
    std::vector<Area> areas;
    for (const Disc& d : discs) areas.push_back(build.shape(d));
    for (const Area a : areas) build.layer("", a, {});
    Scene scene = std::move(build).finish();
    programs.begin(scene);
    for (const Area a : areas) programs.add(a, a.node == 1 ? grown : 0.0);
    return scene;
  };
  const Disc a{{0, 0}, 1}, b{{1, 0}, 0.5}, c{{0, 1}, 0.25}, d{{1, 1}, 0.125};
  const auto same = [&](std::vector<Disc> before, std::vector<Disc> now, double grown) {
    AreaPrograms p, q;
    const Scene s = made(before, 0.0, p), t = made(now, grown, q);
    std::vector<int> found;
    q.find_same(p, found);
    return found;
  };
  using Found = std::vector<int>;
  EXPECT_EQ(same({a, b, c}, {a, b, c}, 0), (Found{0, 1, 2}));
  EXPECT_EQ(same({a, b, c}, {a, d, c}, 0), (Found{0, -1, 2}));
  EXPECT_EQ(same({a, b, c}, {a, b, c}, 0.1), (Found{0, -1, 2})) << "at another level";
  EXPECT_EQ(same({a, b, c}, {a, c}, 0), (Found{0, 2}));
  EXPECT_EQ(same({a, c}, {a, b, c}, 0), (Found{0, -1, 1}));
  EXPECT_EQ(same({a, b, c, d}, {b, b, a, d}, 0), (Found{-1, -1, 3})) << "their order stays";
}

TEST(AreaProgram, EverywhereHoldsInsideOfNothing) {
  SceneBuilder build(kCanvas, {});
  build.layer("all", build.everywhere(), {});
  const Scene scene = std::move(build).finish();
  AreaPrograms programs;
  programs.begin(scene);
  const AreaProgram program = programs.add(scene.layers()[0].area);
  constexpr std::uint64_t kNothing = 0;
  EXPECT_TRUE(runs_true(programs.steps(program), &kNothing));
}

TEST(AreaProgram, AShapeMetAgainAtTheSameLevelIsTheSameOutline) {
  SceneBuilder build(kCanvas, {});
  const Area path = build.shape(Path{{{{{{0, 0}, {1, 0}, {1, 1}}, {{1, 1}, {0, 1}, {0, 0}}}}}});
  const Area grown = build.offset(path, 0.25), ring = build.shell(path, 0.25);
  build.layer("path", build.unite(grown, ring), {});
  const Scene scene = std::move(build).finish();
  AreaPrograms programs;
  programs.begin(scene);
  programs.add(scene.layers()[0].area);
  programs.add(scene.layers()[0].area);
  EXPECT_EQ(programs.outlines().size(), 2u);  // the path, and its rim
}

TEST(AreaProgram, ShellsOfShellsAndOffsetsOfOffsetsAreOfSingleShapes) {
  Random r(2);
  for (int seed = 0; seed < 200; ++seed) {
    SceneBuilder build(kCanvas, {});
    Area area = build.shape(Disc{r.point(-1, 1), r.unit()});
    Area other = build.shape(Ellipse{r.point(-1, 1), {0.2 + r.unit(), 0.1 + r.unit()}});
    for (int depth = 0; depth < 6; ++depth) {
      const double amount = r.between(-0.2, 0.3);
      switch (r.below(5)) {
        case 0:
          area = build.offset(area, amount);
          break;
        case 1:
          area = build.shell(area, amount);
          break;
        case 2:
          area = build.complement(area);
          break;
        case 3:
          area = build.subtract(other, area);
          break;
        default:
          area = build.unite(area, other);
      }
    }
    build.layer("layer", area, {});
    const Scene scene = std::move(build).finish();
    expect_the_same_as_the_distance(scene, area, 0.0, r);
    expect_the_same_as_the_distance(scene, area, r.between(-0.3, 0.3), r);
    if (HasFatalFailure()) return;
  }
}

TEST(AreaProgram, ABandWithoutCommonPointsGrowsIntoOne) {
  SceneBuilder build(kCanvas, {});
  const Area band = build.shape(Band{{{0, 0.05}, {0, 1}, 1.0}, {{0, -0.05}, {0, -1}, 1.0}});
  const Area grown = build.offset(band, 0.2);
  build.layer("band", grown, {});
  const Scene scene = std::move(build).finish();
  ASSERT_LT(scene.distance(grown, {0, 0}), 0.0);
  Random r(3);
  expect_the_same_as_the_distance(scene, grown, 0.0, r);
  expect_the_same_as_the_distance(scene, grown, 0.11, r);
  expect_the_same_as_the_distance(scene, grown, -0.1, r);
}

TEST(AreaProgram, LevelsWithoutEndAreEverythingOrNothing) {
  SceneBuilder build(kCanvas, {});
  build.layer("disc", build.shape(Disc{{0, 0}, 1}), {});
  const Scene scene = std::move(build).finish();
  AreaPrograms programs;
  programs.begin(scene);
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(holds(programs, programs.add(scene.layers()[0].area, inf), {5, 5}), true);
  EXPECT_EQ(holds(programs, programs.add(scene.layers()[0].area, -inf), {0, 0}), false);
}

TEST(AreaProgram, ShapesOfOthersCanBeAdded) {
  SceneBuilder build(kCanvas, {});
  build.layer("disc", build.shape(Disc{{0, 0}, 1}), {});
  const Scene scene = std::move(build).finish();
  AreaPrograms programs;
  programs.begin(scene);
  const AreaProgram own = programs.add(scene.layers()[0].area);
  const AreaProgram added = programs.add(Disc{{1, 0}, 0.5});
  EXPECT_EQ(holds(programs, added, {1.2, 0}), true);
  EXPECT_EQ(holds(programs, added, {0, 0}), false);
  EXPECT_EQ(holds(programs, own, {0, 0}), true);
}

TEST(AreaProgram, TreesOfAHundredThousandNodesNeedNoDeepStack) {
  SceneBuilder build(kCanvas, {});
  Area area = build.shape(Disc{{0, 0}, 1});
  for (int i = 0; i < 100'000; ++i) area = build.complement(area);
  build.layer("deep", area, {});
  const Scene scene = std::move(build).finish();
  AreaPrograms programs;
  programs.begin(scene);
  EXPECT_EQ(holds(programs, programs.add(area), {0.5, 0}), true);
}

}  // namespace
}  // namespace mien::test
