#include <mien/distance.h>

#include <gtest/gtest.h>

#include "sdf/distance/instruction_sets.h"
#include "tools/accuracy/reference.h"
#include "tools/accuracy/tally.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <vector>

#include "tests/support/process/effort.h"

namespace mien {
namespace {

using accuracy::Case;
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const QuadBezier kCurve{{0.1, 0.2}, {0.8, 1.1}, {0.9, -0.4}};

/// Runs body once per instruction set, named on failure.
template <class Body>
void on_every_instruction_set(Body body) {
  for (const auto& set : batch::instruction_sets()) {
    SCOPED_TRACE(set.name);
    batch::use_instruction_set(set.id);
    body(set);
  }
  batch::use_instruction_set(0);
}

// --- accuracy ------------------------------------------------------------------------------------

class Families : public testing::TestWithParam<size_t> {};

TEST_P(Families, EveryKernelKeepsItsContractOnEveryInstructionSet) {
  const auto& family = accuracy::families()[GetParam()];
  for (const auto& t : accuracy::run(family, accuracy::own_solvers(), test::times(2'000), 20)) {
    EXPECT_TRUE(t.passes()) << accuracy::table({t});
  }
  batch::use_instruction_set(0);
}
INSTANTIATE_TEST_SUITE_P(All, Families, testing::Range<size_t>(0, accuracy::families().size()));

/// The laboratory sees an error of one part in a million, in every kernel's own unit.
TEST(Laboratory, APlantedErrorOfOneInAMillionIsCaught) {
  for (accuracy::Solver solver : accuracy::own_solvers()) {
    const auto families = accuracy::families();
    const auto family = *std::find_if(families.begin(), families.end(), [&](const auto& f) {
      return accuracy::cases_of(f, 1, 1).front().figure.index() == solver.figure;
    });
    const auto honest = solver.solve;
    solver.solve = [honest](const Case& k) { return honest(k) * (1 + 1e-6); };
    const auto tallies = accuracy::run(family, {solver}, test::times(500), 20);
    EXPECT_FALSE(tallies.front().passes()) << solver.name << ' ' << solver.instruction_set;
  }
  batch::use_instruction_set(0);
}

struct Fixture {
  QuadBezier curve;
  glm::dvec2 p;
  double distance;  ///< of the nearest floats, as published, to the digits given
};
const Fixture kFixtures[] = {
    {{{0, 0}, {0.5, -1.00332568e-12}, {1, 0}}, {0.174046248, 5.794708e-08}, 5.7947e-08},
    {{{0.531720161, 0.238497466}, {0.62581563, 0.862796307}, {0.545428216, 0.329644412}},
     {0.582464159, 0.575228035},
     1.0798e-08},
    {{{0.0830078125, 0.0830078125}, {-0.446777344, -0.446777344}, {0.0922851562, 0.0922851562}},
     {-0.179585561, -0.179585561},
     2.599e-10},
};

/// Double kernels get the decimals as written, float kernels the nearest floats.
TEST(Distances, FixturesThatOtherSolversMissed) {
  for (const Fixture& f : kFixtures) {
    const Case published{f.curve, f.p}, rounded = accuracy::in_floats(published);
    EXPECT_NEAR(double(accuracy::true_distance(rounded)), f.distance, 1e-3 * f.distance);
    for (const accuracy::Solver& s : accuracy::own_solvers()) {
      if (s.figure != published.figure.index()) continue;
      const Case& k = s.judge == accuracy::Judge::exact ? published : rounded;
      s.prepare();
      EXPECT_LE(accuracy::error_units(s.judge, false, k, accuracy::true_distance(k), s.solve(k)),
                s.bar)
          << s.name << ' ' << s.instruction_set;
    }
  }
  batch::use_instruction_set(0);
}

/// Far from a curve only the last roundings count: without carrying along what the offset's rounding
/// leaves over, this point was 2.05 ulps off where multiply-add is not fused.
TEST(Distances, AreWithinAUlpAndAHalfFarAway) {
  const Case worst{QuadBezier{{0.8368083238601685, 0.8351010680198669},
                              {0.8453550934791565, 0.9174172282218933},
                              {0.9239209294319153, 0.7067223191261292}},
                   {593284.625, 540002.6875}};
  // Both ends are equally far to within 1.6 ulps, and without fused steps the wrong one was taken.
  const Case tie{QuadBezier{{0.40527838468551636, 0.8674657940864563},
                            {0.6106407046318054, 0.471095472574234},
                            {0.8085582256317139, 0.06979598850011826}},
                 {-46.055274963378906, -23.122081756591797}};
  std::vector<Case> cases{worst, tie};
  for (const auto& family : accuracy::families()) {
    if (family.name != "far" && family.name != "ellipse, far") continue;
    const auto more = accuracy::cases_of(family, 2'000, 3);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  ASSERT_EQ(cases.size(), 4'002u);
  for (const accuracy::Solver& s : accuracy::own_solvers()) {
    if (s.name != "fast" && s.name != "many" && s.name != "ellipse") continue;
    SCOPED_TRACE(s.name + ' ' + s.instruction_set);
    s.prepare();
    double most = 0;
    for (const Case& k : cases) {
      if (k.figure.index() != s.figure) continue;
      const float truth = float(std::abs(double(accuracy::true_distance(k))));
      const double ulp = double(std::nextafter(truth, kInf)) - double(truth);
      const double error =
          double(accuracy::magnitude(accuracy::Quad(s.solve(k)) - accuracy::true_distance(k)));
      most = std::max(most, error / ulp);
    }
    EXPECT_LE(most, 1.5);
  }
  batch::use_instruction_set(0);
}

// --- spans ---------------------------------------------------------------------------------------

struct Points {
  std::vector<float> x, y;
};

Points points(size_t count) {
  accuracy::Random r(7);
  Points p;
  for (size_t i = 0; i < count; ++i) {
    p.x.push_back(float(r.between(-1, 2))), p.y.push_back(float(r.between(-1, 2)));
  }
  return p;
}

TEST(Distances, DependOnThePointAloneNotOnItsPlaceInTheSpan) {
  const Points p = points(300);
  on_every_instruction_set([&](const auto&) {
    for (const Precision precision : {Precision::fast, Precision::accurate}) {
      std::vector<float> alone(p.x.size());
      for (size_t i = 0; i < alone.size(); ++i) {
        distances(kCurve, {&p.x[i], 1}, {&p.y[i], 1}, {&alone[i], 1}, precision);
      }
      for (const size_t begin : {0, 1, 3, 17}) {
        for (const size_t size : {0, 1, 2, 15, 16, 63, 64, 65, 257}) {
          std::vector<float> d(size, -1);
          distances(kCurve, {&p.x[begin], size}, {&p.y[begin], size}, d, precision);
          for (size_t i = 0; i < size; ++i) ASSERT_EQ(d[i], alone[begin + i]) << begin << '+' << i;
        }
      }
    }
  });
}

TEST(Distances, WriteNothingBeyondTheSpan) {
  const Points p = points(70);
  std::vector<float> d(80, -1);
  distances(kCurve, p.x, p.y, std::span(d).subspan(5, 70));
  for (const size_t i : {0, 4, 75, 79}) EXPECT_EQ(d[i], -1) << i;
  EXPECT_GE(d[74], 0);
}

TEST(Distances, MayReplaceTheCoordinates) {
  const Points p = points(131);
  std::vector<float> apart(131), x = p.x, y = p.y;
  distances(kCurve, p.x, p.y, apart);
  distances(kCurve, x, p.y, x);
  distances(kCurve, p.x, y, y);
  EXPECT_EQ(x, apart);
  EXPECT_EQ(y, apart);
}

// --- meaning -------------------------------------------------------------------------------------

/// What rounding to float leaves of doubles: the two together are all their bits.
std::vector<float> rests(const std::vector<double>& all) {
  std::vector<float> rest;
  for (const double v : all) rest.push_back(std::isfinite(v) ? float(v - double(float(v))) : 0);
  return rest;
}

TEST(Distances, TheSameBitsOnEveryInstructionSetThatFuses) {
  std::map<int, std::vector<float>> first;
  on_every_instruction_set([&](const batch::InstructionSet& set) {
#ifndef MIEN_SAME_BITS_WITHOUT_FMA
    if (!set.fused) return;
#endif
    int which = 0;
    const auto expect_same = [&](const std::string& name, const std::vector<float>& all) {
      const auto [kept, is_new] = first.try_emplace(which++, all);
      if (!is_new) {
        EXPECT_EQ(kept->second, all) << name;
      }
    };
    for (const auto& family : accuracy::bezier_families()) {
      for (const Precision precision : {Precision::fast, Precision::accurate}) {
        std::vector<float> all;
        for (const Case& k : accuracy::cases_of(family, 300, 3)) {
          const float x = float(k.p.x), y = float(k.p.y);
          float d = 0;
          distances(std::get<QuadBezier>(k.figure), {&x, 1}, {&y, 1}, {&d, 1}, precision);
          all.push_back(d);
        }
        expect_same(family.name, all);
      }
    }
    for (const auto& family : accuracy::families()) {
      std::vector<float> all;
      std::vector<double> doubles;
      for (const Case& k : accuracy::cases_of(family, 300, 3)) {
        const float x = float(k.p.x), y = float(k.p.y);
        float d = 0;
        double fine = 0;
        std::visit(
            [&](const auto& f) {
              distances(f, std::span<const float>(&x, 1), {&y, 1}, std::span<float>(&d, 1));
              distances(f, std::span<const double>(&k.p.x, 1), {&k.p.y, 1},
                        std::span<double>(&fine, 1));
            },
            k.figure);
        all.push_back(d), doubles.push_back(fine);
      }
      expect_same(family.name, all);
      expect_same(family.name + ", double", {doubles.begin(), doubles.end()});
      expect_same(family.name + ", double's rest", rests(doubles));
    }
  });
}

TEST(Distances, NonsenseIsInfinitelyFar) {
  const float x[] = {kNan, 0.5f, kInf, 0.5f, 0.5f}, y[] = {0.5f, kNan, 0.5f, -kInf, 0.5f};
  on_every_instruction_set([&](const auto&) {
    for (const Precision precision : {Precision::fast, Precision::accurate}) {
      float d[5];
      distances(kCurve, x, y, d, precision);
      for (int i = 0; i < 4; ++i) EXPECT_EQ(d[i], kInf) << i;
      EXPECT_LT(d[4], 1);
      distances(QuadBezier{{0, 0}, {kNan, 0}, {1, 1}}, x, y, d, precision);
      for (const float v : d) EXPECT_EQ(v, kInf);
    }
    const double xd[] = {kNan, 0.5}, yd[] = {0, kInf};
    double dd[2];
    distances(kCurve, xd, yd, dd);
    for (const double v : dd) EXPECT_EQ(v, kInf);
  });
}

TEST(Distances, ToManyCurvesIsTheLeastOfTheSingleOnes) {
  const Points p = points(200);
  accuracy::Random r(11);
  std::vector<QuadBezier> curves;
  for (int i = 0; i < 30; ++i) {
    const glm::dvec2 p0 = r.point(), p1 = r.point();
    curves.push_back({p0, p1, r.point()});
  }
  curves.push_back({{0, 0}, {0.5, 0}, {1, 0}});
  on_every_instruction_set([&](const auto&) {
    std::vector<float> many(200), one(200);
    distances(std::span<const QuadBezier>(curves), p.x, p.y, many);
    for (size_t i = 0; i < many.size(); ++i) {
      double least = kInf;
      for (const QuadBezier& c : curves) least = std::min(least, distance(c, {p.x[i], p.y[i]}));
      EXPECT_NEAR(many[i], least, 4 * 0x1p-23);
    }
  });
}

/// The overloads' types, as the documentation gives them.
static_assert(std::is_same_v<decltype(Roots::count), int>);
static_assert(std::is_same_v<decltype(Roots::x), std::array<double, 3>>);
[[maybe_unused]] double (*const kDistance)(const QuadBezier&, glm::dvec2) = distance;
[[maybe_unused]] NearestPoint (*const kNearest)(const QuadBezier&, glm::dvec2) = nearest;
[[maybe_unused]] Roots (*const kSolveCubic)(double, double, double, double) = solve_cubic;
[[maybe_unused]] void (*const kMany)(std::span<const QuadBezier>, std::span<const float>,
                                     std::span<const float>, std::span<float>) = distances;

/// Spans of any length at any address, in place of either coordinate, with nonsense among them.
template <class T, class Figure>
void expect_any_spans(const Figure& figure) {
  const Points p = points(140);
  std::vector<T> x(p.x.begin(), p.x.end()), y(p.y.begin(), p.y.end()), alone(140), d(140);
  x[3] = T(kNan), y[70] = T(kInf), x[71] = T(-kInf);
  using In = std::span<const T>;
  using Out = std::span<T>;
  distances(figure, In(), In(), Out());
  for (size_t i = 0; i < 140; ++i) {
    distances(figure, In(&x[i], 1), In(&y[i], 1), Out(&alone[i], 1));
  }
  for (const size_t i : {3, 70, 71}) EXPECT_EQ(alone[i], T(kInf)) << i;
  for (const size_t begin : {0, 1, 5}) {
    const size_t size = 135 - begin;
    distances(figure, In(&x[begin], size), In(&y[begin], size), Out(&d[begin], size));
    for (size_t i = begin; i < begin + size; ++i) EXPECT_EQ(d[i], alone[i]) << i;
  }
  std::vector<T> over_x = x, over_y = y;
  distances(figure, In(over_x), In(y), Out(over_x));
  distances(figure, In(x), In(over_y), Out(over_y));
  EXPECT_EQ(over_x, alone);
  EXPECT_EQ(over_y, alone);
#ifdef NDEBUG  // else an assertion ends the program: spans_test.cpp
  std::fill(d.begin(), d.end(), T(-7));
  distances(figure, In(x).first(9), In(y).first(7), Out(d).first(8));
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(d[i], i < 7 ? alone[i] : T(-7)) << i;
#endif
}

TEST(Distances, EveryOverloadTakesAnySpans) {
  const QuadBezier two[] = {kCurve, {{0, 0}, {0.5, 0}, {1, 0}}};
  on_every_instruction_set([&](const auto&) {
    expect_any_spans<float>(kCurve);
    expect_any_spans<float>(std::span<const QuadBezier>(two));
    expect_any_spans<double>(kCurve);
    const auto both = [](const auto& figure) {
      expect_any_spans<float>(figure);
      expect_any_spans<double>(figure);
    };
    both(Ellipse{{0.4, 0.5}, {0.5, 0.2}, {0.8, 0.6}});
    both(ParabolaSide{{0.4, 0.2}, {0.6, 0.8}, 1.3});
    both(TaperedStroke{kCurve, {0.1, 0.2, 0.05}});
    both(CubicBezier{{0, 0}, {1, 2}, {2, -1}, {0.5, 0.5}});
  });
}

/// Every figure's batch, float and double, is its scalar distance to within the batch's rounding.
template <class Figure>
void expect_batches(const Figure& figure) {
  const Points p = points(150);
  const std::vector<double> x(p.x.begin(), p.x.end()), y(p.y.begin(), p.y.end());
  std::vector<float> f(150);
  std::vector<double> d(150);
  distances(figure, std::span<const float>(p.x), p.y, std::span<float>(f));
  distances(figure, std::span<const double>(x), y, std::span<double>(d));
  for (size_t i = 0; i < d.size(); ++i) {
    EXPECT_NEAR(d[i], distance(figure, {x[i], y[i]}), 16 * 0x1p-52);
    EXPECT_NEAR(f[i], d[i], 16 * 0x1p-23);
  }
  const float bad_x[] = {kNan, 0}, bad_y[] = {0, kInf};
  float bad[2];
  distances(figure, std::span<const float>(bad_x), bad_y, std::span<float>(bad));
  EXPECT_EQ(bad[0], kInf);
  EXPECT_EQ(bad[1], kInf);
}

TEST(Distances, OfEveryFigureAreItsScalarOnes) {
  on_every_instruction_set([&](const auto&) {
    expect_batches(Ellipse{{0.4, 0.5}, {0.5, 0.2}, {0.8, 0.6}});
    expect_batches(Ellipse{{0.4, 0.5}, {0.3, 0.3}});
    expect_batches(Ellipse{{0.4, 0.5}, {0.3, 0}});
    expect_batches(Ellipse{{0.4, 0.5}, {0, 0}});
    expect_batches(ParabolaSide{{0.4, 0.2}, {0.6, 0.8}, 1.3});
    expect_batches(ParabolaSide{{0.4, 0.2}, {0, 1}, -0.7});
    expect_batches(ParabolaSide{{0.4, 0.2}, {0, 1}, 0});
    expect_batches(TaperedStroke{kCurve, {0.1, 0.2, 0.05}});
    expect_batches(CubicBezier{{0, 0}, {1, 2}, {2, -1}, {0.5, 0.5}});
  });
}

TEST(Distances, ToNoCurveAreInfiniteAndPointsAreCurvesToo) {
  const float x[] = {0, 3}, y[] = {0, 4};
  float d[2];
  distances(std::span<const QuadBezier>{}, x, y, d);
  EXPECT_EQ(d[0], kInf);
  const QuadBezier origin{{0, 0}, {0, 0}, {0, 0}}, far{{9, 9}, {9, 9}, {9, 8}};
  const QuadBezier both[] = {origin, far};
  distances(std::span<const QuadBezier>(both), x, y, d);
  EXPECT_EQ(d[0], 0);
  EXPECT_EQ(d[1], 5);
  distances(origin, x, y, d);
  EXPECT_EQ(d[1], 5);
}

}  // namespace
}  // namespace mien
