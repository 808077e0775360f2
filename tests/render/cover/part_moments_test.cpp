#include "render/cover/part_moments.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "tests/support/random/random.h"
#include "tests/support/shapes/every_instruction_set.h"

namespace mien::test {
namespace {

/// x, y, xx, xy, yy right of it, and y, yy of what it leaves of all pixels after it, by very many places.
std::array<double, 7> counted(const PartStretch& s) {
  constexpr int kPlaces = 2000;
  std::array<double, 7> sum{};
  const auto at = [](double p, double m, double q, double u) {
    return p * (1 - u) * (1 - 2 * u) + m * 4 * u * (1 - u) + q * u * (2 * u - 1) - 0.5;
  };
  for (int i = 0; i < kPlaces; ++i) {
    const double u = (i + 0.5) / kPlaces, half = 0.5 / kPlaces;
    const auto y_at = [&](double v) { return at(s.yp, s.ym, s.yq, v); };
    const double x = at(s.xp, s.xm, s.xq, u), y = y_at(u), dy = y_at(u + half) - y_at(u - half);
    const double wide = 0.5 - x, x1 = (0.25 - x * x) / 2, x2 = (0.125 - x * x * x) / 3;
    const std::array<double, 7> f{x1, y * wide, x2, y * x1, y * y * wide, y, y * y};
    for (std::size_t k = 0; k < 7; ++k) sum[k] += f[k] * dy;
  }
  return sum;
}

TEST(PartMoments, AreThoseOfWhatLiesRightOfAParabola) {
  Random r(1);
  std::vector<PartStretch> stretches;
  for (int i = 0; i < 53; ++i) {
    const float x = float(r.between(0, 1)), y = float(r.between(0, 0.5)),
                to_x = float(r.between(0, 1)), to_y = float(r.between(0.5, 1));
    stretches.push_back({x, y, 0.5f * (x + to_x) + float(r.between(-0.1, 0.1)),
                         0.5f * (y + to_y) + float(r.between(-0.1, 0.1)), to_x, to_y, 1});
  }
  on_every_set([&] {
    PartMoments m;
    m.make(stretches);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const std::array<float, 7> got{m.x[i],  m.y[i],      m.xx[i],     m.xy[i],
                                     m.yy[i], m.rest_y[i], m.rest_yy[i]};
      const std::array<double, 7> want = counted(stretches[i]);
      for (std::size_t k = 0; k < 7; ++k) ASSERT_NEAR(double(got[k]), want[k], 1e-6) << k;
    }
  });
}

}  // namespace
}  // namespace mien::test
