#include "render/shade/light/lamp_lanes.h"

#include <gtest/gtest.h>

#include "render/shade/light/lit_cells.h"

#include "tests/support/every_instruction_set.h"
#include "tests/support/lit_scene.h"

namespace mien {
namespace {

/// The lanes' light at one place, by cells of which one has area.
Mix light_at(const LampLanes& lamp, int zone, const LitSurface& surface, glm::dvec2 offset,
             const Outward& outward, int which, LitCells& cells) {
  PartCells parts;
  whole_cells(4, parts);
  parts.area.fill(0.0f);
  const auto k = std::size_t(which);
  parts.area[k] = 1e-3f, parts.x[k] = 0.0f, parts.y[k] = 0.0f;
  cells.x = float(offset.x), cells.y = float(offset.y);
  const auto levels = surface.levels();
  cells.shallow = zone > 0 ? float(-levels[std::size_t(zone) - 1]) : -1e9f;
  cells.deep = std::size_t(zone) < levels.size() ? float(-levels[std::size_t(zone)]) : 1e9f;
  cells.foot = {float(outward.d), float(outward.normal.x), float(outward.normal.y), 0.0f};
  cells.take(parts, false);
  const LitMean mean = mean_of_cells(lamp, cells);
  return {mean.r, mean.g, mean.b, surface.paint().color.a};
}

/// Gives a paint a ramp of three stops, from a centre or along a line.
void under_ramp(GridPaint& paint, bool radial, Blend blend) {
  const std::vector<Stop> stops{
      {0.1, {0.9, 0.2, 0.3, 1}}, {0.5, {0.1, 0.4, 0.02, 1}}, {0.9, {1, 1, 1, 0.3}}};
  paint.ramp.emplace(Gradient{.along = LinearGradient{}, .stops = stops}, 0.75, blend);
  paint.field.kind = radial ? PaintField::Kind::radial : PaintField::Kind::linear;
  paint.field.center = {30, 35}, paint.field.unit = {0.04, 0.01, -0.01, 0.03};
  paint.field.across = {0.02, 0.01}, paint.field.shift = -0.3;
  ASSERT_TRUE(lanes_know(paint));
}

/// Every lane says what LitSurface does, on every instruction set.
TEST(LampLanes, AreTheTwinOfTheSurface) {
  test::on_every_set([] {
    test::Random random(31);
    LitCells cells;
    for (int k = 0; k < 160; ++k) {
      const Blend blend = k % 3 ? Blend::srgb : Blend::linear;
      auto scene = test::random_lit(random, k % test::kLitShapes, 40, Profile(1 + k % 3), blend);
      if (k % 4 == 1) under_ramp(scene.paint, k % 8 == 1, blend);
      const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
      const glm::dvec2 p = random.point(24, 40), middle{32, 32};
      const Outward at = surface.outward(p);
      const int zone = surface.zone_of(at.d);
      const double width = surface.relief().width;
      const bool steep = surface.relief().profile == Profile::round && at.d > -0.2 * width;
      if (zone == 0 || steep) continue;  // there a cell of some size is not a place
      LampLanes lamp;
      set_lamp(surface, zone, middle, 20, lamp);
      const Mix got = light_at(lamp, zone, surface, p - middle, at, k % 16, cells);
      const Mix want = surface.color(zone, p, at);
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], 1e-4) << k;
    }
  });
}

TEST(LampLanes, LeaveOutDomesThatDoNotReach) {
  test::Random random(32);
  auto scene = test::random_lit(random, 3, 40, Profile::bevel, Blend::srgb);
  auto& domes = scene.paint.relief->domes;
  domes.assign(1, {{10, 10}, glm::dmat2{0.25, 0, 0, 0.25}, 2.0, 4.0});
  const LitSurface surface(scene.paint, scene.distances, Blend::srgb, {0, 0});
  LampLanes lamp;
  set_lamp(surface, 1, {30, 10}, 13, lamp);
  EXPECT_TRUE(lamp.domes.empty());
  set_lamp(surface, 1, {26, 10}, 13, lamp);
  ASSERT_EQ(lamp.domes.size(), 1u);
  EXPECT_EQ(lamp.domes[0].x, -16.0f);
}

}  // namespace
}  // namespace mien
