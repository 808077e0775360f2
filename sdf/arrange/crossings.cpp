#include <mien/sdf/arrange/crossings.h>
#include <mien/sdf/arrange/order_proof.h>

#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kDeep = 1e-7;  // [px] what dips less shows nowhere

/// The signed distance along x, of a pair in the order the sweep has them.
class Pair {
 public:
  Pair(const SweepPiece& left, const SweepPiece& right) : l_(left), r_(right) {}

  double gap(double y) const { return x_at(r_, y) - x_at(l_, y); }
  double widening(double y) const { return parting(r_, l_, y); }

  /// The gap where the first of both ends, in the sweep's order.
  double last_gap() const {
    const bool left_first = before(l_.x1, l_.y1, r_.x1, r_.y1);
    const double y = left_first ? l_.y1 : r_.y1, x = left_first ? l_.x1 : r_.x1;
    return x_there(r_, y, x) - x_there(l_, y, x);
  }

  /// No direction of one is a direction of the other: the gap grows all along, or falls.
  bool one_way() const {
    const double lx = l_.ax + l_.bx, ly = l_.ay + l_.by, rx = r_.ax + r_.bx, ry = r_.ay + r_.by;
    const double a = l_.ax * r_.ay - r_.ax * l_.ay, b = l_.ax * ry - rx * l_.ay,
                 c = lx * r_.ay - r_.ax * ly, d = lx * ry - rx * ly;
    return (a > 0 && b > 0 && c > 0 && d > 0) || (a < 0 && b < 0 && c < 0 && d < 0);
  }

  /// Whether sign · gap is proven to be > −kDeep between two heights, at little cost.
  bool in_order(double a, double b, double sign) const {
    constexpr int kHalvings = 1;
    return sign > 0.0 ? stays_in_order(l_, r_, a, b, kDeep, kHalvings)
                      : stays_in_order(r_, l_, a, b, kDeep, kHalvings);
  }
  double meeting(double a, double b, double sign) const;
  double dip(double a, double b, double sign, int depth) const;

 private:
  double newton(double y, double a, double b) const;

  const SweepPiece &l_, &r_;
};

/// Newton's steps in both parameters; none where they lead astray.
double Pair::newton(double y, double a, double b) const {
  constexpr double kClose = 1e-9;  // [px]
  double t = parameter_at(l_, y), u = parameter_at(r_, y);
  for (int i = 0; i < 6; ++i) {
    const double lx = x_of(l_, t), ly = l_.y0 + t * (2.0 * l_.ay + t * l_.by);
    const double rx = x_of(r_, u), ry = r_.y0 + u * (2.0 * r_.ay + u * r_.by);
    const double dx = rx - lx, dy = ry - ly;
    if (std::abs(dx) + std::abs(dy) < kClose)
      return ly >= a && ly <= b && t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0 ? ly : kNever;
    const double vx = 2.0 * (l_.ax + t * l_.bx), vy = 2.0 * (l_.ay + t * l_.by);
    const double wx = 2.0 * (r_.ax + u * r_.bx), wy = 2.0 * (r_.ay + u * r_.by);
    const double det = vx * wy - vy * wx;
    if (det == 0.0) return kNever;
    t += (dx * wy - dy * wx) / det;
    u += (dx * vy - dy * vx) / det;
    if (!(t > -0.2 && t < 1.2 && u > -0.2 && u < 1.2)) return kNever;
  }
  return kNever;
}

