#include <mien/render/cover/arrangement.h>
#include <mien/render/cover/edge_coverage.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace mien {
namespace {

std::map<std::uint32_t, double> areas(Arrangement& arrangement, std::span<const Cut> cuts) {
  std::map<std::uint32_t, double> by_side;
  for (const auto& piece : arrangement.cut(cuts)) by_side[piece.inside] += piece.area;
  return by_side;
}

TEST(Arrangement, OfOneCutIsTheClosedForm) {
  Arrangement arrangement;
  for (double theta = 0; theta < 6.28; theta += 0.1)
    for (double d = -0.8; d < 0.8; d += 0.05) {
      const Cut cut{d, {std::cos(theta), std::sin(theta)}};
      EXPECT_NEAR(areas(arrangement, {&cut, 1})[1], straight_edge_coverage(d, cut.normal), 1e-14);
    }
}

TEST(Arrangement, PiecesFillTheSquareAndAgreeWithSamples) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(0, 6.2831853), offset(-0.6, 0.6);
  Arrangement arrangement;
  for (int round = 0; round < 300; ++round) {
    std::vector<Cut> cuts;
    for (int i = 0; i < 1 + round % 8; ++i) {
      const double a = angle(random);
      cuts.push_back({offset(random), {std::cos(a), std::sin(a)}});
    }
    auto by_side = areas(arrangement, cuts);
    double sum = 0;
    for (const auto& [side, area] : by_side) sum += area;
    EXPECT_NEAR(sum, 1, 1e-13);
    std::map<std::uint32_t, double> sampled;
    const int n = 128;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const glm::dvec2 p{(i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5};
        std::uint32_t side = 0;
        for (std::size_t k = 0; k < cuts.size(); ++k)
          side |= (cuts[k].d + p.x * cuts[k].normal.x + p.y * cuts[k].normal.y < 0 ? 1u : 0u) << k;
        sampled[side] += 1.0 / (n * n);
      }
    for (const auto& [side, area] : sampled) EXPECT_NEAR(by_side[side], area, 0.02);
  }
}

TEST(Arrangement, TwoEqualCutsLeaveNothingBetweenThem) {
  Arrangement arrangement;
  for (const glm::dvec2 n : {glm::dvec2{1, 0}, glm::dvec2{0.6, 0.8}}) {
    const std::vector<Cut> cuts{{0.1, n}, {-0.1, -n}};  // one line, seen from both sides
    auto by_side = areas(arrangement, cuts);
    EXPECT_NEAR(by_side[1] + by_side[2], 1, 1e-15);
    EXPECT_NEAR(by_side[0] + by_side[3], 0, 1e-15);
  }
}

TEST(Arrangement, AnEdgeAlongASideOfTheSquareTakesAllOrNothing) {
  Arrangement arrangement;
  const Cut cut{-0.5, {1, 0}};
  EXPECT_EQ(areas(arrangement, {&cut, 1})[1], 1);
  const Cut other{0.5, {1, 0}};
  EXPECT_EQ(areas(arrangement, {&other, 1})[0], 1);
}

}  // namespace
}  // namespace mien
