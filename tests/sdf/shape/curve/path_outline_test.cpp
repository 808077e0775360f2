#include "sdf/shape/curve/path_outline.h"
#include "lib/base/watch.h"
#include "sdf/shape/curve/path.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "tests/support/exact/exact_outline.h"
#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"
#include "tests/support/scenes/overlapping_paths.h"
#include "tests/support/shapes/shape_examples/path.h"

namespace mien::test {
namespace {

/// That the outline encloses what the path does, and that its distances are those to the outline by definition.
void expect_outline(const Path& path, const Path& outline, Random& r, double off,
                    const std::string& what) {
  const ExactOutline exact(path);
  for (int i = 0; i < times(300); ++i) {
    const glm::dvec2 p = r.point(-1.2, 1.2);
    const double d = exact.distance(p);
    ASSERT_NEAR(distance(outline, p), d, off) << what << " at " << p.x << ' ' << p.y;
    if (std::abs(d) > off) {
      ASSERT_EQ(winding(outline, p), d < 0 ? 1 : 0) << what << ": the inside is to the left";
    }
  }
  for (const QuadBezier& part : exact.stretches())
    ASSERT_NEAR(distance(outline, point(part, 0.5)), 0, off) << what;
  for (const QuadBezier& part : exact.hidden()) {
    const glm::dvec2 p = point(part, 0.5);
    ASSERT_NEAR(std::abs(distance(outline, p)), std::abs(exact.distance(p)), off) << what;
  }
}

TEST(PathOutline, IsWhatIsSeen) {
  Random r(1);
  for (const NamedPath& named : overlapping_paths()) {
    const auto outline = visible_outline(named.path);
    ASSERT_EQ(bool(outline), named.hides) << named.name;
    if (!outline) continue;
    expect_outline(named.path, *outline, r, 1e-11, named.name);
    EXPECT_TRUE(is_simple(*outline)) << named.name;
    EXPECT_FALSE(visible_outline(*outline)) << named.name;
  }
}

TEST(PathOutline, IsThePathItselfWhereNothingIsHidden) {
  for (std::size_t i = 0; i < kPaths.size(); ++i)
    if (is_simple(kPaths[i]) || kPaths[i].rule == FillRule::even_odd) {
      EXPECT_FALSE(visible_outline(kPaths[i])) << i;
    }
  EXPECT_FALSE(visible_outline(Path{}));
  EXPECT_FALSE(visible_outline(Path{{Path::Loop{}}}));
  EXPECT_FALSE(visible_outline({{polygon({{-1, 0}, {1, 0.5}})}})) << "it has no inside";
  for (NamedPath named : overlapping_paths()) {
    named.path.rule = FillRule::even_odd;
    EXPECT_FALSE(visible_outline(named.path)) << named.name;
  }
}

TEST(PathOutline, KeepsSidesThatNothingCutsAsTheyAre) {
  const Path path{{box({-0.7, -0.7}, {0.7, 0.7}), box({-0.2, -0.2}, {0.4, 0.4})}};
  const auto outline = visible_outline(path);
  ASSERT_TRUE(outline);
  ASSERT_EQ(outline->loops.size(), 1u);
  EXPECT_EQ(outline->loops[0].sides, path.loops[0].sides);
  const Path open{
      {{{{{-1, -1}, {0, -1}, {1, -1}}, {{1, -1}, {1, 0}, {1, 1}}}}, box({0.2, -0.6}, {0.6, 0.1})}};
  EXPECT_EQ(visible_outline(open)->loops[0].sides.size(), 3u) << "closed";
}

TEST(PathOutline, TurnsOnceAroundAPentagram) {
  const auto outline = visible_outline({{pentagram(1)}});
  ASSERT_TRUE(outline);
  ASSERT_EQ(outline->loops.size(), 1u);
  ASSERT_EQ(outline->loops[0].sides.size(), 10u);
  const double inner = std::cos(0.4 * std::numbers::pi) / std::cos(0.2 * std::numbers::pi);
  for (std::size_t i = 0; i < 10; ++i) {
    const QuadBezier& side = outline->loops[0].sides[i];
    EXPECT_EQ(side.p2, outline->loops[0].sides[(i + 1) % 10].p0);
    EXPECT_EQ(side.p1, 0.5 * (side.p0 + side.p2)) << "straight";
    EXPECT_NEAR(std::hypot(side.p0.x, side.p0.y), i % 2 ? inner : 1, 1e-15);
  }
}

/// Loops through places at random or on a coarse lattice, there with sides on each other, straight and bent; some
/// twice; all moved a little.
Path random_path(Random& r, double jitter) {
  Path path;
  const bool lattice = r.chance(0.5);
  const auto at = [&] {
    glm::dvec2 p = r.point(-1, 1);
    if (lattice) p = {std::round(3 * p.x) / 3, std::round(3 * p.y) / 3};
    return p + jitter * r.point(-1, 1);
  };
  for (int loops = 1 + int(r.below(3)); loops > 0; --loops) {
    std::vector<glm::dvec2> points;
    for (int i = 3 + int(r.below(5)); i > 0; --i) points.push_back(at());
    Path::Loop loop = r.chance(0.7) ? polygon(points) : smooth(points);
    for (QuadBezier& side : loop.sides)
      if (r.chance(0.3)) side.p1 = at();
    path.loops.push_back(loop);
    if (r.chance(0.1)) path.loops.push_back(r.chance(0.5) ? loop : reversed_loop(loop));
  }
  return path;
}

TEST(PathOutline, OfRandomPathsIsWhatIsSeen) {
  Random r(2);
  int found = 0;
  for (const double jitter : {0.0, 1e-15, 1e-6, 0.1})
    for (int i = 0; i < times(30); ++i) {
      const Path path = random_path(r, jitter);
      const auto outline = visible_outline(path);
      if (!outline) continue;
      ++found;
      expect_outline(path, *outline, r, jitter < 0.1 ? 1e-5 : 1e-9,
                     "path " + std::to_string(i) + ", " + std::to_string(jitter));
      if (HasFatalFailure()) return;
    }
  // Of few, under sanitizers, the count says nothing.
  EXPECT_TRUE(times(30) < 30 || found > 80) << found;
}

/// Sides that lie on each other but for about the tolerance: either is right.
TEST(PathOutline, OfSidesThatNearlyMeetEnclosesWhatThePathDoes) {
  Random r(7);
  for (const double jitter : {1e-14, 1e-13, 1e-12, 1e-11})
    for (int i = 0; i < times(100); ++i) {
      const Path path = random_path(r, jitter);
      const auto outline = visible_outline(path);
      for (int k = 0; outline && k < 50; ++k) {
        const glm::dvec2 p = r.point(-1.2, 1.2);
        if (std::abs(distance(path, p)) < 1e-6) continue;
        ASSERT_EQ(winding(*outline, p), winding(path, p) != 0) << i << ", " << jitter;
      }
    }
}

/// Sides are hidden where those of the exact outline are.
TEST(PathOutline, IsFoundWhereSidesAreHidden) {
  Random r(3);
  int hiding = 0, missed = 0;
  for (const double jitter : {0.0, 1e-6, 0.1})
    for (int i = 0; i < times(30); ++i) {
      const Path path = random_path(r, jitter);
      const ExactOutline exact(path);
      if (exact.hidden().empty() || exact.stretches().empty()) continue;
      ++hiding;
      missed += !visible_outline(path);
    }
  EXPECT_TRUE(times(30) < 30 || hiding > 60) << hiding;
  EXPECT_EQ(missed, 0);
}

TEST(PathOutline, IsFoundAtAnyScaleAndPlace) {
  for (const double scale : {1e-50, 1e-6, 1.0, 1e6, 1e50})
    for (const double shift : {0.0, 1e3})
      for (const NamedPath& named : overlapping_paths()) {
        if (!named.hides) continue;
        const Shape moved =
            transformed(glm::dmat2{scale}, scale * glm::dvec2{shift, -shift}, named.path);
        const auto outline = visible_outline(std::get<Path>(moved)),
                   own = visible_outline(named.path);
        ASSERT_TRUE(outline) << named.name << ' ' << scale << ' ' << shift;
        EXPECT_EQ(outline->loops.size(), own->loops.size())
            << named.name << ' ' << scale << ' ' << shift;
      }
}

Path tangle(int points, Random& r) {
  std::vector<glm::dvec2> places;
  for (int i = 0; i < points; ++i) places.push_back(r.point(-1, 1));
  return {{polygon(places)}};
}

TEST(PathOutline, IsNotLookedForWhereNumbersAreTooLargeOrSmall) {
  for (const double scale : {1e-100, 1e-300, 1e100, 1e300}) {
    const Shape scaled = transformed(glm::dmat2{scale}, {0, 0}, Path{{pentagram(1)}});
    EXPECT_FALSE(visible_outline(std::get<Path>(scaled))) << scale;
  }
}

TEST(PathOutline, OfManySidesIsFoundOrGivenUpSoon) {
  Random r(4);
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(visible_outline(tangle(100, r)));
  EXPECT_FALSE(visible_outline(tangle(1000, r))) << "it crosses itself more than 4096 times";
  EXPECT_FALSE(visible_outline(tangle(30'000, r)));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            2.0 * kThinning);
}

TEST(PathOutline, EndsWhenTheWatchDoes) {
  Random r(5);
  const Path path = tangle(300, r);
  Watch cancelled([] { return false; });
  cancelled.stop(Stopped::Why::cancelled);
  const Watching here(&cancelled);
  EXPECT_THROW((void)visible_outline(path), Stopped);
}

TEST(PathOutline, TellsWhatItHolds) {
  Random r(6);
  Watch watch({}, {.memory = 1000});
  const Watching here(&watch);
  EXPECT_THROW((void)visible_outline(tangle(100, r)), Stopped);
  EXPECT_GT(watch.memory(), 100'000u);
}

}  // namespace
}  // namespace mien::test
