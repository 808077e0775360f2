#include <mien/face_file.h>
#include <mien/face_model.h>

#include "sdf/from_face/figure/pattern_private.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "tests/support/faces/face_text.h"

namespace mien {
namespace {

Face pattern_face(const std::string& feature) {
  const Expected<Face> face = read_face_text(test::face_with(feature));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

std::vector<Shape> shapes_in(const Face& face, std::size_t feature = 0) {
  return std::visit(
      [&](const auto& f) -> std::vector<Shape> {
        if constexpr (requires { pattern_shapes(f, face); })
          return pattern_shapes(f, face);
        else
          return {};
      },
      face.model->features[feature].figure);
}

/// A unit square, so that places are u and v.
std::string strewn(const std::string& more) {
  return R"({"name": "a", "kind": "scatter", "patch": [[[0, 0], [1, 0]], [[0, 1], [1, 1]]], )" +
         more + "}";
}

std::vector<glm::dvec2> middles(const std::vector<Shape>& shapes) {
  std::vector<glm::dvec2> all;
  for (const Shape& shape : shapes) all.push_back(bounds(shape).center());
  return all;
}

TEST(PatternShapes, FillTheirPatchEvenly) {
  for (const double jitter : {0.0, 0.7, 1.0}) {
    const Face face = pattern_face(strewn(fmt::format(
        R"("count": 400, "of": "disc", "radius": 0.01, "seed": 3, "jitter": {})", jitter)));
    int quarters[4] = {};
    for (const glm::dvec2 p : middles(shapes_in(face))) {
      EXPECT_TRUE(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1);
      ++quarters[(p.x > 0.5) + 2 * (p.y > 0.5)];
    }
    for (const int quarter : quarters) EXPECT_NEAR(quarter, 100, 12) << jitter;
  }
}

TEST(PatternShapes, AreRoundIfAsked) {
  const Face face = pattern_face(
      strewn(R"("count": 300, "of": "disc", "radius": 0.01, "round": true, "jitter": 1)"));
  const auto places = middles(shapes_in(face));
  EXPECT_EQ(places.size(), 300u);
  for (const glm::dvec2 p : places) EXPECT_LE(glm::length(p - 0.5), 0.5 + 1e-12);
}

TEST(PatternShapes, StandInRowsThatMayBeStaggered) {
  const Face plain = pattern_face(strewn(R"("count": [2, 2], "of": "disc", "radius": 0.01)"));
  const std::vector<glm::dvec2> corners{{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
  EXPECT_EQ(middles(shapes_in(plain)), corners);
  const Face staggered =
      pattern_face(strewn(R"("count": [2, 2], "stagger": true, "of": "disc", "radius": 0.01)"));
  const std::vector<glm::dvec2> shifted{{0.125, 0.25}, {0.625, 0.25}, {0.375, 0.75}, {0.875, 0.75}};
  EXPECT_EQ(middles(shapes_in(staggered)), shifted);
}

TEST(PatternShapes, OfOneSeedAreTheSameAndOfAnotherAreNot) {
  const auto of_seed = [](int seed) {
    return middles(shapes_in(pattern_face(strewn(fmt::format(
        R"("count": 20, "of": "disc", "radius": 0.01, "jitter": 0.5, "seed": {})", seed)))));
  };
  EXPECT_EQ(of_seed(1), of_seed(1));
  int moved = 0;
  const auto one = of_seed(1), two = of_seed(2);
  for (std::size_t i = 0; i < one.size(); ++i) moved += glm::length(one[i] - two[i]) > 0.02;
  EXPECT_GT(moved, 15);
}

/// A figure keeps its place on the patch wherever the patch goes: none appears, none vanishes.
TEST(PatternShapes, GoWithTheirPatch) {
  const std::string what =
      R"("count": 50, "of": "stroke", "length": 0.1, "half_width": 0.01, "tilt": 30, "jitter": 1, "sway": 40, "vary": 0.5)";
  const Face rest = pattern_face(strewn(what));
  Face moved = rest;
  const double c = std::cos(0.6), s = std::sin(0.6);
  const auto turned = [&](glm::dvec2 p) {
    return glm::dvec2{0.3 + c * p.x - s * p.y, 0.1 + s * p.x + c * p.y};
  };
  for (const Slice& slice : rest.model->layout.slices()) {
    if (slice.kind != SliceKind::point) continue;
    double* xy = &moved.vector[std::size_t(slice.begin)];
    const glm::dvec2 p = turned({xy[0], xy[1]});
    xy[0] = p.x, xy[1] = p.y;
  }
  const auto before = shapes_in(rest), after = shapes_in(moved);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto &a = std::get<QuadStroke>(before[i]), &b = std::get<QuadStroke>(after[i]);
    EXPECT_LT(glm::length(turned(a.spine.p0) - b.spine.p0), 1e-14);
    EXPECT_LT(glm::length(turned(a.spine.p2) - b.spine.p2), 1e-14);
  }
}

TEST(PatternShapes, OfBothSidesAreMirrorImages) {
  const std::string side = R"({"name": "a", "side": "left", "kind": )";
  for (
      const std::string& feature :
      {side +
           R"("scatter", "patch": [[[0.1, 0], [0.5, 0.1]], [[0.2, 0.4], [0.5, 0.3]]], "count": 20, "seed": 5, "jitter": 0.9,
            "of": "stroke", "length": 0.1, "half_width": [0, 0.01, 0], "tilt": 30, "sway": 50, "vary": 0.5})",
       side +
           R"("repeat", "points": [[0.1, 0], [0.5, 0.1], [0.4, 0.6]], "smooth": true, "count": 9, "jitter": 0.9,
            "of": "stroke", "length": 0.1, "half_width": 0.01, "tilt": -70, "sway": 50})",
       side +
           R"("stripes", "patch": [[[0.1, 0], [0.5, 0.1]], [[0.2, 0.4], [0.5, 0.3]]], "count": 9, "jitter": 0.9, "half_width": 0.01})"}) {
    const Face face = pattern_face(feature);
    const auto left = shapes_in(face, 0), right = shapes_in(face, 1);
    ASSERT_EQ(left.size(), right.size());
    ASSERT_FALSE(left.empty());
    for (std::size_t i = 0; i < left.size(); ++i)
      for (const glm::dvec2 p : {glm::dvec2{0.3, 0.2}, {0.1, 0.1}, {0.5, 0.4}})
        EXPECT_NEAR(distance(left[i], p), distance(right[i], {-p.x, p.y}), 1e-14);
  }
}

