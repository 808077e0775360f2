#include <mien/sdf/arrange/order_proof.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr int kHalvings = 16;  // of a height: what is shorter is not known

class OrderProof {
 public:
  OrderProof(const SweepPiece& left, const SweepPiece& right, double tolerance)
      : l_(left), r_(right), tolerance_(tolerance) {}

  bool holds(double from, double to, int halvings) const {
    return holds(at(from), at(to), halvings);
  }

 private:
  /// Both pieces at a height: their parameters and places.
  struct Level {
    double y, l, r, left_x, right_x;
    double gap() const { return right_x - left_x; }
  };

  Level at(double y) const {
    const double l = parameter_at(l_, y), r = parameter_at(r_, y);
    return {y, l, r, x_of(l_, l), x_of(r_, r)};
  }

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

  bool holds(const Level& a, const Level& b, int halvings) const {
    const double slack = std::min(a.gap(), b.gap()) + tolerance_, height = b.y - a.y;
    if (!(slack >= 0.0)) return false;
    if (std::max(a.left_x, b.left_x) <= std::min(a.right_x, b.right_x) + tolerance_) return true;
    const auto sag = [&](const SweepPiece& p, double bulge, double h) {
      return std::min(bulge, 0.5 * std::abs(turning(p)) * h * h * h / height);
    };
    const double sags = sag(r_, r_.left_bulge, b.r - a.r) + sag(l_, l_.right_bulge, b.l - a.l);
    if (sags <= slack || sags * height <= 0.25 * tolerance_) return true;
    const double bends = std::max(bend(r_, a.r), bend(r_, b.r)) -
                         std::min(bend(l_, a.l), bend(l_, b.l)),
                 dip = 0.125 * height * height * bends;
    if (lowest(a.gap(), b.gap(), dip) >= -tolerance_ || dip * height <= 0.25 * tolerance_)
      return true;
    if (halvings == 0) return false;
    const Level middle = at(0.5 * (a.y + b.y));
    return holds(a, middle, halvings - 1) && holds(middle, b, halvings - 1);
  }

  const SweepPiece &l_, &r_;
  double tolerance_;
};

}  // namespace

bool in_order(const SweepPiece& left, const SweepPiece& right, double from, double to) {
  if (least_gap(left, right, from, to) >= -kOrder || coincide(left, right)) return true;
  return stays_in_order(left, right, from, to, kOrder, kHalvings);
}

bool stays_in_order(const SweepPiece& left, const SweepPiece& right, double from, double to,
                    double tolerance, int halvings) {
  return OrderProof(left, right, tolerance).holds(from, to, halvings);
}

}  // namespace mien
