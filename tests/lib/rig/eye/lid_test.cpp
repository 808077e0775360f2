#include "lib/rig/eye/lid.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <random>

namespace mien {
namespace {

constexpr QuadBezier kEdge{{0.08, -0.02}, {0.2, 0.31}, {0.39, 0.03}};
constexpr int kBends = OpeningFigure::kLidBends;

glm::dvec2 at(const LidPieces& pieces, double t) {
  const int i = std::min(kBends - 1, int(t * kBends));
  return point(pieces[std::size_t(i)], t * kBends - i);
}

TEST(Lid, CutIntoBendsIsTheSameCurve) {
  const LidPieces pieces = pieces_between(kEdge.p0, lid_bends(kEdge), kEdge.p2);
  for (double t = 0; t <= 1; t += 0.003)
    EXPECT_LT(glm::length(at(pieces, t) - point(kEdge, t)), 1e-15) << t;
  for (double t = 0; t <= 1; t += 0.1)
    EXPECT_LT(glm::length(polar_form(kEdge, t, t) - point(kEdge, t)), 1e-15);
}

/// Wherever its bends are moved to, an edge has no kink, and hangs on the canthi.
TEST(Lid, StaysSmoothHoweverItIsPushed) {
  std::mt19937 random{1};
  std::uniform_real_distribution<double> unit{-0.02, 0.02};
  for (int turn = 0; turn < 100; ++turn) {
    LidBends shifts, bends = lid_bends(kEdge);
    for (std::size_t i = 0; i < bends.size(); ++i)
      shifts[i] = {unit(random), unit(random)}, bends[i] += shifts[i];
    const LidPieces pieces = pieces_between(kEdge.p0, bends, kEdge.p2);
    EXPECT_EQ(pieces.front().p0, kEdge.p0);
    EXPECT_EQ(pieces.back().p2, kEdge.p2);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
      EXPECT_EQ(pieces[i].p2, pieces[i + 1].p0);
      EXPECT_LT(glm::length(tangent(pieces[i], 1) - tangent(pieces[i + 1], 0)), 1e-15);
    }
    for (double t = 0; t < 1; t += 0.01)  // what rides on the edge goes where the edge goes
      EXPECT_LT(glm::length(at(pieces, t) - point(kEdge, t) - shift_along(shifts, t, t)), 1e-15)
          << t;
  }
}

TEST(Lid, RidersMoveAsTheEdgeDoes) {
  const glm::dvec2 way{0.03, -0.2};
  const QuadBezier moved{kEdge.p0, kEdge.p1 + way, kEdge.p2};
  for (double a = 0; a <= 1; a += 0.13)
    for (double b = a; b <= 1; b += 0.17)
      EXPECT_LT(
          glm::length(polar_form(moved, a, b) - polar_form(kEdge, a, b) - bend_share(a, b) * way),
          1e-15);
}

TEST(Lid, FindsTheNearestParameter) {
  for (double t = 0; t <= 1; t += 0.05) {
    const glm::dvec2 along = glm::normalize(tangent(kEdge, t));
    const glm::dvec2 off = point(kEdge, t) + 0.01 * glm::dvec2{-along.y, along.x};
    EXPECT_NEAR(nearest_parameter(kEdge, off), t, 1e-7);
  }
  EXPECT_NEAR(nearest_parameter(kEdge, {-5, -1}), 0, 1e-9);
}

}  // namespace
}  // namespace mien
