#include <mien/feet.h>

#include <gtest/gtest.h>
#include <mien/ellipse_distance.h>
#include <mien/quad_bezier_distance.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "tests/support/process/effort.h"
#include "tests/support/shapes/every_instruction_set.h"
#include "tests/support/shapes/feet_hash.h"
#include "tools/accuracy/feet.h"

namespace mien {
namespace {

using accuracy::FeetCase;
constexpr double kNoFoot = std::numeric_limits<double>::infinity();
const QuadBezier kArch{{0, 0}, {1, 2}, {2, 0}};

template <class Figure>
Feet batched(const std::vector<Figure>& figures, glm::dvec2 p) {
  test::FootRoom nearest(1), next(1);
  nearest_feet(std::span<const Figure>(figures), std::span<const double>{&p.x, 1}, {&p.y, 1},
               nearest.spans(), next.spans());
  return {nearest.foot(0), next.foot(0)};
}
template <class Figure>
Feet alone(const std::vector<Figure>& figures, glm::dvec2 p) {
  return nearest_feet(std::span<const Figure>(figures), p);
}

void expect_same(const Foot& a, const Foot& b) {
  EXPECT_EQ(a.piece, b.piece);
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.distance, b.distance);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.bend, b.bend);
}

/// Both forms, the batch on every instruction set.
template <class Figure, class Look>
void with_both(const std::vector<Figure>& figures, glm::dvec2 p, Look look) {
  {
    SCOPED_TRACE("one by one");
    look(alone(figures, p));
  }
  test::on_every_set([&] { look(batched(figures, p)); });
}

// --- exactness -----------------------------------------------------------------------------------

class FeetFamilies : public testing::TestWithParam<size_t> {};

TEST_P(FeetFamilies, HaveTheRightBranchesOnEveryInstructionSet) {
  const auto& family = accuracy::feet_families()[GetParam()];
  for (const auto& t :
       accuracy::judge_feet(family, accuracy::own_feet_solvers(), size_t(test::times(300)), 20))
    EXPECT_TRUE(t.passes()) << accuracy::feet_table({t});
  batch::use_instruction_set(0);
}
INSTANTIATE_TEST_SUITE_P(All, FeetFamilies,
                         testing::Range<size_t>(0, accuracy::feet_families().size()));

/// The key along a figure by its own formula, in long double.
struct Sampled {
  int pieces;
  std::function<long double(int, long double)> key;
};
Sampled sampled(const FeetCase& k) {
  using Real = long double;
  const auto to_curve = [p = k.p](const QuadBezier& c, Real t) {
    const Real s = 1 - t;
    return std::hypot(s * s * c.p0.x + 2 * s * t * c.p1.x + t * t * c.p2.x - p.x,
                      s * s * c.p0.y + 2 * s * t * c.p1.y + t * t * c.p2.y - p.y);
  };
  if (const auto* c = std::get_if<std::vector<QuadBezier>>(&k.figure))
    return {int(c->size()), [=](int i, Real t) { return to_curve((*c)[size_t(i)], t); }};
  if (const auto* l = std::get_if<std::vector<Line>>(&k.figure))
    return {int(l->size()), [=, p = k.p](int i, Real t) {
              const Line& one = (*l)[size_t(i)];
              const Real x = one.a.x + t * (Real(one.b.x) - one.a.x) - p.x;
              return std::hypot(x, one.a.y + t * (Real(one.b.y) - one.a.y) - p.y) - one.half_width;
            }};
  if (const auto* s = std::get_if<std::vector<TaperedStroke>>(&k.figure))
    return {int(s->size()), [=](int i, Real t) {
              const TaperedStroke& one = (*s)[size_t(i)];
              const double* w = one.half_width;
              const Real u = 1 - t;
              return to_curve(one.spine, t) - (u * u * w[0] + 2 * u * t * w[1] + t * t * w[2]);
            }};
  const Ellipse e = std::get<Ellipse>(k.figure);
  return {1, [e, p = k.p](int, Real t) {
            const Real angle = 2 * std::acos(Real(-1)) * t;
            const Real x = e.radii.x * std::cos(angle), y = e.radii.y * std::sin(angle);
            return std::hypot(e.center.x + x * e.axis.x - y * e.axis.y - p.x,
                              e.center.y + x * e.axis.y + y * e.axis.x - p.y);
          }};
}

