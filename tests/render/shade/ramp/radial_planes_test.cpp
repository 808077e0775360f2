#include "render/shade/ramp/radial_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

RampIntegral plain() {
  RampIntegral ramp;
  ramp.make(Ramp({RadialGradient{}, {{0, {0, 0, 0, 1}}, {1, {1, 1, 1, 1}}}}, 1, Blend::srgb));
  return ramp;
}

TEST(RadialPlanes, HaveTheMeanOfManyPlacesAndTheirSlopes) {
  PaintField field{
      .kind = PaintField::Kind::radial, .center = {3, 4}, .unit = {0.2, 0.05, -0.1, 0.3}};
  const std::vector<glm::dvec2> middles{{8, 9}, {-2, 4}, {3, 12}, {9, 9}, {9, 10}};
  RadialPlaces places;
  for (const glm::dvec2 p : middles) places.add(p.x, p.y, 1.0 / 12);
  std::vector<RampPlane> planes;
  std::vector<float> bends;
  add_radial_planes(field, plain(), places, planes, bends);
  ASSERT_EQ(planes.size(), middles.size());
  EXPECT_TRUE(places.x.empty());
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const glm::dvec2 p = middles[k];
    double sum = 0.0;
    constexpr int kSide = 50;  // places over a pixel
    for (int i = 0; i < kSide * kSide; ++i)
      sum += field.at(p + (glm::dvec2{i % kSide, i / kSide} + 0.5) / double(kSide) - 0.5, 0.0);
    EXPECT_NEAR(planes[k].t, sum / (kSide * kSide), 1e-4);
    EXPECT_GT(std::abs(field.at(p, 0.0) - sum / (kSide * kSide)), 2e-4);  // more than the middle
    constexpr double kStep = 1e-5;
    const auto slope = [&](glm::dvec2 by) {
      return (field.at(p + kStep * by, 0.0) - field.at(p - kStep * by, 0.0)) / (2 * kStep);
    };
    EXPECT_NEAR(planes[k].gx, slope({1, 0}), 1e-8);
    EXPECT_NEAR(planes[k].gy, slope({0, 1}), 1e-8);
    // Along its level line a step of e px leaves it by half its bend times e².
    const double steep = std::hypot(planes[k].gx, planes[k].gy);
    const glm::dvec2 along = glm::dvec2{-planes[k].gy, planes[k].gx} / steep;
    constexpr double kFar = 1e-2;
    const double left =
        field.at(p + kFar * along, 0.0) + field.at(p - kFar * along, 0.0) - 2 * field.at(p, 0.0);
    EXPECT_NEAR(std::sqrt(double(bends[k])), left / (kFar * kFar) / steep, 1e-4);
  }
}

TEST(RadialPlanes, AreSquaredByHowMuchTheyBendAndHowDarkThePixelIs) {
  const RampIntegral ramp = plain();
  const double tolerance = 0.3 / 255;
  std::vector<float> bends{1e-8f, 1e-4f, 1.0f}, excesses;
  ColorRow colors;
  colors.room_for(3);
  std::fill(colors.a.begin(), colors.a.end(), 1.0f);
  for (auto* c : {&colors.r, &colors.g, &colors.b}) std::fill(c->begin(), c->end(), 0.5f);
  const auto excess = [&](std::size_t k, bool linear) {
    bend_excesses({ramp, tolerance, linear}, bends, colors, excesses);
    bends.resize(3);
    return std::sqrt(double(excesses[k]));
  };
  EXPECT_NEAR(excess(1, false), 0.1 * 0.01 / tolerance, 1e-4);
  // Encoded 0.5 is as steep as 0.72 / √0.5 at most, and what may be 0.1 darker is steeper.
  EXPECT_NEAR(excess(0, true), 0.1 * 1e-4 / tolerance * 0.72 / std::sqrt(0.5), 1e-4);
  EXPECT_NEAR(excess(2, true), 0.1 / tolerance * 0.72 / std::sqrt(0.4), 1e-2);
  std::fill(colors.g.begin(), colors.g.end(), 0.0f);  // the darkest channel counts
  EXPECT_NEAR(excess(0, true), 0.1 * 1e-4 / tolerance * 6, 1e-4);
}

}  // namespace
}  // namespace mien
