#include "sdf/arrange/meeting.h"

#include <cmath>

namespace mien {
namespace {

constexpr double kMet = 1e-9;  // [px]

/// How fast x changes along y.
double lean(const OutlinePiece& p, double t) {
  return (p.ax + t * p.bx) / (p.ay + t * p.by);
}

/// Newton steps between two heights at which the gap is > 0 and < 0; where they leave those, halves.
double met_between(const OutlinePiece& left, const OutlinePiece& right, const PairLevel& a,
                   const PairLevel& b) {
  double p = a.y, q = b.y, y = p + (q - p) * (a.gap() / (a.gap() - b.gap()));
  for (int i = 0; i < 60 && q - p > kMet; ++i) {
    const PairLevel at = pair_at(left, right, y);
    const double gap = at.gap();
    if (std::abs(gap) < kMet) return y;
    (gap > 0.0 ? p : q) = y;
    y -= gap / (lean(right, at.r) - lean(left, at.l));
    if (!(y > p && y < q) || i % 8 == 7) y = 0.5 * (p + q);
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
  return met_between(left, right, a, to);
}

}  // namespace mien