/// Its least value, by samples and the golden section.
long double least_key(const Sampled& on) {
  constexpr int kSamples = 512;
  const long double golden = (std::sqrt(5.0L) - 1) / 2;
  long double least = std::numeric_limits<long double>::infinity();
  for (int piece = 0; piece < on.pieces; ++piece) {
    const auto key = [&](long double t) { return on.key(piece, t); };
    for (int i = 0; i <= kSamples; ++i) {
      long double lo = std::max(0.0L, (i - 1.0L) / kSamples),
                  hi = std::min(1.0L, (i + 1.0L) / kSamples);
      if (key((lo + hi) / 2) > least + (hi - lo) * 20) continue;
      for (int n = 0; n < 80; ++n) {
        const long double a = hi - golden * (hi - lo), b = lo + golden * (hi - lo);
        (key(a) < key(b) ? hi : lo) = key(a) < key(b) ? b : a;
      }
      least = std::min({least, key((lo + hi) / 2), key(lo), key(hi)});
    }
  }
  return least;
}

/// The laboratory's truth itself: nothing sampled is nearer, and each of its feet is a minimum.
TEST(TrueFeet, AreTheLowestOfSamplesAndRiseToBothSides) {
  for (const auto& family : accuracy::feet_families()) {
    if (family.name == "beyond reason" || family.name == "any scale") continue;
    for (const FeetCase& k : accuracy::feet_cases_of(family, size_t(test::times(3)), 3)) {
      const auto truth = accuracy::true_feet(k);
      const double unit = 0x1p52 * accuracy::feet_unit(k);
      EXPECT_NEAR(double(truth[0].key), double(least_key(sampled(k))), 1e-13 * unit) << family.name;
      if (std::holds_alternative<Ellipse>(k.figure)) continue;
      const Sampled on = sampled(k);
      for (const auto& foot : truth)
        for (const double step : {-1e-5, 1e-5}) {
          const double t = foot.foot.t + step;
          if (t < 0 || t > 1 || double(foot.barrier) < 1e-6) continue;
          EXPECT_GE(double(on.key(foot.foot.piece, t)), double(foot.key) - 1e-15 * unit)
              << family.name;
        }
    }
  }
}

/// A solver with a fault, in the laboratory.
bool is_caught(const std::string& family_name, const std::function<void(Feet&)>& spoil) {
  auto solver = accuracy::own_feet_solvers().front();
  const auto honest = solver.solve;
  solver.solve = [&](const FeetCase& k) {
    Feet feet = honest(k);
    return spoil(feet), feet;
  };
  for (const auto& family : accuracy::feet_families())
    if (family.name == family_name)
      return !accuracy::judge_feet(family, {solver}, size_t(test::times(320)), 4).front().passes();
  return false;
}

TEST(Laboratory, PlantedFaultsOfFeetAreCaught) {
  EXPECT_FALSE(is_caught("joints", [](Feet&) {}));
  EXPECT_TRUE(is_caught("random", [](Feet& f) { f.nearest.normal.x *= -1; }));
  EXPECT_TRUE(is_caught("random", [](Feet& f) { f.next.normal *= -1; }));
  EXPECT_TRUE(is_caught("axis", [](Feet& f) { f.next = {}; }));
  EXPECT_TRUE(is_caught("joints", [](Feet& f) { f.next = f.nearest; }));
  EXPECT_TRUE(is_caught("tapered stroke", [](Feet& f) { std::swap(f.nearest, f.next); }));
  EXPECT_TRUE(is_caught("ellipse, thin", [](Feet& f) { f.next.t = -f.next.t; }));
  EXPECT_TRUE(is_caught("stroke, outrun", [](Feet& f) { f.nearest.distance *= 1 + 1e-14; }));
  EXPECT_TRUE(is_caught("many curves", [](Feet& f) { f.next.piece = 0; }));
}

// --- what the figures mean -----------------------------------------------------------------------

