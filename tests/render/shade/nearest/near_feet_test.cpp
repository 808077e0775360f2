#include "render/shade/nearest/near_feet.h"
#include "lib/base/watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

constexpr double kStep = 1e-5;

glm::dvec2 gradient(const AreaDistance& area, glm::dvec2 p) {
  const double d = area.at(p);
  return glm::dvec2{area.at({p.x + kStep, p.y}) - d, area.at({p.x, p.y + kStep}) - d} / kStep;
}

/// Distances, gradients and bends at 16 places of a disc of radius 13, against the area's own.
void check(const AreaDistance& area, glm::dvec2 middle, test::Random& random, long& far_off) {
  const FeetArea feet_area(area, {0, 0});
  NearFeet feet;
  feet.narrow(feet_area, middle, 13.0);
  float x[16], y[16], d[16], nx[16], ny[16], bend[16];
  for (int i = 0; i < 16; ++i)
    x[i] = float(random.between(-9, 9)), y[i] = float(random.between(-9, 9));
  feet.at(x, y, {d, nx, ny, bend});
  for (int i = 0; i < 16; ++i) {
    const glm::dvec2 p = middle + glm::dvec2{x[i], y[i]};
    EXPECT_NEAR(d[i], area.at(p), 1e-3);
    // At ridges and close to the evolute the gradient may be either's, or late.
    const glm::dvec2 g = gradient(area, p);
    far_off += !(std::hypot(g.x - double(nx[i]), g.y - double(ny[i])) < 0.02);
  }
}

TEST(NearFeet, AreTheAreasOwnDistancesAndGradients) {
  test::on_every_set([] {
    test::Random random(5);
    long far_off = 0, all = 0;
    for (int k = 0; k < 800; ++k, all += 16) {
      const AreaDistance area =
          test::random_area(random, k % test::kLitShapes, random.between(6, 60));
      check(area, random.point(16, 48), random, far_off);
    }
    EXPECT_LT(double(far_off), 2e-3 * double(all));
  });
}

/// A closed path of `sides` sides through random places; of one kind a side is missing, which closes it by itself.
Path crossing_path(test::Random& random, int sides, bool bent, bool open) {
  Path path{{Path::Loop{}}, random.chance(0.5) ? FillRule::nonzero : FillRule::even_odd};
  const glm::dvec2 first = random.point(0, 64);
  glm::dvec2 from = first;
  for (int i = 0; i < sides; ++i) {
    const glm::dvec2 to = i + 1 < sides ? random.point(0, 64) : first;
    const glm::dvec2 by = bent ? random.point(0, 64) : 0.5 * (from + to);
    if (!open || i + 1 < sides) path.loops[0].sides.push_back({from, by, to});
    from = to;
  }
  return path;
}

TEST(NearFeet, OfPathsThatCrossThemselves) {
  test::Random random(7);
  long far_off = 0, all = 0;
  for (const int sides : {4, 5, 20, 60, 130})
    for (const bool bent : {false, true})
      for (const bool open : {false, true})
        for (int k = 0; k < 10; ++k, all += 16) {
          SceneBuilder build({.box = {{0, 0}, {64, 64}}, .y_up = false}, {1, 1, 1, 1});
          const Area path = build.shape(crossing_path(random, sides, bent, open));
          const Scene scene = std::move(build).finish();
          check(AreaDistance(scene, path, {glm::dmat2(1.0), {0, 0}}), random.point(8, 56), random,
                far_off);
        }
  EXPECT_LT(double(far_off), 0.02 * double(all));  // ridges are dense here
}

/// What is asked for one place at a time takes a thousand steps and more.
TEST(NearFeet, OfCrossingsTakeFewSteps) {
  test::Random random(8);
  for (const int sides : {4, 30, 100}) {
    SceneBuilder build({.box = {{0, 0}, {64, 64}}, .y_up = false}, {1, 1, 1, 1});
    const Area path = build.shape(crossing_path(random, sides, false, false));
    const Scene scene = std::move(build).finish();
    const AreaDistance area(scene, path, {glm::dmat2(1.0), {0, 0}});
    Watch watch;
    constexpr int kTimes = 1000;  // the tree is made once
    {
      const Watching here(&watch);
      const FeetArea feet_area(area, {0, 0});
      NearFeet feet;
      feet.narrow(feet_area, {32, 32}, 13.0);
      float x[16] = {}, y[16] = {}, d[16], nx[16], ny[16], bend[16];
      for (int i = 0; i < kTimes; ++i) feet.at(x, y, {d, nx, ny, bend});
    }
    EXPECT_LT(double(watch.steps()) / (16 * kTimes), 500.0) << sides;
  }
}

TEST(NearFeet, TellHowTheGradientTurns) {
  test::Random random(6);
  const AreaDistance area = test::random_area(random, 3, 50);  // a disc of radius 20
  const auto& disc = std::get<Disc>(area.shapes()[0]);
  const FeetArea feet_area(area, {0, 0});
  NearFeet feet;
  feet.narrow(feet_area, disc.center + glm::dvec2{12, 0}, 13.0);
  float x[16] = {}, y[16] = {}, d[16], nx[16], ny[16], bend[16];
  feet.at(x, y, {d, nx, ny, bend});
  EXPECT_NEAR(bend[0], 1.0 / 12.0, 1e-5);
  EXPECT_NEAR(nx[0], 1.0, 1e-6);
  EXPECT_NEAR(d[0], 12.0 - disc.radius, 1e-5);
}

/// There the way to the foot is no longer than roundings of it.
TEST(NearFeet, KnowTheGradientOnAStrokesSpine) {
  test::on_every_set([] {
    const QuadBezier spine{{-420.8, -282.9}, {-29.8, -373.1}, {4.0, 17.9}};
    SceneBuilder scene({}, {});
    const Area stroke = scene.shape(TaperedStroke{spine, {67.7, 112.8, 26.3}});
    const AreaDistance area(std::move(scene).finish(), stroke, {});
    const FeetArea feet_area(area, {0, 0});
    for (const double t : {0.3, 0.6, 0.9, 0.97}) {
      const glm::dvec2 on =
          (1 - t) * (1 - t) * spine.p0 + 2 * t * (1 - t) * spine.p1 + t * t * spine.p2;
      NearFeet feet;
      feet.narrow(feet_area, on, 13.0);
      float x[16] = {}, y[16] = {}, d[16], nx[16], ny[16], bend[16];
      for (int i = 0; i < 16; ++i) x[i] = (i < 8 ? -0.003f : 0.003f) * float(1 + i % 8);
      feet.at(x, y, {d, nx, ny, bend});
      for (int i = 0; i < 16; ++i) {
        const glm::dvec2 g = gradient(area, on + glm::dvec2{x[i], y[i]});
        EXPECT_NEAR(double(nx[i]), g.x, 5e-4) << t << ", " << i;
        EXPECT_NEAR(double(ny[i]), g.y, 5e-4) << t << ", " << i;
      }
    }
  });
}

}  // namespace
}  // namespace mien
