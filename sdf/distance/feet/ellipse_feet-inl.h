// Feet on ellipses, many places at a time. Included once per instruction set. The equations: ellipse_feet.cpp.
#if defined(MIEN_SDF_DISTANCE_ELLIPSE_FEET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_DISTANCE_ELLIPSE_FEET_INL_H_
#undef MIEN_SDF_DISTANCE_ELLIPSE_FEET_INL_H_
#else
#define MIEN_SDF_DISTANCE_ELLIPSE_FEET_INL_H_
#endif

#include "sdf/distance/feet/spine_feet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

/// A place in the frame of the longer radius a, in its first quadrant.
struct QuadrantPlace {
  Reals a, b, x, y;
};

/// A direction, and the last step that led there: how far it turned, and the slope that it went by.
struct Turning {
  Reals c, s, turn, rise;
};

/// Newton's method on (E − p) · E', by turns of at most a quarter radian.
HWY_INLINE Turning TurnedTo(const QuadrantPlace& e, Reals c, Reals s, int steps) {
  const Reals one = All(1.0), quarter = All(0.25);
  Turning at{c, s, one, one};
  for (int i = 0; i < steps; ++i) {
    const Reals ex = e.a * at.c, ey = e.b * at.s, gx = -e.a * at.s, gy = e.b * at.c;
    const Reals qx = ex - e.x, qy = ey - e.y;
    at.rise = gx * gx + gy * gy - (qx * ex + qy * ey);
    const Reals whole = -(qx * gx + qy * gy) / at.rise;
    at.turn = Most(Least(whole, quarter), -quarter);
    const Reals half = All(0.5) * at.turn, over = one / (one + half * half);
    const Reals cos = (one - half * half) * over, sin = at.turn * over;
    const Reals turned = at.c * cos - at.s * sin;
    at.s = at.s * cos + at.c * sin, at.c = turned;
  }
  const Reals over = one / Root(at.c * at.c + at.s * at.s);
  at.c = at.c * over, at.s = at.s * over;
  return at;
}

HWY_INLINE Truths HasSettled(const Turning& at) {
  return Both(Size(at.turn) < All(0x1p-28), at.rise > All(0.0));
}

HWY_INLINE Turning NearSideOf(const QuadrantPlace& e) {
  const Reals focal = (e.a - e.b) * (e.a + e.b), ax = e.a * e.x, by = e.b * e.y, one = All(1.0);
  const Reals least = Most(Most(by, ax - focal), All(1e-290));
  Reals v = least;
  // Of √((A / (v + F))² + (C / v)²) = 1, by Newton's method on the inverse: it never passes the root.
  for (int i = 0; i < 5; ++i) {
    const Reals over_f = one / (v + focal), over = one / v;
    const Reals c = ax * over_f, s = by * over, n2 = c * c + s * s;
    v = Most(v + (Root(n2) - one) * n2 / (c * c * over_f + s * s * over), least);
  }
  Reals c = ax / (v + focal), s = by / v;
  const Truths on_axis = Without(ax<focal, by> All(0.0));
  s = Choose(on_axis, Root(Most(one - c * c, All(0.0))), s);
  const Reals over = one / Root(Most(c * c + s * s, All(1e-290)));
  Turning at = TurnedTo(e, c * over, s * over, 3);
  at.c = Most(at.c, All(0.0)), at.s = Most(at.s, All(0.0));
  return at;
}

/// `is_there`, or in doubt: within a millionth of the evolute.
HWY_INLINE Turning FarSideOf(const QuadrantPlace& e, Truths& is_there, Truths& doubt) {
  const Reals focal = (e.a - e.b) * (e.a + e.b), ax = e.a * e.x, by = e.b * e.y, one = All(1.0);
  const Reals f2 = focal * focal, rest = f2 - ax * ax - by * by, cube = rest * rest * rest;
  const Reals product = ax * by, square = All(27.0) * f2 * (product * product);
  is_there = Both(rest > All(0.0), cube > square);
  doubt =
      Either(doubt, Both(rest > -All(1e-5) * f2, Size(cube - square) < All(1e-5) * (f2 * f2 * f2)));
  if (!Any(is_there)) return {one, one, one, one};
  const Reals sine = Least(ax / Most(focal - by, All(1e-290)), one);
  const Turning at = TurnedTo(e, sine, -Root(one - sine * sine), 6);
  const Truths fits = Both(HasSettled(at), Both(at.s<All(0.0), at.c> - All(0x1p-40)));
  doubt = Either(doubt, Without(is_there, fits));
  return {Most(at.c, All(0.0)), at.s, at.turn, at.rise};
}

HWY_INLINE Reals AngleOf(Reals c, Reals s) {
  const Reals x = Size(c), y = Size(s), one = All(1.0), pi = All(3.14159265358979323846);
  const Reals u = Least(x, y) / Most(x, y);
  const Reals v = u / (one + Root(one + u * u)), w = v / (one + Root(one + v * v)), w2 = w * w;
  Reals series = All(0.0);
  for (int i = AngleSeries::kTerms - 1; i >= 0; --i) series = All(1.0 / (2 * i + 1)) - w2 * series;
  Reals angle = All(4.0) * w * series;
  angle = Choose(y > x, All(0.5) * pi - angle, angle);
  angle = Choose(c < All(0.0), pi - angle, angle);
  return Signed(angle, s);
}

struct EllipseNumbers {
  double cx, cy, ax, ay, rx, ry;
};

/// Both feet; adds to `doubt` what has not settled.
HWY_INLINE void EllipseFeet(const EllipseNumbers& f, Reals px, Reals py, RankedFeet& best,
                            RankedFeet& next, Truths& doubt) {
  const Reals dx = px - All(f.cx), dy = py - All(f.cy), ax = All(f.ax), ay = All(f.ay);
  const Reals x = dx * ax + dy * ay, y = ax * dy - ay * dx, one = All(1.0), rx = All(f.rx),
              ry = All(f.ry);
  const bool tall = f.rx < f.ry;
  const QuadrantPlace e =
      tall ? QuadrantPlace{ry, rx, Size(y), Size(x)} : QuadrantPlace{rx, ry, Size(x), Size(y)};
  Reals hand = one;
  const auto foot_on = [&](const Turning& at, bool is_far) HWY_ATTR {
    const Reals c = Signed(one, x) * (tall ? at.s : at.c),
                s = Signed(one, y) * (tall ? at.c : at.s);
    const Reals ex = rx * c, ey = ry * s, half = All(-0.5), zero = All(0.0);
    const FiguresOfFeet found =
        FiguresAt(ex - x, ey - y, -(rx * s), ry * c, half * ex, half * ey, zero, zero);
    if (!is_far) hand = found.hand;
    const Reals nx = hand * found.nx, ny = hand * found.ny;
    return RankedFeet{
        hand * found.r,    zero, zero, AngleOf(c, s), nx * ax - ny * ay, nx * ay + ny * ax,
        hand * found.bend, zero};
  };
  const Turning near = NearSideOf(e);
  doubt = Either(doubt, Without(AllAre(true), HasSettled(near)));
  best = foot_on(near, false);
  Truths is_there = AllAre(false);
  const Turning far = FarSideOf(e, is_there, doubt);
  if (Any(is_there)) next = ChooseFeet(is_there, foot_on(far, true), next);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
