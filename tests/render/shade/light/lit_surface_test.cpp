#include "render/shade/light/lit_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "render/shade/paint_table.h"
#include "tests/support/scenes/lit_scene.h"

namespace mien {
namespace {

TEST(LitSurface, HasAZoneBetweenTwoKinksOfItsProfile) {
  test::Random random(3);
  auto scene = test::random_lit(random, 3, 60, Profile::custom, Blend::srgb);
  GridRelief& relief = *scene.paint.relief;
  relief.width = 6, relief.height = 3, relief.table = {0, 1, 1, 0};
  const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
  ASSERT_EQ(surface.zones(), 5);
  const double depths[] = {-1, 1, 3, 5, 7};
  for (int zone = 0; zone < 5; ++zone) {
    EXPECT_EQ(surface.zone_of(-depths[zone]), zone);
    EXPECT_NEAR(surface.rise(zone, depths[zone]), zone == 1 ? 1.5 : zone == 3 ? -1.5 : 0.0, 1e-12);
  }
  EXPECT_TRUE(surface.flat(0) && surface.flat(2) && surface.flat(4));
  EXPECT_FALSE(surface.flat(1) || surface.flat(3));
}

TEST(LitSurface, KnowsTheGradientOfItsDistance) {
  test::Random random(4);
  for (int kind = 0; kind < test::kLitShapes; ++kind) {
    const auto scene = test::random_lit(random, kind, 40, Profile::bevel, Blend::srgb);
    const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
    const glm::dvec2 p = random.point(20, 44);
    const Outward at = surface.outward(p);
    EXPECT_NEAR(glm::length(at.normal), 1.0, 1e-9);
    EXPECT_NEAR(surface.outward(p + 0.01 * at.normal).d, at.d + 0.01, 1e-3);
  }
}

/// A table whose only layer has that relief, 100 px a unit; the layer is its area, or everywhere.
std::unique_ptr<PaintTable> table_of(const Relief& relief, bool own = true,
                                     Color color = {1, 1, 1, 1}) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  const Area disc = build.shape(Disc{{0, 0}, 0.5});  // area 0
  build.layer("layer", own ? disc : build.everywhere(), {.color = color, .relief = shared(relief)});
  auto table = std::make_unique<PaintTable>();
  table->make(std::move(build).finish(), {.width = 200, .height = 200}, Depth::u8);
  return table;
}

double rise_at(const PaintTable& table, double depth) {
  const LitSurface& surface = table.lit.at(0).surface();
  return surface.rise(surface.zone_inside(-depth), depth);
}

TEST(LitSurface, RisesAsItsProfileSays) {
  const auto bevel =
      table_of({.area = {0}, .profile = Profile::bevel, .width = 0.1, .height = 0.05});
  EXPECT_NEAR(rise_at(*bevel, 5), 0.5, 1e-15);
  EXPECT_EQ(rise_at(*bevel, 10.01), 0);
  EXPECT_NEAR(rise_at(*bevel, -0.005), 0.5, 1e-15);  // a rounding beyond the outline
  EXPECT_EQ(rise_at(*bevel, -1), 0);
  const auto beside =
      table_of({.area = {0}, .profile = Profile::bevel, .width = 0.1, .height = 0.05}, false);
  EXPECT_EQ(rise_at(*beside, -0.005), 0);  // the layer goes on there
  const auto round =
      table_of({.area = {0}, .profile = Profile::round, .width = 0.1, .height = 0.1});
  for (const double x : {0.5, 2.0, 9.0}) {  // the slope of its own height
    const auto height = [](double inside) {
      return std::sqrt(100 - (10 - inside) * (10 - inside));
    };
    EXPECT_NEAR(rise_at(*round, x), (height(x + 1e-6) - height(x - 1e-6)) / 2e-6, 1e-6);
  }
  const auto table = table_of(
      {.area = {0}, .profile = Profile::custom, .width = 0.1, .height = 0.1, .table = {0, 1, 0.5}});
  EXPECT_NEAR(rise_at(*table, 2), 2, 1e-14);
  EXPECT_NEAR(rise_at(*table, 7), -1, 1e-14);
}

TEST(LitSurface, AddsDomes) {  // C: the hook of the cornea's bulge
  const auto table =
      table_of({.domes = {{.center = {0.1, 0.05}, .radii = {0.2, 0.1}, .height = 0.03}}});
  const auto height = [](glm::dvec2 p) {  // in pixels, y down
    const glm::dvec2 q = (p - glm::dvec2{110, 95}) / glm::dvec2{20, 10};
    const double in = 1 - (q.x * q.x + q.y * q.y);
    return in > 0 ? 3 * in * in : 0;
  };
  for (const glm::dvec2 p : {glm::dvec2{112, 93}, {125, 97}, {110, 95}, {131, 95}}) {
    const glm::dvec2 slope = table->lit.at(0).surface().slope(0, p, {});
    EXPECT_NEAR(slope.x, (height(p + glm::dvec2{1e-5, 0}) - height(p - glm::dvec2{1e-5, 0})) / 2e-5,
                1e-8);
    EXPECT_NEAR(slope.y,
                -(height(p + glm::dvec2{0, 1e-5}) - height(p - glm::dvec2{0, 1e-5})) / 2e-5, 1e-8);
  }
}

constexpr Color kDark{0.1, 0.1, 0.1, 1};

/// By Gauss's four places and by many.
TEST(LitSurface, KnowsWhereAHighlightMayHideFromAFewPlaces) {
  Relief relief{.domes = {{.center = {0.1, 0.05}, .radii = {0.2, 0.1}, .height = 0.3}}};
  relief.specular = 0.9, relief.shininess = 60;
  const auto table = table_of(relief, true, kDark);
  const LitSurface& surface = table->lit.at(0).surface();
  constexpr double kHalf = 0.25, kGauss = 0.57735026918962576, kNear = 0.004;
  int hidden = 0, missed = 0;
  for (int i = 0; i < 12000; ++i) {
    const glm::dvec2 middle{50.1 + 0.85 * (i % 120), 50.3 + i / 120};
    const auto seen = [&](glm::dvec2 p) { return surface.color(0, middle + kHalf * p, {}).r; };
    double few = 0, many = 0;
    for (const double x : {-kGauss, kGauss})
      for (const double y : {-kGauss, kGauss}) few += seen({x, y}) / 4;
    constexpr int kMany = 16;
    for (int k = 0; k < kMany * kMany; ++k)
      many += seen((glm::dvec2{k % kMany, k / kMany} + 0.5) * (2.0 / kMany) - 1.0);
    many /= kMany * kMany;
    const bool hides = surface.highlight_hides(0, middle, {}, 1.4143 * kHalf);
    hidden += hides, missed += std::abs(few - many) > kNear;
    if (!hides) {
      EXPECT_NEAR(few, many, kNear) << middle.x << ' ' << middle.y;
    }
  }
  EXPECT_GT(missed, 0);
  EXPECT_LT(hidden, 3000);
}

TEST(LitSurface, KnowsThatAHighlightMayHideAtARoundProfilesOutline) {
  Relief relief{.area = {0}, .profile = Profile::round, .width = 0.3, .height = 0.007};
  relief.specular = 0.9, relief.shininess = 60;
  const auto table = table_of(relief, true, kDark);
  const LitSurface& surface = table->lit.at(0).surface();
  const glm::dvec3& h = surface.relief().lamp.halfway();
  const glm::dvec2 to_lamp = glm::normalize(glm::dvec2{h.x, -h.y});  // y down
  const auto hides = [&](glm::dvec2 way, double depth, double reach) {
    const glm::dvec2 p = glm::dvec2{100, 100} + (50 - depth) * way;
    return surface.highlight_hides(1, p, surface.outward(p), reach);
  };
  EXPECT_TRUE(hides(to_lamp, 0.1, 0.1));
  EXPECT_FALSE(hides(to_lamp, 0.1, 0.001));
  EXPECT_FALSE(hides(to_lamp, 10, 0.1));
}

}  // namespace
}  // namespace mien
