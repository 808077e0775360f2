#include "sdf/arrange/order_proof.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {
namespace {

constexpr int kHalvings = 16;  // of a height: shorter stretches count as unproven

bool gap_goes_one_way(const OutlinePiece& l, const OutlinePiece& r, const PairLevel& a,
                      const PairLevel& b) {
  const auto way = [](const OutlinePiece& p, double t) {
    return glm::dvec2(p.ax + t * p.bx, p.ay + t * p.by);
  };
  const glm::dvec2 l0 = way(l, a.l), l1 = way(l, b.l), r0 = way(r, a.r), r1 = way(r, b.r);
  const auto parts = [](glm::dvec2 left, glm::dvec2 right) {
    return right.x * left.y - left.x * right.y;
  };
  const double c00 = parts(l0, r0), c01 = parts(l0, r1), c10 = parts(l1, r0), c11 = parts(l1, r1);
  return std::min({c00, c01, c10, c11}) >= 0.0 || std::max({c00, c01, c10, c11}) <= 0.0;
}

std::optional<double> fails(const OutlinePiece& l, const OutlinePiece& r, const PairLevel& a,
                            const PairLevel& b, double tolerance, int halvings) {
  const double unseen = 0.25 * tolerance, height = b.y - a.y;
  const double over = std::max(a.left_x, b.left_x) - std::min(a.right_x, b.right_x);
  if (over <= tolerance || over * height <= unseen) return {};
  const double slack = std::min(a.gap(), b.gap()) + tolerance;
  if (!(slack >= 0.0)) return a.gap() < b.gap() ? a.y : b.y;
  if (gap_goes_one_way(l, r, a, b)) return {};
  const auto sag = [&](double turns, double h) {
    return std::max(0.0, 0.5 * turns * h * h * h / height);
  };
  const double sags = sag(-turning(r), b.r - a.r) + sag(turning(l), b.l - a.l);
  if (sags <= slack || sags * height <= unseen) return {};
  const PairLevel middle = pair_at(l, r, 0.5 * (a.y + b.y));
  if (halvings == 0) return middle.y;
  const auto above = fails(l, r, a, middle, tolerance, halvings - 1);
  return above ? above : fails(l, r, middle, b, tolerance, halvings - 1);
}

}  // namespace

std::optional<double> disorder(const OutlinePiece& left, const OutlinePiece& right,
                               const PairLevel& from, const PairLevel& to, double order) {
  if (left == right)
    return {};  // of abutting shapes, or of a shape's copies, of which there may be thousands
  return fails(left, right, from, to, order, kHalvings);
}

}  // namespace mien
