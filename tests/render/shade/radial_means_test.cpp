#include "render/shade/radial_means.h"

#include <gtest/gtest.h>

#include <array>

#include "render/shade/paint.h"
#include "tests/support/every_instruction_set.h"
#include "tests/support/random.h"

namespace mien::test {
namespace {

TEST(RadialMeans, AreThoseOfTheFieldBitByBit) {
  on_every_set([] {
    Random r(2);
    constexpr std::size_t kPlaces = 64;
    for (int i = 0; i < 200; ++i) {
      PaintField field{
          .kind = PaintField::Kind::radial,
          .center = {r.between(-9, 9), r.between(-9, 9)},
          .unit = {r.between(-1, 1), r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)}};
      const glm::dvec2 from{r.between(-9, 9), r.between(-9, 9)};
      const double variance = 1.0 / 192;
      std::array<float, kPlaces> x, y, t;
      for (std::size_t k = 0; k < kPlaces; ++k)
        x[k] = float(r.between(-0.5, 0.5)), y[k] = float(r.between(-0.5, 0.5));
      radial_means(field, from, variance, x.data(), y.data(), int(kPlaces), t.data());
      for (std::size_t k = 0; k < kPlaces; ++k)
        ASSERT_EQ(t[k], float(field.mean(from + glm::dvec2{x[k], y[k]}, variance)));
    }
  });
}

}  // namespace
}  // namespace mien::test
