// Verdicts about squares against the shapes' exact distances: a verdict is never wrong, and squares
// clear of the outline get one.

#include <mien/sdf/edge/classify.h>

#include <gtest/gtest.h>
#include <mien/sdf/batch/instruction_sets.h>

#include <fmt/format.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <vector>

namespace mien {
namespace {

struct Kind {
  const char* name;
  OffsetShape shape;
  /// A square is decided whose centre is farther from the outline than half_diagonal + curvature ·
  /// half_diagonal², if that is a correction: 0 where the form is a distance, infinity: not asked.
  double curvature;
};

std::vector<Kind> kinds() {
  const QuadBezier arc{{-80, -30}, {10, 90}, {85, -40}}, hook{{-60, 0}, {80, 20}, {-60, 30}},
      straight{{-60, -20}, {0, 0}, {60, 20}}, point{{9, 9}, {9, 9}, {9, 9}};
  const Path leaf{{{{{{-70, 0}, {0, 60}, {70, 0}}, {{70, 0}, {0, -40}, {-70, 0}}}}}};
  return {{"half plane", {HalfPlane{{0.6, 0.8}, 10}, 2}, 0},
          {"parabola", {ParabolaSide{{3, -20}, {0, 1}, 0.01}}, 0.02},
          {"parabola from outside", {ParabolaSide{{3, -20}, {0.6, 0.8}, -0.02}}, 0.04},
          {"straight parabola", {ParabolaSide{{3, -20}, {0.6, 0.8}, 0}}, 0},
          {"grown parabola", {ParabolaSide{{3, -20}, {0, 1}, 0.01}, 7.5}, 0},
          {"disc", {Disc{{5, 5}, 40}}, 0},
          {"shrunk disc", {Disc{{5, 5}, 40}, -3}, 0},
          {"circle", {Ellipse{{5, 5}, {40, 40}}}, 1.0 / 40},
          {"ellipse", {Ellipse{{5, 5}, {60, 40}, {0.8, 0.6}}}, 60.0 / 1600},
          {"flat ellipse", {Ellipse{{0, 0}, {3, 70}}}, INFINITY},
          {"line", {Line{{-50, -20}, {60, 30}, 8}}, 0},
          {"stroke", {QuadStroke{arc, 6}}, 0},
          {"hook", {QuadStroke{hook, 9}, 1}, 0},
          {"straight stroke", {QuadStroke{straight, 5}}, 0},
          {"dot", {QuadStroke{point, 5}}, 0},
          {"tapered stroke", {TaperedStroke{arc, {3, 14, 5}}}, INFINITY},
          {"swelling stroke", {TaperedStroke{hook, {2, 16, 1}}, 2}, INFINITY},
          {"shrunken hairpin",
           {TaperedStroke{{{50, 70}, {20, -25}, {55, 85}}, {2, 8, 4}}, -5},
           INFINITY},
          {"tapered dot", {TaperedStroke{point, {2, 16, 1}}}, 0},
          {"leaf", {leaf}, 0},
          {"triangle", {Triangle{{0, 0}, {70, 10}, {-20, 50}}}, 0}};
}

class Classified : public testing::TestWithParam<size_t> {
 protected:
  const Kind kind = kinds()[GetParam()];

