#include "sdf/arrange/meeting.h"

#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr double kMet = 1e-9;  // [px]

/// Newton steps in both parameters, starting at a share of the way from a to b; NaN where they diverge.
double met_by_newton(const OutlinePiece& left, const OutlinePiece& right, const PairLevel& a,
                     const PairLevel& b, double share) {
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  double t = a.l + share * (b.l - a.l), u = a.r + share * (b.r - a.r);
  for (int i = 0; i < 6; ++i) {
    const double ly = left.y0 + t * (2.0 * left.ay + t * left.by);
    const double dx = x_of(right, u) - x_of(left, t),
                 dy = right.y0 + u * (2.0 * right.ay + u * right.by) - ly;
    if (std::abs(dx) + std::abs(dy) < kMet) {
      const bool within = t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0 && ly >= a.y && ly <= b.y;
      return within ? ly : kNever;
    }
    const double vx = 2.0 * (left.ax + t * left.bx), vy = 2.0 * (left.ay + t * left.by);
    const double wx = 2.0 * (right.ax + u * right.bx), wy = 2.0 * (right.ay + u * right.by);
    const double det = vx * wy - vy * wx;
    if (det == 0.0) return kNever;
    const double by = 1.0 / det;
    t += (dx * wy - dy * wx) * by;
    u += (dx * vy - dy * vx) * by;
    if (!(t > -0.2 && t < 1.2 && u > -0.2 && u < 1.2)) return kNever;
  }
  return kNever;
}

/// Secants, with the value at an end that stays halved (the Illinois rule); every fourth step bisects.
double met_between(const OutlinePiece& left, const OutlinePiece& right, double p, double q,
                   double at_p, double at_q) {
  for (int i = 0, side = 0; i < 60 && q - p > kMet; ++i) {
    const double y = i % 4 == 3 ? 0.5 * (p + q) : p + (q - p) * (at_p / (at_p - at_q));
    const double d = pair_at(left, right, y).gap();
    if (std::abs(d) < kMet) return y;
    if (d > 0.0) {
      p = y, at_p = d;
      if (side == 1) at_q *= 0.5;
      side = 1;
    } else {
      q = y, at_q = d;
      if (side == -1) at_p *= 0.5;
      side = -1;
    }
  }
  return 0.5 * (p + q);
}

}  // namespace

double meeting(const OutlinePiece& left, const OutlinePiece& right, const PairLevel& from,
               const PairLevel& to) {
  PairLevel a = from;
  if (!(to.gap() < 0.0)) return to.y;
  if (!(a.gap() > kTouch)) {  // they begin together: are they apart soon?
    if (a.gap() < -kTouch || !(widening(left, right, a) > 0.0)) return from.y;
    const double height = to.y - from.y;
    for (double step = height * 0x1p-20; step < height && !(a.gap() > kTouch); step *= 4.0)
      a = pair_at(left, right, from.y + step);
    if (!(a.gap() > kTouch)) return from.y;
  }
  const double near = met_by_newton(left, right, a, to, a.gap() / (a.gap() - to.gap()));
  return near == near ? near : met_between(left, right, a.y, to.y, a.gap(), to.gap());
}

}  // namespace mien
