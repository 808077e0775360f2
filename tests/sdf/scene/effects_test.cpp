#include <mien/scene_effects.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

TEST(Effects, FallSoftly) {
  EXPECT_EQ(soft_edge(-1), 1);
  EXPECT_EQ(soft_edge(0), 1);
  EXPECT_EQ(soft_edge(0.5), 0.5);
  EXPECT_EQ(soft_edge(1), 0);
  EXPECT_EQ(soft_edge(7), 0);
  double worst = 0;  // of straight lines between 17 places
  for (double u = 0; u < 1; u += 1e-3) {
    const double a = std::floor(u * 16) / 16, b = a + 1.0 / 16, w = (u - a) * 16;
    worst = std::fmax(worst, std::abs(soft_edge(u) - ((1 - w) * soft_edge(a) + w * soft_edge(b))));
  }
  EXPECT_LT(worst, 0.003);
}

/// The opacity of the scene's only gradient at a point, by its own definition.
double opacity(const Scene& scene, glm::dvec2 p) {
  const Layer& layer = scene.layers()[0];
  const auto& along = std::get<DistanceGradient>(layer.paint.gradient->along);
  const double t = (scene.distance(along.area, p) - along.from) / (along.to - along.from);
  const auto& stops = layer.paint.gradient->stops;
  if (t <= 0) return layer.paint.color.a * stops.front().color.a;
  if (t >= 1) return layer.paint.color.a * stops.back().color.a;
  const double place = t * double(stops.size() - 1), i = std::floor(place);
  const double a = stops[std::size_t(i)].color.a, b = stops[std::size_t(i) + 1].color.a;
  return layer.paint.color.a * (a + (place - i) * (b - a));
}

TEST(Effects, AGlowEndsAtItsReach) {
  SceneBuilder build({}, {1, 1, 1, 1});
  glow(build, "halo", build.shape(Disc{{0.1, 0}, 0.2}), {.color = {1, 1, 0, 0.8}, .reach = 0.1});
  const Scene scene = std::move(build).finish();
  EXPECT_EQ(opacity(scene, {0.1, 0}), 0.8);
  EXPECT_NEAR(opacity(scene, {0.35, 0}), 0.4, 1e-12);
  EXPECT_EQ(opacity(scene, {0.401, 0}), 0);
}

TEST(Effects, AShadowLiesWhereItIsShiftedTo) {
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.2}), hole = build.shape(Disc{{0, 0}, 0.05});
  soft_shadow(build, "shadow", build.subtract(disc, hole),
              {.color = {0, 0, 0, 0.5}, .blur = 0.02, .shift = {0.3, -0.1}});
  const Scene scene = std::move(build).finish();
  EXPECT_NEAR(opacity(scene, {0.5, -0.1}), 0.25, 1e-12);  // on its outline: half
  EXPECT_EQ(opacity(scene, {0.42, -0.1}), 0.5);
  EXPECT_EQ(opacity(scene, {0.3, -0.1}), 0);  // in its hole
  EXPECT_EQ(opacity(scene, {0.1, 0}), 0);
}

TEST(Effects, AContourIsARibbonAlongTheOutline) {
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area line = contour(build, build.shape(Disc{{0, 0}, 0.2}), 0.01);
  build.layer("line", line, {});
  const Scene scene = std::move(build).finish();
  EXPECT_NEAR(scene.distance(line, {0.205, 0}), -0.005, 1e-15);
  EXPECT_NEAR(scene.distance(line, {0, 0.18}), 0.01, 1e-15);
}

/// The width along a normal is thin + thick + (thick − thin) times how much the normal looks `toward`.
TEST(Effects, APenContourIsThickOnOneSide) {
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.5});
  const Area line = pen_contour(build, disc, 0.01, 0.04, {0.6, -0.8});
  build.layer("line", line, {});
  const Scene scene = std::move(build).finish();
  const auto width = [&](glm::dvec2 n) {
    double inside = 0;
    constexpr double kStep = 1e-5;
    for (double r = 0.3; r < 0.6; r += kStep) inside += scene.distance(line, r * n) < 0 ? kStep : 0;
    return inside;
  };
  EXPECT_NEAR(width({0.6, -0.8}), 0.08, 3e-5);
  EXPECT_NEAR(width({-0.6, 0.8}), 0.02, 3e-5);
  EXPECT_NEAR(width({0.8, 0.6}), 0.05, 1e-3);  // the moved circle's normals differ a little
  for (const glm::dvec2 n : {glm::dvec2{0.6, -0.8}, {-0.6, 0.8}, {0.8, 0.6}, {1, 0}, {0, 1}}) {
    EXPECT_LT(scene.distance(line, 0.509 * n), 0) << "no gap outside";
    EXPECT_LT(scene.distance(line, 0.491 * n), 0) << "no gap inside";
    EXPECT_GT(scene.distance(line, 0.511 * n), 0) << "it grows inwards";
  }
}

TEST(Effects, AShadowFallsOnOneAreaAlone) {
  SceneBuilder build({}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.2}), wall = build.shape(Disc{{1, 0}, 0.5});
  soft_shadow(build, "all", disc, {.color = {0, 0, 0, 1}, .blur = 0.1});
  soft_shadow(build, "wall", disc, {.color = {0, 0, 0, 1}, .blur = 0.1, .on = wall});
  const Scene scene = std::move(build).finish();
  EXPECT_LT(scene.distance(scene.layers()[0].area, {0, 3}), 0);
  EXPECT_EQ(scene.layers()[1].area.node, wall.node);
}

}  // namespace
}  // namespace mien