  /// The kind's shape, moved.
  OffsetShape moved(glm::dvec2 by) const {
    return {transformed(glm::dmat2(1.0), by, kind.shape.shape), kind.shape.offset};
  }
  static std::int8_t one(const Classifier& c, float x, float y, float half) {
    std::int8_t side = 7;
    c.classify({&x, 1}, {&y, 1}, half, {&side, 1});
    return side;
  }
};

TEST_P(Classified, AreWhatTheDistanceSaysOnEveryInstructionSet) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<float> place(-130, 130);
  for (const auto& set : batch::instruction_sets()) {
    SCOPED_TRACE(set.name);
    batch::use_instruction_set(set.id);
    for (const glm::dvec2 origin : {glm::dvec2{0, 0}, {30000.3, -20000.7}}) {
      const OffsetShape shape = moved(origin);
      const Classifier classifier(shape, origin);
      for (const float half : {0.71f, 11.3f, 45.0f}) {
        std::vector<float> x(1001), y(1001);
        for (size_t i = 0; i < x.size(); ++i) x[i] = place(random), y[i] = place(random);
        std::vector<std::int8_t> sides(x.size(), 7);
        classifier.classify(x, y, half, sides);
        const double bent = kind.curvature * double(half);
        const double far = bent <= 0.5 ? double(half) * (1 + bent) + 3e-3 : INFINITY;
        for (size_t i = 0; i < x.size(); ++i) {
          const double d = distance(shape, origin + glm::dvec2{x[i], y[i]});
          const bool right = sides[i] == 0   ? !(std::abs(d) > far)
                             : sides[i] == 1 ? d > double(half)
                                             : d < -double(half);
          ASSERT_TRUE(right) << int(sides[i]) << ' ' << x[i] << ' ' << y[i] << ' ' << d;
        }
      }
    }
  }
  batch::use_instruction_set(0);
}

/// Half diagonals a rounding above the distance: the square is crossed, if barely.
TEST_P(Classified, NeverDecideByARounding) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> place(-130, 130);
  const glm::dvec2 origin{1 << 14, 100.0 / 3};
  const OffsetShape shape = moved(origin);
  const Classifier classifier(shape, origin);
  for (int i = 0; i < 3000; ++i) {
    const float x = place(random), y = place(random);
    const double d = std::abs(distance(shape, origin + glm::dvec2{x, y}));
    const float barely = std::nextafter(float(d), INFINITY);
    ASSERT_EQ(int(one(classifier, x, y, barely)), 0) << x << ' ' << y << ' ' << d;
  }
}

TEST_P(Classified, NonsenseIsNotDecided) {
  const Classifier classifier(kind.shape, {0, 0});
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    EXPECT_EQ(int(one(classifier, bad, 1, 1)), 0);
    EXPECT_EQ(int(one(classifier, 1, bad, 1)), 0);
  }
  EXPECT_EQ(int(one(classifier, 5, 5, NAN)), 0);
  EXPECT_EQ(int(one(classifier, 5, 5, INFINITY)), 0);
  EXPECT_EQ(int(one(classifier, 3e38f, 3e38f, 3e38f)), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Classified, testing::Range<size_t>(0, kinds().size()),
                         [](const auto& kind) {
                           std::string name = kinds()[kind.param].name;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

TEST(Classifier, WritesExactlyTheSpanAndReadsNothingBeyond) {
  const Classifier disc({Disc{{0, 0}, 10}}, {0, 0});
  const Classifier stroke({QuadStroke{{{-5, 0}, {0, 9}, {5, 0}}, 3}}, {0, 0});
  for (const Classifier* c : {&disc, &stroke})
    for (const size_t count : {0, 1, 15, 16, 17, 63, 64, 65}) {
      const std::vector<float> x(count, 0.5f);
      std::vector<std::int8_t> sides(count + 2, 7);
      c->classify(x, x, 0.1f, std::span(sides).subspan(1, count));
      EXPECT_EQ(sides.front(), 7);
      EXPECT_EQ(sides.back(), 7);
      for (size_t i = 1; i <= count; ++i) EXPECT_EQ(sides[i], c == &disc ? -1 : sides[1]);
    }
}

TEST(ClassifierDeathTest, UnequalSpansAreRefusedAloud) {
  const Classifier disc({Disc{{0, 0}, 10}}, {0, 0});
  const std::vector<float> x(4);
  std::vector<std::int8_t> sides(5);
  EXPECT_DEATH(disc.classify(x, x, 1, sides), "equal length");
}

}  // namespace
}  // namespace mien
