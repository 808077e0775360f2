#include "render/shade/ramp_lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/every_instruction_set.h"
#include "tests/support/random.h"

namespace mien::test {
namespace {

constexpr int kCount = 37, kRoom = kCount + 16;
using Plane = std::array<float, kRoom>;

TEST(RampLanes, RadialPlacesAreMeansOfADistance) {
  on_every_set([] {
    Random r(1);
    for (int i = 0; i < 200; ++i) {
      const float size = float(r.between(0.01, 0.3)), turn = float(r.between(0, 3));
      const float c = std::cos(turn), s = std::sin(turn), flat = float(r.between(0.5, 1));
      // q = U p: U turns, then scales both axes.
      const float xx = size * c, xy = size * s, yx = -size * flat * s, yy = size * flat * c;
      const RadialLanes lanes{float(r.between(-3, 3)),
                              float(r.between(-3, 3)),
                              xx,
                              yx,
                              xx,
                              yx,
                              xy,
                              yy,
                              xx * xx + xy * xy + yx * yx + yy * yy,
                              1.0f / 12,
                              -9};
      Plane t;
      radial_places(lanes, kCount, t.data());
      for (int k = 0; k < kCount; ++k) {
        double sum = 0.0;  // over a pixel
        constexpr int kPlaces = 16;
        for (int j = 0; j < kPlaces * kPlaces; ++j) {
          const double u = (j % kPlaces + 0.5) / kPlaces - 0.5 + lanes.from + k,
                       v = (j / kPlaces + 0.5) / kPlaces - 0.5;
          sum += std::hypot(lanes.qx + double(xx) * u + double(xy) * v,
                            lanes.qy + double(yx) * u + double(yy) * v);
        }
        const double mean = sum / (kPlaces * kPlaces), off = 0.02 * double(size) * double(size);
        ASSERT_NEAR(double(t[std::size_t(k)]), mean,
                    off / std::max(mean, 0.5 * double(size)) + 1e-5);
      }
    }
  });
}

TEST(RampLanes, AreLaidOverWhatIsThereBetweenTheirEnds) {
  on_every_set([] {
    const RampLanes ramp{{0.1f, 0.2f, 0.3f, 0.5f}, {0.4f, 0.0f, -0.1f, 0.25f}, 0.25f, 0.75f};
    Plane t, r, g, b, a;
    for (std::size_t k = 0; k < kRoom; ++k) t[k] = float(k) / 30;
    r.fill(0.5f), g.fill(0.0f), b.fill(0.25f), a.fill(0.75f);
    lay_ramp(ramp, t.data(), kCount, r.data(), g.data(), b.data(), a.data());
    for (std::size_t k = 0; k < kCount; ++k) {
      const float at = std::clamp(t[k], 0.25f, 0.75f), keep = 0.5f - 0.25f * at;
      ASSERT_NEAR(r[k], 0.5f * keep + 0.1f + 0.4f * at, 1e-6f);
      ASSERT_NEAR(g[k], 0.2f, 1e-6f);
      ASSERT_NEAR(b[k], 0.25f * keep + 0.3f - 0.1f * at, 1e-6f);
      ASSERT_NEAR(a[k], 0.75f * keep + 0.5f + 0.25f * at, 1e-6f);
    }
  });
}

}  // namespace
}  // namespace mien::test
