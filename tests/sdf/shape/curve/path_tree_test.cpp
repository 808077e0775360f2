#include "sdf/shape/curve/path_tree.h"
#include "sdf/shape/curve/path.h"

#include "tests/support/shapes/bezier_cases.h"
#include "tests/support/shapes/shape_examples/path.h"
#include "tests/support/shapes/shape_laws.h"

#include <cmath>

namespace mien::test {
namespace {

QuadBezier between(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

/// Straight sides through places that `place` gives.
template <class Place>
Path path_through(int points, FillRule rule, const Place& place) {
  Path path{{Path::Loop{}}, rule};
  const glm::dvec2 first = place();
  glm::dvec2 at = first;
  for (int i = 1; i <= points; ++i) {
    const glm::dvec2 next = i < points ? place() : first;
    path.loops[0].sides.push_back(between(at, next));
    at = next;
  }
  return path;
}

glm::dvec2 on_lattice(Random& r, double jitter) {
  const auto one = [&] {
    return std::floor(r.between(0.0, 16.999)) / 8.0 - 1.0 + jitter * r.between(-1, 1);
  };
  const double x = one();
  return {x, one()};
}

void expect_same(const Path& path, Random& r, int places) {
  const PathTree tree(path);
  for (int i = 0; i < places; ++i) {
    const glm::dvec2 p = i % 3 ? r.point(-1.3, 1.3) : on_lattice(r, 0.0) + glm::dvec2{0.0, 0x1p-6};
    const double exact = distance(path, p), found = tree.distance(p);
    EXPECT_NEAR(std::abs(found), std::abs(exact), 1e-14) << p.x << ' ' << p.y;
    if (std::abs(exact) < 1e-9) continue;  // on a side: it may count to either hand
    EXPECT_EQ(tree.winding(p), winding(path, p)) << p.x << ' ' << p.y;
    EXPECT_EQ(found < 0.0, exact < 0.0) << p.x << ' ' << p.y;
  }
}

}  // namespace

TEST(PathTree, AnswersAsThePathDoes) {
  Random r(11);
  for (const Path& path : kPaths) expect_same(path, r, 500);
}

TEST(PathTree, AnswersAsPathsOfManySidesDo) {
  for (const FillRule rule : {FillRule::nonzero, FillRule::even_odd})
    for (const double jitter : {0.0, 1e-13, 1e-6, 1e-3, 1.0}) {
      Random r(12);
      expect_same(path_through(1000, rule, [&] { return on_lattice(r, jitter); }), r, 600);
    }
}

TEST(PathTree, AnswersAsPathsOfManyBendsDo) {
  Random r(13);
  Path path{{Path::Loop{}}, FillRule::nonzero};
  glm::dvec2 at = on_lattice(r, 0.0);
  const glm::dvec2 first = at;
  for (int i = 0; i < 500; ++i) {
    const glm::dvec2 next = i < 499 ? on_lattice(r, 0.0) : first;
    path.loops[0].sides.push_back({at, r.point(-1, 1), next});
    at = next;
  }
  expect_same(path, r, 2000);
}

TEST(PathTree, AnswersAsPathsWithoutAreaDo) {
  Random r(14);
  expect_same(path_through(400, FillRule::nonzero,
                           [&] {
                             return glm::dvec2{r.between(-1, 1), 0.1};
                           }),
              r, 600);
  expect_same(path_through(400, FillRule::nonzero,
                           [&] {
                             return glm::dvec2{0.1, r.between(-1, 1)};
                           }),
              r, 600);
  expect_same(path_through(400, FillRule::nonzero, [&] { return glm::dvec2{0.1, 0.1}; }), r, 50);
}

TEST(PathTree, OfNothingIsNowhere) {
  const PathTree tree{Path{}};
  EXPECT_EQ(tree.distance({0, 0}), std::numeric_limits<double>::infinity());
  EXPECT_EQ(tree.winding({0, 0}), 0);
}

TEST(PathTree, HoldsAFewListsOfTheSides) {
  Random r(15);
  const PathTree tree(path_through(20'000, FillRule::nonzero, [&] { return r.point(-1, 1); }));
  EXPECT_LT(tree.bytes(), 20'000u * 800u);
}

}  // namespace mien::test