/// Away from ridges the normal is the distance's gradient, and the bend that gradient's divergence.
TEST(Feet, HaveTheGradientOfTheDistanceAndItsDivergence) {
  int seen = 0;
  for (const char* name : {"random", "tapered stroke", "ellipse", "polyline", "stroke chain"})
    for (const auto& family : accuracy::feet_families()) {
      if (family.name != name) continue;
      for (const FeetCase& k : accuracy::feet_cases_of(family, size_t(test::times(200)), 5)) {
        constexpr double kStep = 1e-5;
        const auto solve = accuracy::own_feet_solvers().front().solve;
        const Feet here = solve(k);
        const auto at = [&](double dx, double dy) {
          return solve({k.figure, k.p + kStep * glm::dvec2{dx, dy}}).nearest;
        };
        const Foot e = at(1, 0), w = at(-1, 0), n = at(0, 1), s = at(0, -1);
        bool is_smooth = std::abs(here.nearest.distance) > 1e-3 && std::abs(here.nearest.bend) < 20;
        for (const Foot& one : {e, w, n, s})
          is_smooth = is_smooth && one.piece == here.nearest.piece &&
                      std::abs(one.t - here.nearest.t) < 1e-2 &&
                      (one.t > 0) == (here.nearest.t > 0) && (one.t < 1) == (here.nearest.t < 1) &&
                      glm::distance(one.normal, here.nearest.normal) < 1e-3;
        if (!is_smooth) continue;
        ++seen;
        const glm::dvec2 gradient{e.distance - w.distance, n.distance - s.distance};
        EXPECT_LT(glm::distance(gradient / (2 * kStep), here.nearest.normal), 1e-5) << name;
        const double bend = (e.normal.x - w.normal.x + n.normal.y - s.normal.y) / (2 * kStep);
        EXPECT_NEAR(bend, here.nearest.bend, 1e-3 * (1 + std::abs(bend))) << name;
      }
    }
  EXPECT_GT(seen, test::times(400));
}

TEST(Feet, OfAnArchAreItsTwoSides) {
  with_both(std::vector{kArch}, {1, -1}, [](const Feet& feet) {
    // |B − p|² = 4 (t − ½)² + (1 + 4 t (1 − t))²: least at both ends, by symmetry.
    EXPECT_EQ(feet.nearest.t, 0);
    EXPECT_EQ(feet.next.t, 1);
    EXPECT_DOUBLE_EQ(feet.nearest.distance, std::sqrt(2));
    EXPECT_DOUBLE_EQ(feet.next.distance, std::sqrt(2));
    EXPECT_NEAR(feet.nearest.normal.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(feet.next.normal.x, -std::sqrt(0.5), 1e-15);
    EXPECT_DOUBLE_EQ(feet.next.bend, std::sqrt(0.5));
  });
  // Above it there is one, and its level lines bend as the arch does, a little less: its radius is 1/2.
  with_both(std::vector{kArch}, {1, 2}, [](const Feet& feet) {
    EXPECT_NEAR(feet.nearest.t, 0.5, 1e-15);
    EXPECT_NEAR(feet.nearest.normal.y, 1, 1e-15);
    EXPECT_NEAR(feet.nearest.bend, 1 / (0.5 + 1), 1e-14);
    EXPECT_EQ(feet.next.piece, -1);
    EXPECT_EQ(feet.next.distance, kNoFoot);
    EXPECT_EQ(feet.next.normal, glm::dvec2(0));
  });
}

TEST(Feet, OnACurveAndAtItsEndsHaveANormalAllTheSame) {
  const std::vector line{QuadBezier{{0, 0}, {1, 0}, {2, 0}}};
  with_both(line, {0.5, 0}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.distance, 0);
    EXPECT_EQ(feet.nearest.normal, glm::dvec2(0, -1));  // to the right of a rising t
    EXPECT_EQ(feet.nearest.bend, 0);
  });
  with_both(line, {2, 0}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.distance, 0);
    EXPECT_NEAR(std::abs(feet.nearest.normal.x) + std::abs(feet.nearest.normal.y), 1, 1e-15);
  });
  with_both(line, {-1, 0}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.t, 0);
    EXPECT_EQ(feet.nearest.normal, glm::dvec2(-1, 0));
    EXPECT_EQ(feet.nearest.bend, 1);
  });
  with_both(std::vector{Line{{1, 1}, {1, 1}, 0.5}}, {1, 3}, [](const Feet& feet) {  // a disc
    EXPECT_EQ(feet.nearest.distance, 1.5);
    EXPECT_EQ(feet.nearest.normal, glm::dvec2(0, 1));
    EXPECT_EQ(feet.nearest.bend, 0.5);
    EXPECT_EQ(feet.next.piece, -1);
  });
}

