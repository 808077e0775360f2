#include "render/svg/area_boundary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/process/effort.h"
#include "tests/support/random/random_scene.h"

namespace mien {
namespace {

constexpr double kTolerance = 1e-3;
const Box2 kWindow{{0, 0}, {64, 64}};
const Map<GridSpace, FaceSpace> kMap{glm::dmat2{32, 0, 0, -32}, {32, 32}};

/// How often the loops wind around p, by where the level ray from p to the left meets them.
int winding(const AreaBoundary& boundary, glm::dvec2 p) {
  int sum = 0;
  const auto chord = [&](glm::dvec2 a, glm::dvec2 b) {
    if ((a.y <= p.y) == (b.y <= p.y)) return;
    const double x = a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
    if (x < p.x) sum += a.y < b.y ? 1 : -1;
  };
  for (const FragmentLoop& loop : boundary.loops) {
    glm::dvec2 at = loop.start;
    for (const LoopSide& side : loop.sides) {
      constexpr int kParts = 200;
      glm::dvec2 from = at;
      for (int i = 1; i <= (side.straight ? 1 : kParts); ++i) {
        const double t = side.straight ? 1.0 : double(i) / kParts, s = 1 - t;
        const glm::dvec2 to =
            t == 1.0 ? side.to : s * s * at + 2 * s * t * side.control + t * t * side.to;
        chord(from, to);
        from = to;
      }
      at = side.to;
    }
    EXPECT_EQ(at, loop.start);
  }
  return sum;
}

/// Whether places are inside as the distance says, but for those as near to the outline as the tolerance.
long wrong_places(const Scene& scene, std::span<const AreaLevel> all,
                  const AreaBoundary& boundary) {
  long wrong = 0;
  const auto back = inverse(kMap);
  for (double y = 0.31; y < 64; y += 2.7)
    for (double x = 0.17; x < 64; x += 2.9) {
      bool inside = true, near = false;
      for (const AreaLevel& one : all) {
        const double d = (scene.distance(one.area, back({x, y})) - one.level) * 32;
        inside = inside && (d <= 0) != one.outside;
        near = near || std::abs(d) < 2 * kTolerance;
      }
      if (!near) wrong += winding(boundary, {x, y}) != int(inside);
    }
  return wrong;
}

TEST(AreaBoundary, HoldsWhatTheDistanceSays) {
  long wrong = 0;
  for (int seed = 0; seed < test::times(60); ++seed) {
    const Scene scene = test::random_painted_scene(std::uint64_t(seed) + 500);
    AreaBoundaries boundaries(scene, kMap, kWindow, kTolerance);
    for (const Layer& layer : scene.layers()) {
      const AreaLevel whole[] = {{layer.area}};
      const AreaLevel ring[] = {{layer.area, 0.05}, {layer.area, -0.03, true}};
      for (const std::span<const AreaLevel> all : {std::span<const AreaLevel>(whole), {ring}}) {
        const AreaBoundary boundary = boundaries.of(all);
        if (boundary.doubts == 0) wrong += wrong_places(scene, all, boundary);
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(AreaBoundary, IsCutToTheWindow) {
  SceneBuilder build({}, {});
  const Area everywhere = build.everywhere(), half = build.shape(HalfPlane{{1, 0}, 0.0}),
             nothing = build.complement(everywhere), far = build.shape(Disc{{9, 9}, 1});
  const Scene scene = std::move(build).finish();
  AreaBoundaries boundaries(scene, kMap, kWindow, kTolerance);
  EXPECT_TRUE(boundaries.of(everywhere).whole);
  EXPECT_TRUE(boundaries.of(Area{}).whole);
  EXPECT_EQ(boundaries.of(everywhere).loops.size(), 1u);
  const AreaBoundary left = boundaries.of(half);
  EXPECT_FALSE(left.whole);
  ASSERT_EQ(left.loops.size(), 1u);
  EXPECT_EQ(left.loops[0].sides.size(), 4u);
  for (const LoopSide& side : left.loops[0].sides) {
    EXPECT_TRUE(side.to.x == 0 || side.to.x == 32) << side.to.x;
    EXPECT_TRUE(side.to.y == 0 || side.to.y == 64) << side.to.y;
  }
  for (const Area none : {nothing, far}) {
    EXPECT_TRUE(boundaries.of(none).loops.empty());
    EXPECT_FALSE(boundaries.of(none).whole);
  }
}

/// The seam of two halves is not part of their union's boundary.
TEST(AreaBoundary, OfAUnionHasNoSeam) {
  SceneBuilder build({}, {});
  const Area disc = build.shape(Disc{{0, 0}, 0.5}), left = build.shape(HalfPlane{{1, 0}, 0.0});
  const Area both = build.unite(build.intersect(disc, left), build.subtract(disc, left));
  const Scene scene = std::move(build).finish();
  AreaBoundaries boundaries(scene, kMap, kWindow, kTolerance);
  const AreaBoundary one = boundaries.of(disc), two = boundaries.of(both);
  ASSERT_EQ(two.loops.size(), 1u);
  for (const LoopSide& side : two.loops[0].sides) EXPECT_FALSE(side.straight);
  EXPECT_LE(two.loops[0].sides.size(), one.loops[0].sides.size() + 2);
}

}  // namespace
}  // namespace mien
