#include <mien/render/tile/lane_paint.h>
#include <mien/render/tile/local_paint.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/support/every_instruction_set.h"
#include "tests/support/random.h"

namespace mien {
namespace {

Gradient random_gradient(test::Random& random) {
  Gradient gradient{LinearGradient{{0, 0}, {1, 0}}, {}};
  double at = random.between(-0.2, 0.3);
  for (int i = 2 + random.below(4); i > 0; --i) {
    gradient.stops.push_back({at,
                              {random.between(0, 1), random.between(0, 1), random.between(0, 1),
                               random.below(2) ? 1.0 : random.between(0.1, 1)}});
    if (random.below(4)) at += random.between(0.1, 0.5);  // else: a jump
  }
  gradient.extend = Extend(random.below(3));
  return gradient;
}

TapePaint random_paint(test::Random& random, Blend blend) {
  TapePaint paint;
  paint.color = mix_from_color({random.between(0, 1), random.between(0, 1), random.between(0, 1),
                                random.below(2) ? 1.0 : 0.6},
                               blend);
  if (random.below(2)) {
    paint.ramp.emplace(random_gradient(random), 1.0, blend);
    paint.field.kind = PaintField::Kind(random.below(3));
    paint.field.across = 0.05 * random.direction(), paint.field.shift = random.between(-1, 1);
    paint.field.center = random.point(-9, 9);
    paint.field.unit = 0.06 * glm::dmat2{1.0, 0.3, -0.2, 0.8};
    paint.field.from = -3, paint.field.scale = 0.1;
    if (paint.field.kind == PaintField::Kind::distance) paint.field.distance = 0;
  }
  if (paint.ramp && random.below(3) == 0) return paint;
  const Light light{.direction = {random.between(-1, 1), random.between(-1, 1), 0.8},
                    .ambient = 0.3};
  paint.relief = TapeRelief{.distance = 0,
                            .profile = Profile(random.below(4)),
                            .width = random.between(4, 40),
                            .height = random.between(-9, 20),
                            .table = {0, 0.5, 0.8, 0.7, 1},
                            .domes = {},
                            .lamp = Lamp(light, random.below(2) ? 0.5 : 0.0, 25)};
  if (random.below(2))
    paint.relief->domes.push_back(
        {random.point(-5, 5), 0.12 * glm::dmat2{1, 0.1, -0.1, 1.2}, random.between(-5, 5), 9});
  return paint;
}

/// One random paint seen at places of a cell, by lanes and one by one.
struct Case {
  std::vector<float> x, y;
  std::vector<std::int32_t> cell;
  TapePaint paint;
  LocalPaint local;
  LaneDistances distances;
  float cell_x, cell_y;

  explicit Case(test::Random& random, Blend blend) : paint(random_paint(random, blend)) {
    const glm::dvec2 at = random.point(-7, 7);
    cell_x = float(at.x), cell_y = float(at.y);
    const glm::dvec2 center{cell_x, cell_y}, slope = random.direction();
    local = {
        .paint = &paint, .blend = blend, .center = center, .side = 1, .place = {}, .distance = {}};
    local.distance = {.mean = random.between(-20, -1),
                      .x = slope.x,
                      .y = slope.y,
                      .xy = random.between(-0.01, 0.01)};
    distances.mean.push_back(float(local.distance.mean));
    distances.x.push_back(float(local.distance.x)), distances.y.push_back(float(local.distance.y));
    distances.xy.push_back(float(local.distance.xy));
    for (int i = 0; i < 37; ++i) {
      x.push_back(float(at.x + random.between(-0.5, 0.5)));
      y.push_back(float(at.y + random.between(-0.5, 0.5)));
      cell.push_back(0);
    }
  }

  std::array<std::vector<float>, 4> in_lanes() const {
    LanePaint lanes = *lane_paint(paint, local.blend, {0, 0});
    lanes.distance = lanes.place_distance = &distances;
    std::array<std::vector<float>, 4> planes;
    for (auto& plane : planes) plane.resize(x.size());
    const LaneLayer layer{.paint = 0};
    lane_colors({&layer, 1}, {&lanes, 1}, local.blend, {x, y, cell, &cell_x, &cell_y},
                {planes[0].data(), planes[1].data(), planes[2].data(), planes[3].data()});
    return planes;
  }

