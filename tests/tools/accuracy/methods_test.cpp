// Published methods: right where they are known to be right, wrong where they are known to be wrong, timed.

#include "tools/accuracy/methods/published.h"

#include <gtest/gtest.h>
#include <mien/quad_bezier_distance.h>

#include "tools/accuracy/tally.h"
#include "tools/accuracy/timing.h"

#include <algorithm>
#include <cmath>

namespace mien::accuracy {
namespace {

Family named_family(const std::string& name) {
  const auto& all = families();
  return *std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
}

Tally row_of(const std::vector<Tally>& tallies, const std::string& solver) {
  return *std::find_if(tallies.begin(), tallies.end(),
                       [&](const auto& t) { return t.solver == solver; });
}

TEST(PublishedMethods, MeasureAnOrdinaryCurve) {
  const QuadBezier curve{{0, 0}, {0.5, 1}, {1, 0.25}};
  for (const Solver& method : published_methods()) {
    for (const glm::dvec2 p : {glm::dvec2{0.2, 0.9}, {0.5, 0.1}, {-1, -1}, {2, 0}}) {
      const double truth = distance(curve, p);
      EXPECT_NEAR(method.solve({curve, p}), truth, 1e-5) << method.name << ' ' << p.x;
    }
  }
}

TEST(PublishedMethods, FailWhereTheyAreKnownTo) {
  const auto methods = published_methods();
  // A division by zero where all points are one.
  const auto equal = run(named_family("all equal"), methods, 50, 5);
  EXPECT_EQ(row_of(equal, "closed form f64").nan, 50u);
  EXPECT_EQ(row_of(equal, "subdivision f64").nan, 0u);
  // The nearest sample is not beside the nearest point of a folded curve.
  const auto folded = run(named_family("folded"), methods, 2000, 5);
  EXPECT_GT(row_of(folded, "Newton from samples f64").bad, 50u);
  EXPECT_EQ(row_of(folded, "subdivision f64").bad, 0u);
  // Float counts in floats, double in doubles; the worst is that of the numbers.
  const auto random = run(named_family("random"), methods, 2000, 5);
  EXPECT_LT(row_of(random, "closed form f64").worst, 10);
  EXPECT_GT(row_of(random, "closed form f32").worst, 2);
  EXPECT_TRUE(std::isfinite(row_of(equal, "closed form f64").worst));
  EXPECT_EQ(row_of(random, "closed form f64").bar, 0);
}

TEST(PublishedMethods, AreTimed) {
  const Family family = named_family("random");
  const auto cases = cases_of(family, 4, 1);
  const auto methods = published_methods();
  auto rows = run(family, methods, 10, 1);
  measure_times(rows, family, methods, 1);
  EXPECT_GT(row_of(rows, "closed form f64").ns, 1);
  EXPECT_GT(row_of(rows, "subdivision f64").ns, row_of(rows, "closed form f64").ns);
  EXPECT_NE(csv(rows).find(",ns\n"), std::string::npos);
  Solver alone = methods[0];
  alone.many = {};
  EXPECT_EQ(ns_per_point(alone, cases), 0);
}

}  // namespace
}  // namespace mien::accuracy