/// The height between a and b at which sign · gap falls from > 0 to < 0. Pieces that touch at an end
/// are followed until they are apart.
double Pair::meeting(double a, double b, double sign) const {
  double at_a = sign * gap(a), at_b = sign * gap(b);
  constexpr double kFirstStep = 0x1p-20;
  if (!(at_a > kTouch)) {  // they begin together: apart at first?
    if (!(sign * widening(a) >= 0.0)) return a;
    double step = (b - a) * kFirstStep;
    for (; step < b - a; step *= 4.0) {
      at_a = sign * gap(a + step);
      if (at_a > kTouch) break;
      if (at_a < -kTouch) return a;
    }
    if (!(step < b - a)) return a;
    a += step;
  }
  if (!(at_b < 0.0)) {  // they end together: apart before?
    double step = (b - a) * kFirstStep;
    for (; step < b - a; step *= 4.0) {
      at_b = sign * gap(b - step);
      if (at_b < -kTouch) break;
      if (at_b > kTouch) return b;
    }
    if (!(step < b - a)) return b;
    b -= step;
  }
  const double near = newton(a + (b - a) * (at_a / (at_a - at_b)), a, b);
  if (near == near) return near;
  // Newton went astray: a bracket, by secants whose end that stays counts half.
  for (int i = 0, side = 0; i < 60 && b - a > 1e-9; ++i) {
    const double y = i % 4 == 3 ? 0.5 * (a + b) : a + (b - a) * (at_a / (at_a - at_b));
    const double d = sign * gap(y);
    if (std::abs(d) < 1e-9) return y;
    if (d > 0.0) {
      a = y, at_a = d;
      if (side == 1) at_b *= 0.5;
      side = 1;
    } else {
      b = y, at_b = d;
      if (side == -1) at_a *= 0.5;
      side = -1;
    }
  }
  return 0.5 * (a + b);
}

/// A height between a and b, at whose ends sign · gap >= 0, where it is less than nothing. Where the
/// gap is convex that is decided by its slopes; where neither convex nor concave is sure, by halves.
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

void there_and_back(const Pair& pair, double a, double b, double sign, Crossings& out) {
  if (!(b - a > 1e-9) || pair.in_order(a, b, sign)) return;
  const double m = pair.dip(a, b, sign, 2);
  if (!(m == m)) return;
  out.add(pair.meeting(a, m, sign));
  out.add(pair.meeting(m, b, -sign));
}

}  // namespace

SweepPiece sweep_piece(const OutlinePiece& piece) {
  SweepPiece made{piece};
  const double wide = piece.x1 - piece.x0, high = piece.y1 - piece.y0;
  made.lowest_x = std::nextafter(float(std::min(piece.x0, piece.x1)), -HUGE_VALF);
  made.highest_x = std::nextafter(float(std::max(piece.x0, piece.x1)), HUGE_VALF);
  // Half the control point's distance from the chord, along x. A piece as good as level has no lean to
  // speak of: all its width.
  constexpr double kLevel = 1e-4;
  const double off = wide * piece.ay - high * piece.ax, most = std::abs(wide);
  made.lean = 0.0, made.left_bulge = made.right_bulge = most;
  if (high > kLevel * most) {
    made.lean = wide / high;
    const double bulge = std::min(0.5 * std::abs(off) / high, most) * (1.0 + 1e-6) + 1e-9;
    made.left_bulge = off > 0.0 ? bulge : 1e-9, made.right_bulge = off > 0.0 ? 1e-9 : bulge;
  }
  return made;
}

Crossings crossings(const SweepPiece& left, const SweepPiece& right, double y) {
  Crossings found;
  if (coincide(left, right)) return found;
  const double end = std::min(left.y1, right.y1);
  if (least_gap(left, right, y, end) > 0.0) return found;
  if (least_gap(right, left, y, end) > 0.0) {
    found.add(y);
    return found;
  }
  const Pair pair(left, right);
  const double last = pair.last_gap();
  const bool once = last < -kTouch;
  if (!(end > y)) {
    if (once) found.add(y);
    return found;
  }
  if (once) {
    const double at = pair.meeting(y, end, 1.0);
    if (pair.one_way()) {
      found.add(at);
      return found;
    }
    there_and_back(pair, y, at, 1.0, found);
    found.add(at);
    if (found.count < 3) there_and_back(pair, at, end, -1.0, found);
    return found;
  }
  if (pair.one_way()) return found;
  there_and_back(pair, y, end, 1.0, found);
  return found;
}

}  // namespace mien
