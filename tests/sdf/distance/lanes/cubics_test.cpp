// solve_cubics, on every instruction set.

#include <mien/distance.h>

#include <gtest/gtest.h>

#include "sdf/distance/instruction_sets.h"
#include "tools/accuracy/cubics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mien {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

template <class Body>
void on_each_instruction_set(Body body) {
  for (const auto& set : batch::instruction_sets()) {
    SCOPED_TRACE(set.name);
    batch::use_instruction_set(set.id);
    body(set);
  }
  batch::use_instruction_set(0);
}

/// Cubics that other solvers miss roots of; the roots to the digits published.
const struct {
  double a, b, c, d;
  int count;
  double root;  ///< one of them
} kCubicFixtures[] = {
    {1, -886.7970773009183, 262148.4783430062, -264000817.775054, 1, 915.453859},
    {-4.0410628481035e-17, 0.0126298310280606, -0.100896606408756, 0.0689539597036461, 3,
     0.754710877},
    {1e-20, 1, -3, 2, 3, 2},
    {1, -6, 11, -6, 3, 3},
    {0, 1, -3, 2, 2, 1},
    {1, -3, 3, -1, 1, 1},
    {1, 0, 0, 0, 1, 0},
    {0, 0, 0, 0, -1, 0},
    {0, 0, 0, 1, 0, 0},
    {kNoNumber, 1, 1, 1, 0, 0},
    {1, kInfinite, 1, 1, 0, 0},
    {1, 1, 1, -kInfinite, 0, 0},
};

TEST(SolveCubics, FixturesInAnyPlaceOfAnySpan) {
  on_each_instruction_set([&](const auto&) {
    for (const size_t size : {1, 2, 31, 32, 33, 70}) {
      std::vector<double> a, b, c, d;
      std::vector<Roots> out(size + 1, Roots{-7, {}});
      for (size_t i = 0; i < size; ++i) {
        const auto& k = kCubicFixtures[(i + size) % std::size(kCubicFixtures)];
        a.push_back(k.a), b.push_back(k.b), c.push_back(k.c), d.push_back(k.d);
      }
      solve_cubics(a, b, c, d, std::span(out).first(size));
      EXPECT_EQ(out[size].count, -7);
      for (size_t i = 0; i < size; ++i) {
        const auto& k = kCubicFixtures[(i + size) % std::size(kCubicFixtures)];
        ASSERT_EQ(out[i].count, k.count) << k.a << ' ' << k.b << ' ' << k.c << ' ' << k.d;
        double off = out[i].count > 0 ? 1 : 0;
        for (int n = 0; n < out[i].count; ++n) {
          off = std::min(off, std::abs(out[i].x[size_t(n)] - k.root) / std::max(k.root, 1.0));
        }
        EXPECT_LE(off, 1e-9) << k.a << ' ' << k.b << ' ' << k.c << ' ' << k.d;
      }
    }
    solve_cubics({}, {}, {}, {}, {});
  });
}

TEST(SolveCubics, CountTheSameRootsAsTheScalarForm) {
  for (const auto& family : accuracy::cubic_families()) {
    accuracy::Random random(9);
    std::array<std::vector<double>, 4> k;
    for (int i = 0; i < 2'000; ++i) {
      const auto cubic = family.draw(random);
      for (size_t n = 0; n < 4; ++n) k[n].push_back(cubic[n]);
    }
    on_each_instruction_set([&](const auto&) {
      std::vector<Roots> out(k[0].size());
      solve_cubics(k[0], k[1], k[2], k[3], out);
      for (size_t i = 0; i < out.size(); ++i) {
        const Roots one = solve_cubic(k[0][i], k[1][i], k[2][i], k[3][i]);
        ASSERT_EQ(out[i].count, one.count) << family.name << ' ' << i;
      }
    });
  }
}

#ifdef NDEBUG  // else an assertion ends the program
TEST(SolveCubics, TheShortestSpanCounts) {
  const std::vector<double> k(10, 1.0);
  std::vector<Roots> room(10);
  room[8].count = -7;
  solve_cubics(k, k, std::span(k).first(8), k, std::span(room).first(9));
  EXPECT_EQ(room[7].count, 1);
  EXPECT_EQ(room[8].count, -7);
}
#endif

}  // namespace
}  // namespace mien
