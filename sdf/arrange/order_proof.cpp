#include <mien/sdf/arrange/order_proof.h>

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr int kHalvings = 16;  // of a height: what is shorter is not known

class OrderProof {
 public:
  OrderProof(const SweepPiece& left, const SweepPiece& right) : l_(left), r_(right) {}

  bool holds(double from, double to) const { return holds(at(from), at(to), kHalvings); }

 private:
  /// Both pieces at a height.
  struct Level {
    double y, l, r;  ///< parameters
    double gap;
    double bend_l, bend_r;  ///< x''
  };

  static double bend(const SweepPiece& p, double t) {
    const double bends = turning(p), v = std::max(0.0, p.ay + t * p.by);
    return bends == 0.0 ? 0.0 : -0.5 * bends / (v * v * v);
  }

  Level at(double y) const {
    Level level{.y = y, .l = parameter_at(l_, y), .r = parameter_at(r_, y)};
    level.gap = x_at(r_, y) - x_at(l_, y);
    level.bend_l = bend(l_, level.l);
    level.bend_r = bend(r_, level.r);
    return level;
  }

  bool holds(const Level& a, const Level& b, int halvings) const {
    const double slack = std::min(a.gap, b.gap) + kOrder, height = b.y - a.y;
    if (!(slack >= 0.0)) return false;
    const auto sag = [&](const SweepPiece& p, double h) {
      return std::min(p.bulge, 0.5 * std::abs(turning(p)) * h * h * h / height);
    };
    const double sags = (turning(r_) < 0.0 ? sag(r_, b.r - a.r) : 0.0) +
                        (turning(l_) > 0.0 ? sag(l_, b.l - a.l) : 0.0);
    const double bend = std::max(a.bend_r, b.bend_r) - std::min(a.bend_l, b.bend_l),
                 dip = 0.125 * height * height * bend;
    const double lost = std::min(sags, dip);
    if (lost <= slack || lost * height <= 0.25 * kOrder) return true;
    if (halvings == 0) return false;
    const Level middle = at(0.5 * (a.y + b.y));
    return holds(a, middle, halvings - 1) && holds(middle, b, halvings - 1);
  }

  const SweepPiece &l_, &r_;
};

}  // namespace

bool in_order(const SweepPiece& left, const SweepPiece& right, double from, double to) {
  const double slack =
      std::min(x_at(right, from) - x_at(left, from), x_at(right, to) - x_at(left, to)) + kOrder;
  if (slack < 0.0) return false;
  return left.bulge + right.bulge <= slack || OrderProof(left, right).holds(from, to);
}

}  // namespace mien
