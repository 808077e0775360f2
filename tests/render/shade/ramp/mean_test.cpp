#include "render/shade/ramp/mean.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random/random.h"
#include "tests/support/random/random_ramp.h"

namespace mien::test {
namespace {

// Right of a chord across a pixel, where a ramp's place is a plane in any number of cells.
TEST(RampMean, IsThatOfThePartInAnyNumberOfCells) {
  Random r(1);
  for (int i = 0; i < 40; ++i) {
    const Ramp ramp = random_ramp(r);
    RampIntegral integral;
    integral.make(ramp);
    const double a = r.between(0, 0.9), b = r.between(0, 0.9), turn = r.between(0, 6.3);
    const RampPlane plane{r.between(-1, 1), std::cos(turn), std::sin(turn)};
    Mix sum{0.0};
    double area = 0;
    constexpr int kSide = 700;
    for (int j = 0; j < kSide; ++j)
      for (int k = 0; k < kSide; ++k) {
        const double shift = double((j * 7919 + k * 104729) % 997) / 997 - 0.5,
                     x = (k + 0.5 + shift) / kSide, y = (j + 0.5 - shift) / kSide;
        if (x < a + (b - a) * y) continue;
        sum += ramp.color(plane.at(x - 0.5, y - 0.5)), area += 1;
      }
    const PartChord chord{float(a), 0, float(b), 1, 1};
    for (const int side : {1, 2, 5, 8}) {
      std::vector<RampPlane> cells;
      for (int k = 0; k < side * side; ++k)
        cells.push_back(
            integral.scaled({plane.at((k % side + 0.5) / side - 0.5, (k / side + 0.5) / side - 0.5),
                             plane.gx, plane.gy}));
      ASSERT_LT(largest(RampPartMean().of(integral, cells, side, {&chord, 1}) - sum / area), 2e-3)
          << i << ' ' << side;
    }
  }
}

TEST(RampMean, OfAllOfAPixelIsThatOfItsBorder) {
  Random r(2);
  const Ramp ramp = random_ramp(r);
  RampIntegral integral;
  integral.make(ramp);
  const RampBoxes cells{{integral.scaled({0.2, 0.3, 0.4})}, {{1, 1.0}}};
  ColorRow whole;
  ramp_means(integral, cells, whole, 0);
  const PartEntry left = PartEntry::whole();
  std::vector<PartChord> chords;
  chords_of_form({left, {}}, chords);
  ASSERT_EQ(chords.size(), 1u);
  EXPECT_NEAR(RampPartMean().of(integral, cells.planes, 1, chords).r, whole.r[0], 1e-7);
}

}  // namespace
}  // namespace mien::test
