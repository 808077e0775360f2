#include "sdf/arrange/crossings.h"
#include "sdf/arrange/order_proof.h"

#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kDeep = 1e-7;  // [px] a shallower dip does not show

/// A pair of pieces in the sweep's order, and the signed gap between them along x.
class Pair {
 public:
  Pair(const SweepPiece& left, const SweepPiece& right) : l_(left), r_(right) {}

  PairLevel at(double y) const { return pair_at(l_, r_, y); }
  double gap(double y) const { return at(y).gap(); }
  double widening(double y) const { return parting(r_, l_, y); }

  /// Whether sign · gap is proven to be > −kDeep between two levels, at little cost.
  bool in_order(const PairLevel& a, const PairLevel& b, double sign) const {
    constexpr int kHalvings = 1;
    if (sign > 0.0) return stays_in_order(l_, r_, a, b, kDeep, kHalvings);
    const auto other = [](const PairLevel& p) {
      return PairLevel{p.y, p.r, p.l, p.right_x, p.left_x};
    };
    return stays_in_order(r_, l_, other(a), other(b), kDeep, kHalvings);
  }
  double meeting(PairLevel a, PairLevel b, double sign) const;
  double dip(double a, double b, double sign, int depth) const;

 private:
  double newton(const PairLevel& a, const PairLevel& b, double share) const;
  double bracketed(double p, double q, double at_p, double at_q, double sign) const;

  const SweepPiece &l_, &r_;
};

/// Newton steps in both parameters, starting at a share of the way from a to b; NaN where they diverge.
double Pair::newton(const PairLevel& a, const PairLevel& b, double share) const {
  constexpr double kClose = 1e-9;  // [px]
  double t = a.l + share * (b.l - a.l), u = a.r + share * (b.r - a.r);
  for (int i = 0; i < 6; ++i) {
    const double lx = x_of(l_, t), ly = l_.y0 + t * (2.0 * l_.ay + t * l_.by);
    const double rx = x_of(r_, u), ry = r_.y0 + u * (2.0 * r_.ay + u * r_.by);
    const double dx = rx - lx, dy = ry - ly;
    if (std::abs(dx) + std::abs(dy) < kClose)
      return ly >= a.y && ly <= b.y && t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0 ? ly : kNever;
    const double vx = 2.0 * (l_.ax + t * l_.bx), vy = 2.0 * (l_.ay + t * l_.by);
    const double wx = 2.0 * (r_.ax + u * r_.bx), wy = 2.0 * (r_.ay + u * r_.by);
    const double det = vx * wy - vy * wx;
    if (det == 0.0) return kNever;
    const double by = 1.0 / det;
    t += (dx * wy - dy * wx) * by;
    u += (dx * vy - dy * vx) * by;
    if (!(t > -0.2 && t < 1.2 && u > -0.2 && u < 1.2)) return kNever;
  }
  return kNever;
}

