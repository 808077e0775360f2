#include "render/shade/look_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "render/blend/blender.h"
#include "tests/support/random/random.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::test {
namespace {

constexpr int kCount = 37, kRoom = kCount + int(kColorSpare);
using Plane = std::array<float, kRoom>;

/// Whole pixels from a column on.
struct Pixels {
  Plane column, zero{}, variance;
  explicit Pixels(int first) {
    for (std::size_t i = 0; i < kRoom; ++i) column[i] = float(first + int(i));
    variance.fill(1.0f / 12);
  }
  LanePlaces places() const {
    return {kCount,          column.data(), zero.data(),    zero.data(),
            variance.data(), zero.data(),   variance.data()};
  }
};

struct Shaded {
  ColorRow colors;
  std::vector<float> neglected, stack;
  float most;
  Shaded(const std::vector<LaneStep>& steps, const LanePlaces& at)
      : most(shade_lanes(steps, at, stack, colors, neglected)) {}
  Mix mix(std::size_t i) const { return {colors.r[i], colors.g[i], colors.b[i], colors.a[i]}; }
};

/// A part of a pixel: what lies beyond two lines.
struct CutPixel {
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  std::vector<glm::dvec2> places;

  explicit CutPixel(Random& r) {
    constexpr int kSide = 40;
    const double turn = r.between(0, 6.3), second = r.between(0, 6.3), at = r.between(-0.4, 0.4),
                 also = r.between(-0.5, 0.2);
    for (int k = 0; k < kSide * kSide; ++k) {
      const glm::dvec2 p{(k % kSide + 0.5) / kSide - 0.5, (k / kSide + 0.5) / kSide - 0.5};
      if (p.x * std::cos(turn) + p.y * std::sin(turn) < at) continue;
      if (p.x * std::cos(second) + p.y * std::sin(second) < also) continue;
      places.push_back(p), x += p.x, y += p.y, xx += p.x * p.x, xy += p.x * p.y, yy += p.y * p.y;
    }
    const double n = double(places.size());
    area = n / (kSide * kSide);
    if (places.empty()) return;
    x /= n, y /= n, xx = xx / n - x * x, xy = xy / n - x * y, yy = yy / n - y * y;
  }
};

/// Whatever their form, and however near the centre: what is neglected is what lanes report, or less.
TEST(LookLanes, TakeARadialRampsMeanOverPartsOfPixels) {
  on_every_set([] {
    Random r(4);
    for (int i = 0; i < 300; ++i) {
      const CutPixel part(r);
      if (part.places.size() < 30) continue;
      const double turn = r.between(0, 3), flat = i % 2 ? 1.0 : r.between(0.2, 1), size = 0.05;
      const glm::dvec2 u{size * std::cos(turn), -size * flat * std::sin(turn)},
          v{size * std::sin(turn), size * flat * std::cos(turn)};
      const glm::dvec2 middle{r.between(-4, 4), r.between(-4, 4)};
      LaneStep radial{.kind = LaneStep::Kind::radial};
      const glm::dvec2 q = u * (middle.x - 7) + v * middle.y;
      radial.origin = -7, radial.q = {float(q.x), float(q.y)};
      radial.by_x = {float(u.x), float(u.y)}, radial.by_y = {float(v.x), float(v.y)};
      radial.uxx = float(glm::dot(u, u)), radial.uxy = float(glm::dot(u, v));
      radial.uyy = float(glm::dot(v, v));
      radial.slope = {1, 0, 0, 0}, radial.length = 1;
      radial.neglects = float(0.0075 * size * size * size), radial.most = float(0.25 * size);
      Plane column{}, x, y, xx, xy, yy;
      x.fill(float(part.x)), y.fill(float(part.y));
      xx.fill(float(part.xx)), xy.fill(float(part.xy)), yy.fill(float(part.yy));
      double mean = 0;
      for (const glm::dvec2 p : part.places)
        mean += glm::length(u * (middle.x + p.x) + v * (middle.y + p.y));
      mean /= double(part.places.size());
      const Shaded got({{.kind = LaneStep::Kind::open}, radial},
                       {1, column.data(), x.data(), y.data(), xx.data(), xy.data(), yy.data()});
      ASSERT_LE(std::abs(double(got.colors.r[0]) - mean) * part.area,
                double(got.neglected[0]) * 1.01 + 2e-6)
          << i;
      ASSERT_GE(got.most, got.neglected[0]);
    }
  });
}

TEST(LookLanes, HoldARampBetweenItsEnds) {
  on_every_set([] {
    const LaneStep ramp{.kind = LaneStep::Kind::linear,
                        .color = {0.2f, 0.2f, 0.275f, 0.5625f},
                        .slope = {0.4f, 0.0f, -0.1f, 0.25f},
                        .from = 0.25f,
                        .length = 0.5f,
                        .q = {-0.25f, 0.0f},
                        .by_x = {1.0f / 30, 0.0f}};
    const Shaded got({{.kind = LaneStep::Kind::open, .color = {0.5f, 0, 0.25f, 0.75f}}, ramp},
                     Pixels(0).places());
    for (std::size_t k = 0; k < kCount; ++k) {
      const double at = std::clamp(double(k) / 30, 0.25, 0.75), keep = 0.5 - 0.25 * at;
      ASSERT_NEAR(got.colors.r[k], 0.5 * keep + 0.1 + 0.4 * at, 1e-6);
      ASSERT_NEAR(got.colors.g[k], 0.2, 1e-6);
      ASSERT_NEAR(got.colors.b[k], 0.25 * keep + 0.3 - 0.1 * at, 1e-6);
      ASSERT_NEAR(got.colors.a[k], 0.75 * keep + 0.5 + 0.25 * at, 1e-6);
    }
  });
}

TEST(LookLanes, MixGroupsAsTheBlenderDoes) {
  const Mix ground{0.3, 0.1, 0.2, 0.7}, low{0.1, 0.4, 0.05, 0.5}, top{0.2, 0.1, 0.3, 0.6};
  const auto floats = [](const Mix& m) {
    return std::array<float, 4>{float(m.r), float(m.g), float(m.b), float(m.a)};
  };
  on_every_set([&] {
    for (const MixMode mode : {MixMode::normal, MixMode::multiply, MixMode::screen}) {
      const Mix group = over(top, low);
      const Plane r =
                      [&] {
                        Plane p;
                        p.fill(float(top.r));
                        return p;
                      }(),
                  g =
                      [&] {
                        Plane p;
                        p.fill(float(top.g));
                        return p;
                      }(),
                  b =
                      [&] {
                        Plane p;
                        p.fill(float(top.b));
                        return p;
                      }(),
                  a = [&] {
                    Plane p;
                    p.fill(float(top.a));
                    return p;
                  }();
      const Shaded got(
          {{.kind = LaneStep::Kind::open, .color = floats(ground)},
           {.kind = LaneStep::Kind::open, .color = floats(low)},
           {.kind = LaneStep::Kind::given, .given = {r.data(), g.data(), b.data(), a.data()}},
           {.kind = LaneStep::Kind::close, .mode = mode, .color = {0, 0, 0, 0.5f}}},
          Pixels(3).places());
      const Mix want = blended(mode, 0.5 * group, ground);
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(got.mix(kCount - 1)[k], want[k], 1e-6);
      const Shaded flat({{.kind = LaneStep::Kind::open, .color = floats(ground)},
                         {.kind = LaneStep::Kind::over, .mode = mode, .color = floats(top)}},
                        Pixels(3).places());
      for (int k = 0; k < 4; ++k) ASSERT_NEAR(flat.mix(0)[k], blended(mode, top, ground)[k], 1e-6);
    }
  });
}

}  // namespace
}  // namespace mien::test
