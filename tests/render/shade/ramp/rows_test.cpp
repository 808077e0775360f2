#include "render/shade/ramp/rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/every_instruction_set.h"
#include "tests/support/random.h"
#include "tests/support/random_ramp.h"

namespace mien::test {
namespace {

ColorRow room() {
  ColorRow row;
  row.room_for(RampRows::kMost);
  return row;
}

TEST(RampRows, GiveMeansOverBoxes) {
  on_every_set([] {
    Random r(1);
    for (int i = 0; i < 200; ++i) {
      const Ramp ramp = random_ramp(r);
      RampIntegral integral;
      integral.make(ramp);
      const double size = std::pow(10, r.between(-3, 1)), turn = r.between(0, 6.3);
      RampPlane plane =
          integral.scaled({r.between(-9, 9), size * std::cos(turn), size * std::sin(turn)});
      if (i % 5 == 0) plane.gx = 0.0;
      if (i % 7 == 0) plane.gy = 0.0;
      if (i % 11 == 0) plane.gx *= 3e-4;
      RampRows rows;
      rows.make(integral, plane);
      ColorRow row = room();
      rows.means(64, 9, 0, RampRows::kMost, row);
      for (int k = 0; k < RampRows::kMost; k += 3) {
        const Mix mean = integral.box_mean({plane.at(64.5 + k, 9.5), plane.gx, plane.gy}, 1.0);
        // Of slopes that are narrower than kNarrow, places stand for their smear.
        ASSERT_NEAR(double(row.r[std::size_t(k)]), mean.r, i % 11 ? 2e-6 : 3e-4) << i << ' ' << k;
      }
    }
  });
}

TEST(RampRows, SayTheSameOfAPixelWhereverARunBegins) {
  Random r(2);
  const Ramp ramp = random_ramp(r);
  RampIntegral integral;
  integral.make(ramp);
  RampRows rows;
  rows.make(integral, integral.scaled({0.3, 0.17, 0.05}));
  ColorRow whole = room(), part = room();
  rows.means(128, 5, 0, RampRows::kMost, whole);
  rows.means(128, 5, 21, 9, part);
  for (std::size_t k = 0; k < 9; ++k) EXPECT_EQ(part.g[k], whole.g[21 + k]);
}

TEST(RampRows, HaveTheSameBitsOnEverySet) {
  Random r(3);
  const Ramp ramp = random_ramp(r);
  RampIntegral integral;
  integral.make(ramp);
  RampRows rows;
  rows.make(integral, integral.scaled({0.3, 0.37, -0.05}));
  ColorRow first;
  on_every_set([&] {
    ColorRow row = room();
    rows.means(0, 0, 0, RampRows::kMost, row);
    if (first.r.empty()) first = row;
    for (std::size_t k = 0; k < RampRows::kMost; ++k) ASSERT_EQ(row.b[k], first.b[k]);
  });
}

}  // namespace
}  // namespace mien::test