/// The zero of sign · gap, which is at_p > 0 at p and at_q < 0 at q. Secants, with the value at an end that stays
/// halved (the Illinois rule); every fourth step bisects.
double Pair::bracketed(double p, double q, double at_p, double at_q, double sign) const {
  for (int i = 0, side = 0; i < 60 && q - p > 1e-9; ++i) {
    const double y = i % 4 == 3 ? 0.5 * (p + q) : p + (q - p) * (at_p / (at_p - at_q));
    const double d = sign * gap(y);
    if (std::abs(d) < 1e-9) return y;
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

/// The height between a and b at which sign · gap falls from > 0 to < 0. Pieces that touch at an end
/// are followed until they are apart.
double Pair::meeting(PairLevel a, PairLevel b, double sign) const {
  constexpr double kFirstStep = 0x1p-20;
  const double height = b.y - a.y, from = a.y, to = b.y;
  if (!(sign * a.gap() > kTouch)) {  // they begin together: apart at first?
    if (!(sign * widening(from) >= 0.0)) return from;
    double step = height * kFirstStep;
    for (; step < height; step *= 4.0) {
      a = at(from + step);
      if (sign * a.gap() > kTouch) break;
      if (sign * a.gap() < -kTouch) return from;
    }
    if (!(step < height)) return from;
  }
  if (!(sign * b.gap() < 0.0)) {  // they end together: apart before?
    double step = (to - a.y) * kFirstStep;
    for (; step < to - a.y; step *= 4.0) {
      b = at(to - step);
      if (sign * b.gap() < -kTouch) break;
      if (sign * b.gap() > kTouch) return to;
    }
    if (!(step < to - a.y)) return to;
  }
  const double near = newton(a, b, a.gap() / (a.gap() - b.gap()));
  if (near == near) return near;
  return bracketed(a.y, b.y, sign * a.gap(), sign * b.gap(), sign);  // Newton went astray
}

/// A height between a and b at which sign · gap is negative although it is >= 0 at both. Where the gap is convex
/// its slopes decide; where neither convexity nor concavity is proven, halving does.
double Pair::dip(double a, double b, double sign, int depth) const {
  if (sign * widening(a) < 0.0 && sign * widening(b) > 0.0) {
    double p = a, q = b;
    for (int i = 0; i < 24 && q - p > kDeep; ++i) {
      const double m = 0.5 * (p + q);
      if (sign * gap(m) < -kDeep) return m;
      (sign * widening(m) < 0.0 ? p : q) = m;
    }
  }
  if (depth == 0) return kNever;
  // Along y, x'' is −turning / (2 v³) with v the speed down: does its difference keep its sign?
  const double bends_l = turning(l_), bends_r = turning(r_);
  if (bends_l * bends_r <= 0.0) return kNever;
  const auto bends = [&](double y) {
    const double v = l_.ay + parameter_at(l_, y) * l_.by, w = r_.ay + parameter_at(r_, y) * r_.by;
    return bends_l * w * w * w - bends_r * v * v * v;
  };
  if (bends(a) * bends(b) > 0.0) return kNever;
  const double m = 0.5 * (a + b);
  if (sign * gap(m) < -kDeep) return m;
  const double first = dip(a, m, sign, depth - 1);
  return first == first ? first : dip(m, b, sign, depth - 1);
}

void there_and_back(const Pair& pair, const PairLevel& a, const PairLevel& b, double sign,
                    Crossings& out) {
  if (!(b.y - a.y > 1e-9) || pair.in_order(a, b, sign)) return;
  const double m = pair.dip(a.y, b.y, sign, 2);
  if (!(m == m)) return;
  const PairLevel middle = pair.at(m);
  out.add(pair.meeting(a, middle, sign));
  out.add(pair.meeting(middle, b, -sign));
}

/// The gap at the end of the piece that ends first. The sweep is there, so a level piece is met at that point.
double gap_at_end(const SweepPiece& left, const SweepPiece& right) {
  const bool left_first = before(left.x1, left.y1, right.x1, right.y1);
  const double y = left_first ? left.y1 : right.y1, x = left_first ? left.x1 : right.x1;
  return x_there(right, y, x) - x_there(left, y, x);
}

}  // namespace

SweepPiece sweep_piece(const OutlinePiece& piece, int outline, int turn) {
  SweepPiece made{piece};
  made.outline = outline, made.turn = turn;
  const double wide = piece.x1 - piece.x0, high = piece.y1 - piece.y0;
  constexpr double kFloat = 0x1p-23;  // more than a rounding, relative to what is rounded
  const double lowest = std::min(piece.x0, piece.x1), highest = std::max(piece.x0, piece.x1);
  made.lowest_x = float(lowest - kFloat * std::abs(lowest));
  made.highest_x = float(highest + kFloat * std::abs(highest));
  // Half the control point's distance from the chord, along x. An almost level piece has no usable lean: its bulge
  // is its whole width, and it has no tangents.
  constexpr double kLevel = 1e-4, kSteepest = 1e9, kLeast = 1e-9;
  const double off = wide * piece.ay - high * piece.ax, most = std::abs(wide);
  const bool level = !(high > kLevel * most), convex = off > 0.0;
  const double up = 1.0 / (level ? 1.0 : high), lean = level ? kNever : wide * up,
               bulge = std::min(0.5 * std::abs(off) * up, most) * (1.0 + 1e-6) + kLeast;
  made.lean = level ? 0.0 : lean;
  made.left_bulge = level ? most : convex ? bulge : kLeast;
  made.right_bulge = level ? most : convex ? kLeast : bulge;
  const auto tangent = [&](double x, double y) {
    return !level && std::abs(x) <= kSteepest * y ? x / y : kNever;
  };
  const double top = tangent(piece.ax, piece.ay),
               bottom = tangent(piece.ax + piece.bx, piece.ay + piece.by);
  made.low_top = convex ? top : lean, made.low_bottom = convex ? bottom : lean;
  made.high_top = convex ? lean : top, made.high_bottom = convex ? lean : bottom;
  return made;
}

Crossings crossings(const SweepPiece& left, const SweepPiece& right, double y) {
  Crossings found;
  const double end = std::min(left.y1, right.y1);
  if (tangent_gap(left, right, y, end) > -kDeep || coincide(left, right)) return found;
  if (!(end > y)) {
    if (gap_at_end(left, right) < -kTouch) found.add(y);
    return found;
  }
  const Pair pair(left, right);
  const PairLevel a = pair.at(y), b = pair.at(end);
  const bool once = b.gap() < -kTouch, one_way = trend(left, right, a, b) != 0;
  if (!once) {
    if (!one_way) there_and_back(pair, a, b, 1.0, found);
    return found;
  }
  const double at = pair.meeting(a, b, 1.0);
  found.one_way = one_way;
  if (one_way) {
    found.add(at);
    return found;
  }
  const PairLevel middle = pair.at(at);
  there_and_back(pair, a, middle, 1.0, found);
  found.add(at);
  if (found.count < 3) there_and_back(pair, middle, b, -1.0, found);
  return found;
}

}  // namespace mien
