#include <mien/render/tile/local_paint.h>

#include <gtest/gtest.h>

#include <cmath>

namespace mien {
namespace {

Tape tape_of(const Gradient& gradient) {
  SceneBuilder build({.box = {{-1, -1}, {1, 1}}}, {1, 1, 1, 1});
  build.shape(Disc{{0, 0}, 0.5});  // area 0
  build.layer("layer", build.everywhere(), {.color = {0, 0, 0, 1}, .gradient = shared(gradient)});
  return tape_from_scene(std::move(build).finish(), {.width = 200, .height = 200});
}

const std::vector<Stop> kStops{{0, {0, 0, 0, 1}}, {1, {1, 1, 1, 1}}};

TEST(PaintSampler, DescribesAPaintInAPixelOrPartOfIt) {
  for (const Gradient& gradient : {Gradient{LinearGradient{{-1, 0}, {1, 0.5}}, kStops},
                                   Gradient{RadialGradient{{0, 0}, {1, 0.8}}, kStops},
                                   Gradient{DistanceGradient{Area{0}, -0.5, 0.5}, kStops}}) {
    const Tape tape = tape_of(gradient);
    PaintSampler sampler(tape);
    const PaintField& field = tape.paints[0].field;
    const auto exact = [&](glm::dvec2 p) {
      return field.at(p,
                      field.distance < 0 ? 0 : tape.distances[std::size_t(field.distance)].at(p));
    };
    for (const double side : {1.0, 0.25})
      for (const glm::dvec2 c : {glm::dvec2{30.5, -20.5}, {-70.5, 3.5}, {0.5, 60.5}}) {
        const LocalPaint local = sampler.local(0, c, side);
        for (const glm::dvec2 u : {glm::dvec2{0, 0}, {0.5, -0.5}, {-0.3, 0.1}})
          EXPECT_NEAR(local.place.at(u), exact(c + side * u), local.place.residual + 1e-12)
              << gradient.along.index();
        EXPECT_LT(local.place.residual, 1e-4);
      }
  }
}

TEST(PaintSampler, GivesAPixelTheSameWhateverWasAskedBefore) {
  const Tape tape = tape_of({DistanceGradient{Area{0}, -0.5, 0.5}, kStops});
  PaintSampler one(tape), other(tape);
  one.local(0, {-31.5, 44.5}, 1);
  one.local(0, {5.5, 3.5}, 1);
  const Bilinear a = one.local(0, {8.5, 0.5}, 1).place, b = other.local(0, {8.5, 0.5}, 1).place;
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.xy, b.xy);
}

TEST(PaintSampler, KnowsWhereAPaintIsOneColour) {
  const Tape tape = tape_of({DistanceGradient{Area{0}, 0, 0.1}, kStops});
  PaintSampler sampler(tape);
  EXPECT_EQ(sampler.constant(0, {0, 0}, 40), (Mix{0, 0, 0, 1}));
  EXPECT_EQ(sampler.constant(0, {80, 0}, 10), (Mix{1, 1, 1, 1}));
  EXPECT_EQ(sampler.constant(0, {55, 0}, 10), std::nullopt);
}

TEST(PaintSampler, CutsWhereTheColourHasAKink) {
  const Tape tape = tape_of({LinearGradient{{0.1, 0}, {0.2, 0}}, kStops});
  PaintSampler sampler(tape);
  std::vector<Cut> cuts;
  EXPECT_EQ(sampler.error(sampler.local(0, {10.3, 5.5}, 1), true, cuts), 0);
  ASSERT_EQ(cuts.size(), 1u);
  EXPECT_NEAR(cuts[0].d, 0.3, 1e-12);
  EXPECT_NEAR(cuts[0].normal.x, 1, 1e-12);
}

}  // namespace
}  // namespace mien
