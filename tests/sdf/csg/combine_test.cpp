#include "sdf/csg/combine.h"

#include <gtest/gtest.h>

#include "lib/math/norm.h"

#include <vector>

#include "tests/support/process/effort.h"
#include "tests/support/random/random.h"

namespace mien::test {
namespace {

/// Two overlapping discs, combined by one operator, and the outlines that could survive.
struct Case {
  Op op;
  double amount;
  bool in(bool a, bool b) const {
    return op == Op::unite ? a || b : op == Op::intersect ? a && b : a && !b;
  }
};

const Disc kA{{0, 0}, 1}, kB{{0.8, 0.3}, 0.7};

double combined(const Case& c, glm::dvec2 p) {
  return combine(c.op, distance(kA, p), distance(kB, p), c.amount);
}

Exactness promise(const Case& c) {
  return combine_exactness(c.op, exactness(Shape(kA)), exactness(Shape(kB)), c.amount);
}

const std::vector<Case> kCases = {{Op::unite, 0},      {Op::intersect, 0}, {Op::subtract, 0},
                                  {Op::complement, 0}, {Op::offset, 0.25}, {Op::offset, -0.25},
                                  {Op::shell, 0.2},    {Op::shape, 0}};

/// Points of the combined area's outline: of all circles that could carry it, those where the
/// distance is 0.
std::vector<glm::dvec2> outline(const Case& c) {
  std::vector<glm::dvec2> points;
  for (const Disc& disc : {kA, kB})
    for (const double grown : {0.0, c.amount, -c.amount})
      for (double t = 0; t < 6.2832; t += 1e-3) {
        const glm::dvec2 p =
            disc.center + (disc.radius + grown) * glm::dvec2(std::cos(t), std::sin(t));
        if (std::abs(combined(c, p)) < 1e-12) points.push_back(p);
      }
  return points;
}

TEST(Combine, KeepsItsPromises) {
  Random r(1);
  for (const Case& c : kCases) {
    const std::vector<glm::dvec2> edge = outline(c);
    ASSERT_GT(edge.size(), 500u);
    bool short_inside = false, short_outside = false;
    for (int i = 0; i < 800; ++i) {
      const glm::dvec2 p = r.point(-2, 2.5);
      double nearest = 1e9;
      for (const glm::dvec2 q : edge) nearest = std::min(nearest, norm(q - p));
      const double d = combined(c, p), slack = 2e-3;
      EXPECT_LE(std::abs(d), nearest + 1e-12) << int(c.op);
      const bool exact = d > 0 ? promise(c).outside : promise(c).inside;
      if (exact) {
        EXPECT_GE(std::abs(d), nearest - slack) << int(c.op) << " at " << p.x << ' ' << p.y;
      }
      if (std::abs(d) < nearest - 0.01) (d > 0 ? short_outside : short_inside) = true;
    }
    // Where only a bound is promised for two discs, it is not exact: the promise is not idle
    // modesty.
    EXPECT_TRUE(short_inside || c.op != Op::unite);
    EXPECT_TRUE(short_outside || (c.op != Op::intersect && c.op != Op::subtract));
  }
}

TEST(Combine, IsTheBooleanOfTheInsides) {
  Random r(2);
  for (int i = 0; i < times(5000); ++i) {
    const glm::dvec2 p = r.point(-2, 2.5);
    const bool a = distance(kA, p) < 0, b = distance(kB, p) < 0;
    for (const Case& c : {kCases[0], kCases[1], kCases[2]})
      EXPECT_EQ(combined(c, p) < 0, c.in(a, b));
    EXPECT_EQ(combine(Op::complement, distance(kA, p), 0, 0) < 0, !a);
    EXPECT_EQ(combine(Op::offset, distance(kA, p), 0, 0.5) < 0, norm(p) < 1.5);
    EXPECT_EQ(combine(Op::shell, distance(kA, p), 0, 0.25) < 0, norm(p) > 0.75 && norm(p) < 1.25);
  }
}

TEST(Combine, NeverChangesFasterThanYouWalk) {
  Random r(3);
  for (const Case& c : kCases)
    for (int i = 0; i < times(3000); ++i) {
      const glm::dvec2 p = r.point(-2, 2), q = r.point(-2, 2);
      EXPECT_LE(std::abs(combined(c, p) - combined(c, q)), norm(p - q) + 1e-15);
    }
}

TEST(Combine, ABoundStaysABound) {
  const Exactness exact{true, true}, none{false, false};
  for (const Op op :
       {Op::unite, Op::intersect, Op::subtract, Op::complement, Op::offset, Op::shell})
    EXPECT_EQ(combine_exactness(op, none, exact, 0.1).outside &&
                  combine_exactness(op, none, exact, 0.1).inside,
              false);
  EXPECT_EQ(combine_exactness(Op::complement, {true, false}, none, 0), (Exactness{false, true}));
  EXPECT_EQ(combine_exactness(Op::offset, exact, exact, 0.5), (Exactness{true, false}));
  EXPECT_EQ(combine_exactness(Op::offset, exact, exact, -0.5), (Exactness{false, true}));
  EXPECT_EQ(combine_exactness(Op::shell, exact, exact, 0.5), (Exactness{true, false}));
  EXPECT_EQ(combine_exactness(Op::shell, {true, false}, exact, 0.5), (Exactness{false, false}));
}

}  // namespace
}  // namespace mien::test
