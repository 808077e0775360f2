#include "sdf/arrange/foreseen.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "lib/base/watch.h"
#include "sdf/arrange/sweep.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

constexpr double kForeseenSide = 64;
const OutlineFrame kForeseenFrame{{}, {{0, 0}, {kForeseenSide, kForeseenSide}}, 1.0 / 800};

/// All regions look alike.
class BlindRule final : public LookRule {
 public:
  int state_words() const override { return 0; }
  int first_look(std::uint64_t*) override { return 0; }
  int look(const std::uint64_t*, int, const std::uint64_t*, int, std::uint64_t*) override {
    return 0;
  }
};

QuadBezier straight_side(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

/// Of straight and bent sides, partly outside of the window; kinds: anywhere, on a lattice, to and fro on a line, around
/// a circle, and forth and back the same way.
Path foreseen_path(Random& r, int points, int kind) {
  std::vector<glm::dvec2> at;
  for (int i = 0; i < points; ++i) {
    const double turn = 6.283185307179586 * i / points, along = r.between(-10, kForeseenSide + 10);
    const double x = 4.0 * r.below(19) - 4.0, y = 4.0 * r.below(19) - 4.0;
    at.push_back(kind == 1   ? glm::dvec2{x, y}
                 : kind == 2 ? glm::dvec2{along, 0.5 * along}
                 : kind == 3
                     ? 0.5 * kForeseenSide + 25.0 * glm::dvec2{std::cos(turn), std::sin(turn)}
                     : r.point(-10, kForeseenSide + 10));
  }
  if (kind == 4) {  // the circle's first half and back
    const std::size_t half = at.size() / 2;
    for (std::size_t i = half; i < at.size(); ++i) at[i] = at[2 * half - i];
  }
  Path path{{Path::Loop{}}, r.below(2) ? FillRule::even_odd : FillRule::nonzero};
  for (std::size_t i = 0; i < at.size(); ++i) {
    const glm::dvec2 a = at[i], b = at[(i + 1) % at.size()];
    path.loops[0].sides.push_back(r.below(4) ? straight_side(a, b)
                                             : QuadBezier{a, a + r.point(-3, 3), b});
  }
  return path;
}

Scene foreseen_paths(Random& r) {
  SceneBuilder build({.box = {{0, 0}, {kForeseenSide, kForeseenSide}}}, {1, 1, 1, 1});
  for (int i = 1 + r.below(3); i > 0; --i) {
    const int kind = r.below(5), points = 3 + r.below(kind >= 2 && r.below(2) ? 2000 : 40);
    const Area path = build.shape(foreseen_path(r, points, kind));
    build.layer("", points > 40 || r.below(2) ? path : build.offset(path, r.between(-1, 1)), {});
  }
  return std::move(build).finish();
}

/// What arranging the scene's outlines holds at most [bytes].
std::uint64_t held_by(const AreaPrograms& programs, const RenderLimits& limits) {
  Watch watch({}, limits);
  const Watching here(&watch);
  Outlines outlines;
  OutlineMaker maker;
  maker.begin(kForeseenFrame, outlines);
  for (const OutlineSource& source : programs.outlines()) maker.add(programs, source);
  maker.finish();
  BlindRule rule;
  Regions regions;
  regions.begin(int(outlines.rules.size()), rule);
  Sweep().run(outlines, 0, kForeseenSide, regions);
  return watch.memory();
}

TEST(Foreseen, IsNeverMoreThanIsHeld) {
  Random r(1);
  int much = 0;
  for (int i = 0; i < 80; ++i) {
    const Scene scene = foreseen_paths(r);
    AreaPrograms programs;
    programs.begin(scene);
    for (const Layer& layer : scene.layers()) programs.add(layer.area);
    const std::uint64_t least = least_bytes(programs, programs.outlines(), kForeseenFrame),
                        most = held_by(programs, kWithoutLimits);
    ASSERT_LE(least, most) << i;
    much += 5 * least > most;
  }
  EXPECT_GT(much, 20);  // and of use
}

TEST(Foreseen, EndsWorkThatNeedsTooMuchBeforeItBegins) {
  Random r(3);
  SceneBuilder build({.box = {{0, 0}, {kForeseenSide, kForeseenSide}}}, {1, 1, 1, 1});
  build.layer("", build.shape(foreseen_path(r, 100'000, 0)), {});
  const Scene scene = std::move(build).finish();
  Watch watch({}, {.memory = 4 << 20});
  const Watching here(&watch);
  EXPECT_THROW(foresee(scene, kForeseenFrame), Stopped);
  EXPECT_EQ(watch.why(), Stopped::Why::foreseen);
  EXPECT_GT(watch.foreseen(), 4u << 20);
  EXPECT_EQ(watch.memory(), 0u);
  EXPECT_LT(watch.steps(), 20'000'000);  // each about a nanosecond
  Watch larger({}, {.memory = 256 << 20});
  const Watching there(&larger);
  EXPECT_NO_THROW(foresee(scene, kForeseenFrame));
}

}  // namespace
}  // namespace mien::test