  Mix one(std::size_t i) const {
    const glm::dvec2 p{x[i], y[i]}, u = p - local.center;
    LocalPaint here = local;
    if (paint.ramp)
      here.place = {.mean = paint.field.at(p, local.distance.at(u))};  // at the place itself
    Mix color = paint.ramp ? paint.ramp->color(here.place.mean) : paint.color;
    return paint.relief ? paint.relief->lamp.lit(color, local.slope(u), local.blend) : color;
  }

  /// Where a step of float could be on the other side of a jump.
  bool near_a_kink(std::size_t i) const {
    const glm::dvec2 p{x[i], y[i]}, u = p - local.center;
    std::vector<double> kinks;
    const double d = local.distance.at(u), t = paint.field.at(p, d);
    if (paint.ramp) paint.ramp->range(t - 1e-4, t + 1e-4, kinks);
    bool near = !kinks.empty();
    if (paint.relief) {
      paint.relief->kinks(d - 1e-3, d + 1e-3, kinks);
      near |= !kinks.empty() || d > -1e-3;
    }
    return near;
  }
};

TEST(LanePaint, IsThePaintOnEveryInstructionSet) {  // G3
  for (const Blend blend : {Blend::linear, Blend::srgb})
    test::on_every_set([&] {
      test::Random random(11);
      int compared = 0;
      for (int n = 0; n < 300; ++n) {
        const Case c(random, blend);
        const auto planes = c.in_lanes();
        for (std::size_t i = 0; i < c.x.size(); ++i) {
          if (c.near_a_kink(i)) continue;
          ++compared;
          const Mix truth = c.one(i);
          for (int k = 0; k < 4; ++k)
            ASSERT_NEAR(planes[std::size_t(k)][i], truth[k], 4e-5) << n << ' ' << i << ' ' << k;
        }
      }
      EXPECT_GT(compared, 8000);
    });
}

TEST(LanePaint, HasTheSameBitsWhereMultiplyAddIsFused) {
  test::Random random(12);
  std::vector<Case> cases;
  for (int n = 0; n < 100; ++n) cases.emplace_back(random, n % 2 ? Blend::linear : Blend::srgb);
  for (Case& c : cases) c.local.paint = &c.paint;
  std::vector<std::array<std::vector<float>, 4>> first;
  for (const auto& set : batch::instruction_sets()) {
    if (!set.fused) continue;
    batch::use_instruction_set(set.id);
    for (std::size_t n = 0; n < cases.size(); ++n) {
      const auto planes = cases[n].in_lanes();
      if (first.size() <= n) first.push_back(planes);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_EQ(0, std::memcmp(planes[k].data(), first[n][k].data(), 4 * planes[k].size()))
            << set.name << ' ' << n;
    }
  }
  batch::use_instruction_set(0);
}

TEST(LanePaint, StoresAsPixelsAreStored) {
  for (const Blend blend : {Blend::linear, Blend::srgb})
    test::on_every_set([&] {
      test::Random random(13);
      alignas(64) float planes[4][256], carry[256];
      std::array<Mix, 256> mixes;
      for (int i = 0; i < 256; ++i) {
        const double a = i % 3 ? 1.0 : random.between(0, 1);
        mixes[std::size_t(i)] = {a * random.between(0, 1), a * random.between(0, 1),
                                 i == 7 ? a : 0.001 * a * i, a};
        if (i == 9) mixes[9] = Mix{0.0};
        for (int c = 0; c < 4; ++c) planes[c][i] = float(mixes[std::size_t(i)][c]);
        carry[i] = i % 2 ? 0.5f : float(dither_threshold(i, 3 * i));
      }
      std::uint32_t pixels[256];
      lane_pixels({planes[0], planes[1], planes[2], planes[3]}, blend, carry, 256, pixels);
      int other = 0;
      for (int i = 0; i < 256; ++i) {
        std::uint8_t truth[4], here[4];
        std::memcpy(here, &pixels[i], 4);
        if (i % 2)
          store(mixes[std::size_t(i)], blend, Depth::u8, truth);
        else
          store_dithered(mixes[std::size_t(i)], blend, Depth::u8, i, 3 * i, truth);
        for (int c = 0; c < 4; ++c) {
          ASSERT_NEAR(int(here[c]), int(truth[c]), 1) << i << ' ' << c;
          other += here[c] != truth[c];
        }
      }
      EXPECT_LE(other, 2);
    });
}

}  // namespace
}  // namespace mien
