#include "render/shade/light/lit_paint.h"
#include "render/shade/light/light_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "tests/support/exact/brute_light.h"
#include "tests/support/scenes/lit_scene.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien {
namespace {

struct Judged {
  long all = 0, over = 0;
  double worst = 0;
  void add(double levels) { ++all, over += levels > 0.3, worst = std::max(worst, levels); }
};

LitPart by_cells(const PartForm& form) {
  PartCells cells;
  cells_of_form(form, 4, cells);
  return part_of(form, cells);
}

/// By how much a pixel is off where much is asked of: by more and more places while it seems wrong.
template <class Ask>
double judged(test::BruteLight& brute, Blend blend, int zone, int x, int y, const Ask& ask,
              const std::function<bool(glm::dvec2)>& keeps = {}) {
  double off = 0.0;
  for (const int places : {24, 96, 300}) {
    const test::LitPart truth = brute.part(zone, x, y, places, keeps);
    if (truth.area < 0.005) return 0.0;
    off = truth.area * test::levels_apart(ask(truth), truth.mean, blend);
    if (off < 0.2) break;
  }
  return off;
}

/// Whole pixels, parts that the zone's ends leave, and parts cut by a straight line.
void judge(test::Random& random, int kind, double size, Profile profile, Blend blend, Judged& whole,
           Judged& own, Judged& cut) {
  const auto scene = test::random_lit(random, kind, size, profile, blend);
  const LitSurface surface(scene.paint, scene.distances, blend, {0, 0});
  const LitPaint paint(scene.paint, scene.distances, blend, {0, 0});
  LitPaint::Scratch scratch;
  test::BruteLight brute(surface);
  for (int k = 0; k < 60; ++k) {
    const int x = 8 + random.below(48), y = 8 + random.below(48);
    const double d = brute.middle(x, y);
    const int zone = surface.zone_of(d);
    if (zone == 0 || d < -surface.relief().width - 1.0 || paint.level(zone)) continue;
    const bool cuts = surface.zone_of(d - 0.71) != zone || surface.zone_of(d + 0.71) != zone;
    const glm::dvec2 way = random.direction(), middle{x + 0.5, y + 0.5};
    const double at = random.between(-0.4, 0.4);
    const auto keeps = [&](glm::dvec2 p) { return glm::dot(p - middle, way) < at; };
    const auto part = [&](const test::CountedForm& form) {
      return [&, form](const test::LitPart&) {
        const PartForm asked = form.form();
        return Mix(paint.part(zone, x, y, by_cells(asked), scratch));
      };
    };
    cut.add(judged(brute, blend, zone, x, y, part(brute.form(zone, x, y, keeps)), keeps));
    if (cuts) {
      own.add(judged(brute, blend, zone, x, y, part(brute.form(zone, x, y))));
      continue;
    }
    whole.add(judged(brute, blend, zone, x, y, [&](const test::LitPart&) {
      float r, g, b, a;
      paint.pixels(zone, x, y, 1, &r, &g, &b, &a, scratch);
      return Mix{r, g, b, a};
    }));
  }
}

TEST(LitPaint, MeansAreThoseOfVeryManyPlaces) {
  test::Random random(21);
  Judged whole, own, cut;
  for (int k = 0; k < 96; ++k)
    judge(random, k % test::kLitShapes, random.size(1, 1.7), Profile(1 + k / 8 % 3),
          k % 5 ? Blend::srgb : Blend::linear, whole, own, cut);
  const auto share = [](const Judged& j) { return double(j.over) / double(std::max(j.all, 1l)); };
  EXPECT_LT(share(whole), 0.02);
  EXPECT_LT(share(own), 0.05);
  EXPECT_LT(share(cut), 0.05);
}

TEST(LitPaint, DoesNotDependOnWhatWasAskedBefore) {
  test::on_every_set([] {
    test::Random random(23);
    for (int k = 0; k < 24; ++k) {
      const auto scene =
          test::random_lit(random, k % test::kLitShapes, 40, Profile(k % 4), Blend::srgb);
      const LitPaint one(scene.paint, scene.distances, Blend::srgb, {0, 0});
      const LitPaint other(scene.paint, scene.distances, Blend::srgb, {0, 0});
      const int zone = int(one.levels().size()) / 2;
      LitPaint::Scratch scratch, fresh;
      float row[4][64], single[4];
      for (int y = 40; y-- > 24;) {
        one.pixels(zone, 0, y, 64, row[0], row[1], row[2], row[3], scratch);
        const int x = random.below(64);
        const PartStretch half{0.3f, 0, 0.4f, 0.5f, 0.5f, 1, 1};
        const PartForm form{.stretches = {&half, 1}};
        other.part(zone, x, y, by_cells(form), fresh);
        other.pixels(zone, x, y, 1, &single[0], &single[1], &single[2], &single[3], fresh);
        for (int c = 0; c < 4; ++c)
          EXPECT_EQ(std::memcmp(&row[c][x], &single[c], sizeof(float)), 0) << k;
      }
    }
  });
}

TEST(LitPaint, LevelSurfacesKeepTheirColour) {
  test::Random random(27);
  auto scene = test::random_lit(random, 3, 60, Profile::round, Blend::srgb);
  scene.paint.relief->width = 5, scene.paint.relief->domes.clear();
  const LitPaint paint(scene.paint, scene.distances, Blend::srgb, {0, 0});
  EXPECT_TRUE(paint.level(0) && paint.level(2));
  EXPECT_FALSE(paint.level(1));
  LitPaint::Scratch scratch;
  float r, g, b, a;
  paint.pixels(2, 32, 32, 1, &r, &g, &b, &a, scratch);
  EXPECT_EQ(r, float(scene.paint.color.r));
  EXPECT_EQ(a, float(scene.paint.color.a));
}

}  // namespace
}  // namespace mien
