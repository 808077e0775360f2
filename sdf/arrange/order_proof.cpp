#include "sdf/arrange/order_proof.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

namespace mien {
namespace {

constexpr int kHalvings = 16;  // of a height: shorter stretches count as unproven

class OrderProof {
 public:
  OrderProof(const SweepPiece& left, const SweepPiece& right, double tolerance)
      : l_(left), r_(right), tolerance_(tolerance) {}

  bool holds(const PairLevel& a, const PairLevel& b, int halvings) const;

 private:
  /// x'' at a parameter.
  static double bend(const SweepPiece& p, double t) {
    const double bends = turning(p), v = std::max(0.0, p.ay + t * p.by);
    return bends == 0.0 ? 0.0 : -0.5 * bends / (v * v * v);
  }

  /// The least of a (1 − s) + b s − 4 dip s (1 − s) for s in [0, 1].
  static double lowest(double a, double b, double dip) {
    const double rise = b - a;
    if (std::abs(rise) >= 4.0 * dip) return std::min(a, b);
    return 0.5 * (a + b) - dip - rise * rise / (16.0 * dip);
  }

  const SweepPiece &l_, &r_;
  double tolerance_;
};

bool OrderProof::holds(const PairLevel& a, const PairLevel& b, int halvings) const {
  const double slack = std::min(a.gap(), b.gap()) + tolerance_, height = b.y - a.y;
  if (!(slack >= 0.0)) return false;
  if (std::max(a.left_x, b.left_x) <= std::min(a.right_x, b.right_x) + tolerance_) return true;
  if (trend(l_, r_, a, b) != 0) return true;
  const auto sag = [&](const SweepPiece& p, double bulge, double h) {
    return std::min(bulge, 0.5 * std::abs(turning(p)) * h * h * h / height);
  };
  const double sags = sag(r_, r_.left_bulge, b.r - a.r) + sag(l_, l_.right_bulge, b.l - a.l);
  if (sags <= slack || sags * height <= 0.25 * tolerance_) return true;
  const double bends =
                   std::max(bend(r_, a.r), bend(r_, b.r)) - std::min(bend(l_, a.l), bend(l_, b.l)),
               dip = 0.125 * height * height * bends;
  if (lowest(a.gap(), b.gap(), dip) >= -tolerance_ || dip * height <= 0.25 * tolerance_)
    return true;
  if (halvings == 0) return false;
  const PairLevel middle = pair_at(l_, r_, 0.5 * (a.y + b.y));
  return holds(a, middle, halvings - 1) && holds(middle, b, halvings - 1);
}

}  // namespace

int trend(const SweepPiece& left, const SweepPiece& right, const PairLevel& a, const PairLevel& b) {
  const auto way = [](const SweepPiece& p, double t) {
    return glm::dvec2(p.ax + t * p.bx, p.ay + t * p.by);
  };
  const glm::dvec2 l0 = way(left, a.l), l1 = way(left, b.l), r0 = way(right, a.r),
                   r1 = way(right, b.r);
  const auto parts = [](glm::dvec2 l, glm::dvec2 r) { return r.x * l.y - l.x * r.y; };
  const double c00 = parts(l0, r0), c01 = parts(l0, r1), c10 = parts(l1, r0), c11 = parts(l1, r1);
  return int(std::min({c00, c01, c10, c11}) > 0.0) - int(std::max({c00, c01, c10, c11}) < 0.0);
}

bool in_order(const SweepPiece& left, const SweepPiece& right, double from, double to,
              double order) {
  if (chord_gap(left, right, from, to) >= -order || coincide(left, right)) return true;
  return stays_in_order(left, right, pair_at(left, right, from), pair_at(left, right, to), order,
                        kHalvings);
}

bool stays_in_order(const SweepPiece& left, const SweepPiece& right, const PairLevel& from,
                    const PairLevel& to, double tolerance, int halvings) {
  return OrderProof(left, right, tolerance).holds(from, to, halvings);
}

}  // namespace mien