/// Equal steps along the way, whatever the points' own distances.
TEST(PatternShapes, RepeatAtEqualSteps) {
  const Face face = pattern_face(
      R"({"name": "a", "kind": "repeat", "points": [[0, 0], [0.1, 0], [0.8, 0]], "count": 4, "of": "disc", "radius": 0.01})");
  const auto places = middles(shapes_in(face));
  ASSERT_EQ(places.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(places[std::size_t(i)].x, 0.1 + 0.2 * i, 1e-14);
  const Face point = pattern_face(
      R"({"name": "a", "kind": "repeat", "points": [[0.2, 0], [0.2, 0]], "smooth": true, "count": 3, "of": "disc", "radius": 0.1})");
  for (const glm::dvec2 p : middles(shapes_in(point)))
    EXPECT_LT(glm::length(p - glm::dvec2{0.2, 0}), 1e-15);
}

/// On a curve steps are measured by chords: within a thousandth of equal.
TEST(PatternShapes, RepeatAtEqualStepsRoundACurve) {
  const Face face = pattern_face(
      R"({"name": "a", "kind": "repeat", "points": [[1, 0], [0.7071, 0.7071], [0, 1], [-0.7071, 0.7071], [-1, 0]], "smooth": true, "count": 40, "of": "disc", "radius": 0.01})");
  const auto places = middles(shapes_in(face));
  const double step = glm::length(places[1] - places[0]);
  for (std::size_t i = 1; i < places.size(); ++i)
    EXPECT_NEAR(glm::length(places[i] - places[i - 1]), step, 1.5e-3 * step) << i;
}

TEST(PatternShapes, StripesRunAlongTheRows) {
  const Face face = pattern_face(
      R"({"name": "a", "kind": "stripes", "patch": [[[0, 0], [1, 1], [2, 0]], [[0, 2], [1, 5], [2, 2]]], "count": 2, "half_width": [0, 0.1, 0]})");
  const auto shapes = shapes_in(face);
  ASSERT_EQ(shapes.size(), 2u);
  const auto& stripe = std::get<TaperedStroke>(shapes[0]);
  EXPECT_EQ(stripe.spine, (QuadBezier{{0, 0.5}, {1, 2}, {2, 0.5}}));
  EXPECT_EQ(stripe.half_width[1], 0.1);
  const Face hatching = pattern_face(
      R"({"name": "a", "kind": "stripes", "patch": [[[0, 0], [1, 0]], [[0, 1], [1, 1]]], "count": 30, "half_width": 0.01, "jitter": 1, "vary": 0.5})");
  double shortest = 1, thinnest = 1;
  for (const Shape& shape : shapes_in(hatching)) {
    const auto& line = std::get<QuadStroke>(shape);
    shortest = std::min(shortest, line.spine.p2.x - line.spine.p0.x);
    thinnest = std::min(thinnest, line.half_width);
  }
  EXPECT_GT(shortest, 0.5);
  EXPECT_LT(shortest, 0.75);
  EXPECT_GT(thinnest, 0.005);
  EXPECT_LT(thinnest, 0.006);
}

}  // namespace
}  // namespace mien