/// A polygon's joints are feet where they are those of the whole, once.
TEST(Feet, OfJoinedPiecesAreThoseOfTheWhole) {
  const std::vector<Line> square{
      {{0, 0}, {2, 0}, 0}, {{2, 0}, {2, 2}, 0}, {{2, 2}, {0, 2}, 0}, {{0, 2}, {0, 0}, 0}};
  with_both(square, {-1, -1}, [](const Feet& feet) {  // the closing joint
    EXPECT_EQ(feet.nearest.piece, 0);
    EXPECT_EQ(feet.nearest.t, 0);
    EXPECT_EQ(feet.next.piece, -1);
  });
  with_both(square, {0.5, 0.75}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.piece, 3);
    EXPECT_EQ(feet.nearest.distance, 0.5);
    EXPECT_EQ(feet.nearest.normal, glm::dvec2(1, 0));
    EXPECT_EQ(feet.next.piece, 0);
    EXPECT_EQ(feet.next.distance, 0.75);
    EXPECT_EQ(feet.next.normal, glm::dvec2(0, 1));
  });
  with_both(square, {0.5, 0.5}, [](const Feet& feet) {  // a tie: the first piece
    EXPECT_EQ(feet.nearest.piece, 0);
    EXPECT_EQ(feet.next.piece, 3);
    EXPECT_EQ(feet.nearest.distance, feet.next.distance);
  });
  // A curve cut in two has the feet of the whole, however small the step of a joint's point is.
  const QuadBezier first{{0, 0}, {0.5, 1}, {1, 1}}, second{{1, 1}, {1.5, 1}, {2, 0}};
  const std::vector<QuadBezier> cut{first, {{1, 1}, {1, 1}, {1, 1}}, second};
  for (const glm::dvec2 p : {glm::dvec2{1, 2}, {1, 1.25}, {0.9, -1}, {1, 0.875}, {1, 1}}) {
    const Feet whole = alone(std::vector{kArch}, p);
    with_both(cut, p, [&](const Feet& feet) {
      EXPECT_NEAR(feet.nearest.distance, whole.nearest.distance, 1e-15);
      EXPECT_EQ(feet.next.piece < 0, whole.next.piece < 0);
      if (whole.next.piece < 0) return;
      EXPECT_NEAR(feet.next.distance, whole.next.distance, 1e-15);
    });
  }
}

TEST(Feet, OfEqualPiecesAreBothAndTheFirstComesFirst) {
  with_both(std::vector{kArch, kArch}, {1, 3}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.piece, 0);
    EXPECT_EQ(feet.next.piece, 1);
    EXPECT_EQ(feet.nearest.distance, feet.next.distance);
  });
}

TEST(Feet, OfEllipsesAreSignedAndAcrossTheLongerAxis) {
  const auto look = [](const Ellipse& e, glm::dvec2 p, auto check) {
    check(nearest_feet(e, p));
    test::on_every_set([&] {
      test::FootRoom nearest(1), next(1);
      nearest_feet(e, std::span<const double>{&p.x, 1}, {&p.y, 1}, nearest.spans(), next.spans());
      check(Feet{nearest.foot(0), next.foot(0)});
    });
  };
  look({{0, 0}, {2, 1}}, {0, 0.25}, [](const Feet& feet) {
    EXPECT_NEAR(feet.nearest.distance, -0.75, 1e-15);
    EXPECT_NEAR(feet.nearest.t, std::acos(0.0), 1e-15);
    EXPECT_NEAR(feet.nearest.normal.y, 1, 1e-15);
    EXPECT_NEAR(feet.nearest.bend, 1 / (4 - 0.75), 1e-14);  // the radius on top is a² / b
    EXPECT_NEAR(feet.next.distance, -1.25, 1e-15);
    EXPECT_NEAR(feet.next.t, -std::acos(0.0), 1e-15);
    EXPECT_NEAR(feet.next.normal.y, -1, 1e-15);
  });
  look({{1, 1}, {1, 2}, {0, 1}}, {2, 1}, [](const Feet& feet) {  // turned: the longer axis is x
    EXPECT_NEAR(feet.nearest.distance, -std::sqrt(2.0 / 3), 1e-14);
    EXPECT_NEAR(feet.next.distance, feet.nearest.distance, 1e-14);
  });
  look({{0, 0}, {1, 1}}, {3, 0}, [](const Feet& feet) {
    EXPECT_EQ(feet.nearest.distance, 2);
    EXPECT_EQ(feet.nearest.normal, glm::dvec2(1, 0));
    EXPECT_EQ(feet.next.piece, -1);
  });
  look({{0, 0}, {2, 0}}, {1, 1},
       [](const Feet& feet) { EXPECT_NEAR(feet.nearest.distance, 1, 1e-15); });
}

