#include "sdf/arrange/order_proof.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {
namespace {

constexpr int kHalvings = 16;  // of a height: shorter stretches count as unproven

class OrderProof {
 public:
  OrderProof(const OutlinePiece& left, const OutlinePiece& right, double tolerance)
      : l_(left), r_(right), tolerance_(tolerance) {}

  std::optional<double> fails(const PairLevel& a, const PairLevel& b, int halvings) const;

 private:
  bool gap_goes_one_way(const PairLevel& a, const PairLevel& b) const;

  const OutlinePiece &l_, &r_;
  double tolerance_;
};

bool OrderProof::gap_goes_one_way(const PairLevel& a, const PairLevel& b) const {
  const auto way = [](const OutlinePiece& p, double t) {
    return glm::dvec2(p.ax + t * p.bx, p.ay + t * p.by);
  };
  const glm::dvec2 l0 = way(l_, a.l), l1 = way(l_, b.l), r0 = way(r_, a.r), r1 = way(r_, b.r);
  const auto parts = [](glm::dvec2 l, glm::dvec2 r) { return r.x * l.y - l.x * r.y; };
  const double c00 = parts(l0, r0), c01 = parts(l0, r1), c10 = parts(l1, r0), c11 = parts(l1, r1);
  return std::min({c00, c01, c10, c11}) >= 0.0 || std::max({c00, c01, c10, c11}) <= 0.0;
}

std::optional<double> OrderProof::fails(const PairLevel& a, const PairLevel& b,
                                        int halvings) const {
  const double unseen = 0.25 * tolerance_, height = b.y - a.y;
  const double over = std::max(a.left_x, b.left_x) - std::min(a.right_x, b.right_x);
  if (over <= tolerance_ || over * height <= unseen) return {};
  const double slack = std::min(a.gap(), b.gap()) + tolerance_;
  if (!(slack >= 0.0)) return a.gap() < b.gap() ? a.y : b.y;
  if (gap_goes_one_way(a, b)) return {};
  const auto sag = [&](const OutlinePiece& p, double h) {
    return 0.5 * std::abs(turning(p)) * h * h * h / height;
  };
  const double sags = sag(r_, b.r - a.r) + sag(l_, b.l - a.l);
  if (sags <= slack || sags * height <= unseen) return {};
  const PairLevel middle = pair_at(l_, r_, 0.5 * (a.y + b.y));
  if (halvings == 0) return middle.y;
  const auto above = fails(a, middle, halvings - 1);
  return above ? above : fails(middle, b, halvings - 1);
}

}  // namespace

std::optional<double> disorder(const OutlinePiece& left, const OutlinePiece& right,
                               const PairLevel& from, const PairLevel& to, double order) {
  if (left == right)
    return {};  // of abutting shapes, or of a shape's copies, of which there may be thousands
  return OrderProof(left, right, order).fails(from, to, kHalvings);
}

}  // namespace mien
