#include "render/svg/distance_bands.h"

#include <gtest/gtest.h>

#include <random>

namespace mien {
namespace {

/// What the bands show at a distance.
Mix shown(const DistanceBands& bands, double distance) {
  Mix mix{0.0};
  for (const DistanceBand& band : bands.bands) {
    bool within = true;
    for (const AreaLevel& level : band.within)
      within = within && (distance <= level.level) != level.outside;
    if (within) mix = over(band.mix, mix);
  }
  return bands.opacity * mix;
}

double worst_step(const DistanceGradient& along, const Ramp& ramp) {
  const DistanceBands bands = distance_bands(along, ramp);
  double worst = 0;
  for (double d = -2.0003; d < 2; d += 0.00317) {
    const double t = (d - along.from) / (along.to - along.from);
    worst = std::max(worst, largest(shown(bands, d) - ramp.color(t)));
  }
  return worst;
}

Ramp ramp_of(std::vector<Stop> stops) {
  return Ramp({LinearGradient{}, std::move(stops)}, 1, Blend::srgb);
}

TEST(DistanceBands, AreHalfAStepOff) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    std::vector<Stop> stops;
    double at = 0;
    for (int k = 0; k < 3; ++k, at += 0.1 + unit(random))
      stops.push_back({at, {unit(random), unit(random), unit(random), i % 2 ? 1 : unit(random)}});
    const double from = unit(random) - 1, to = i % 3 ? from + 0.5 : from - 0.5;
    EXPECT_LE(worst_step({Area{}, from, to}, ramp_of(stops)), 0.5 * kBandStep + 1e-9) << i;
  }
}

/// No band of these has a border that it shares with the next: each lies on those before it.
TEST(DistanceBands, LieOverEachOtherWhereTheyCan) {
  const Color red{1, 0, 0, 1}, none{1, 0, 0, 0}, faint{1, 0, 0, 0.5}, blue{0, 0, 1, 0.5};
  const DistanceGradient rising{Area{}, 0, 1};
  for (const auto& [from, to] : {std::pair{red, none}, {none, red}, {faint, blue}, {red, red}})
    for (const DistanceBand& band : distance_bands(rising, ramp_of({{0, from}, {1, to}})).bands)
      EXPECT_LE(band.within.size(), 1u);
  EXPECT_EQ(distance_bands(rising, ramp_of({{0, faint}, {1, blue}})).opacity, 0.5);
  // From one colour to another while the opacity rises and falls there is no way but side by side.
  std::size_t most = 0;
  for (const DistanceBand& band :
       distance_bands(rising, ramp_of({{0, none}, {0.5, red}, {1, blue}, {1.5, none}})).bands)
    most = std::max(most, band.within.size());
  EXPECT_EQ(most, 2u);
}

TEST(DistanceBands, ATransparentGradientHasNone) {
  EXPECT_TRUE(distance_bands({Area{}, 0, 1}, ramp_of({{0, {1, 1, 1, 0}}, {1, {0, 0, 0, 0}}}))
                  .bands.empty());
  EXPECT_TRUE(distance_bands({Area{}, 0, 1}, ramp_of({})).bands.empty());
}

}  // namespace
}  // namespace mien