// --- rules ---------------------------------------------------------------------------------------

/// tests/portable asks other systems for the same hash.
TEST(Feet, HaveTheSameBytesOnEveryInstructionSetAndMachine) {
  test::on_every_set([] { EXPECT_EQ(test::feet_hash(test::kHashedFeet), test::kFeetHash); });
}

TEST(Feet, DoNotDependOnTheirPlaceInTheSpan) {
  std::vector<double> x, y;
  test::Random random(3);
  for (int i = 0; i < 37; ++i)
    x.push_back(random.between(-1, 3)), y.push_back(random.between(-1, 3));
  test::on_every_set([&] {
    test::FootRoom nearest(37), next(37);
    const std::vector curves{kArch, QuadBezier{{0, 0}, {3, 1}, {0, 2}}};
    nearest_feet(std::span<const QuadBezier>(curves), x, y, nearest.spans(), next.spans());
    for (size_t i = 0; i < 37; ++i) {
      const Feet own = batched(curves, {x[i], y[i]});
      expect_same(own.nearest, nearest.foot(i)), expect_same(own.next, next.foot(i));
    }
  });
}

TEST(Feet, AreWrittenWhereTheyAreAskedForAlone) {
  std::vector<double> x{1, 2, 3}, y{4, 5, 6}, d(3), bend(3);
  nearest_feet(std::span<const QuadBezier>(&kArch, 1), x, y, {.distance = d}, {.bend = bend});
  for (size_t i = 0; i < 3; ++i) {
    const Feet own = batched(std::vector{kArch}, {x[i], y[i]});
    EXPECT_EQ(d[i], own.nearest.distance);
    EXPECT_EQ(bend[i], own.next.bend);
  }
  nearest_feet(std::span<const QuadBezier>(&kArch, 1), {}, {}, {}, {});
}

TEST(Feet, AreAbsentWhereNothingIsNear) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto is_absent = [](const Feet& feet) {
    for (const Foot& foot : {feet.nearest, feet.next}) {
      expect_same(foot, Foot{});
      EXPECT_EQ(foot.distance, kNoFoot);
    }
  };
  with_both(std::vector<QuadBezier>{}, {0, 0}, is_absent);
  for (const double bad : {nan, kNoFoot, -kNoFoot}) {
    with_both(std::vector{kArch}, {bad, 0}, is_absent);
    with_both(std::vector{kArch}, {0, bad}, is_absent);
    with_both(std::vector{QuadBezier{{0, 0}, {bad, 1}, {1, 1}}}, {0, 0}, is_absent);
    with_both(std::vector{QuadBezier{{0, 0}, {bad, 1}, {1, 1}}, kArch}, {1, 3},
              [](const Feet& feet) { EXPECT_EQ(feet.nearest.piece, 1); });
    is_absent(nearest_feet(Ellipse{{0, 0}, {2, 1}}, {bad, 1}));
  }
}

TEST(Feet, KnowNoSpecialScale) {
  test::Random random(8);
  for (const int exponent : {-1000, -300, -190, 190, 300, 900}) {
    const double k = std::ldexp(1.0, exponent);
    for (int i = 0; i < test::times(40); ++i) {
      const auto point = [&] { return random.point(0, 1); };
      const QuadBezier c{point(), point(), point()};
      const glm::dvec2 p = random.point(-1, 2);
      const TaperedStroke s{c, {0.1, 0.25, 0.05}},
          large{{k * c.p0, k * c.p1, k * c.p2}, {k * 0.1, k * 0.25, k * 0.05}};
      const Feet own = alone(std::vector{s}, p);
      for (const Feet& feet :
           {alone(std::vector{large}, k * p), batched(std::vector{large}, k * p)}) {
        EXPECT_NEAR(feet.nearest.distance / k, own.nearest.distance, 1e-14);
        EXPECT_NEAR(feet.nearest.normal.x, own.nearest.normal.x, 1e-12);
        EXPECT_EQ(feet.next.piece, own.next.piece);
      }
    }
  }
}

}  // namespace
}  // namespace mien
