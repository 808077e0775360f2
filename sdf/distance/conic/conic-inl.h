// Signed distances to ellipses and parabola sides, many points at a time: the SIMD twins of
// sdf/shape/round/ellipse.h and sdf/shape/curve/parabola_side.h. Included once per instruction set.
// Derivations: docs/derivations/conic_batches.md.
#if defined(MIEN_SDF_BATCH_CONIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_CONIC_INL_H_
#undef MIEN_SDF_BATCH_CONIC_INL_H_
#else
#define MIEN_SDF_BATCH_CONIC_INL_H_
#endif

#include "sdf/distance/conic/conic_frame.h"
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/depressed_cubic-inl.h"
#include "sdf/distance/lanes/pack-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Coordinates along and across the frame's axis.
template <class W>
struct Placed {
  W along, across;
};

/// The same and, before turning, x and y relative to the centre.
template <class W>
struct PlacedPoint {
  W along, across, x, y;
};

/// The point relative to the frame's centre, before scaling for a parabola, after it for an
/// ellipse.
template <class D, class Frame, class W>
HWY_INLINE PlacedPoint<W> PlacedIn(D d, const Frame& f, W x, W y, hn::TFromD<D> scale) {
  const W s = SetPack(d, scale), ax = SetPack(d, f.axis_x), ay = SetPack(d, f.axis_y);
  const W qx = Sub(MulSub(x, s, SetPack(d, f.x0)), SetPack(d, f.low_x));
  const W qy = Sub(MulSub(y, s, SetPack(d, f.y0)), SetPack(d, f.low_y));
  return {MulAdd(qx, ax, Mul(qy, ay)), MulSub(qy, ax, Mul(qx, ay)), qx, qy};
}

/// A signed distance [scaled], and a square that gives away lanes that are far or not numbers.
template <class W>
struct SignedDistance {
  W distance, reach2;
};

/// NaN where a lane's last step was so long that its square could still count, else `reach2`.
template <class D, class W>
HWY_INLINE W IfSettled(D d, W left, W allowed, W reach2) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) return reach2;
  const W nan = SetPack(d, std::numeric_limits<hn::TFromD<D>>::quiet_NaN());
  return IfThenElse(Lt(left, allowed), reach2, nan);
}

/// From y = x², with y along the axis. The foot s > 0 of (u, v), u >= 0, solves s³ + 3 P s = S2
/// with P = (1 − 2v)/6 and S2 = u/2; then two Newton steps on the residual. The distance is the
/// residual across the tangent: an error of s enters at second order, on the outline too.
template <class D, class V, class T = hn::TFromD<D>>
HWY_INLINE SignedDistance<Pack<V>> FromParabola(D d, const ParabolaFrame<T>& f, Pack<V> x,
                                                Pack<V> y) {
  using W = Pack<V>;
  const auto at = PlacedIn(d, f, x, y, T(1));
  const W scale = SetPack(d, f.scale), two = SetPack(d, 2), one = SetPack(d, 1);
  const W v = Mul(at.along, scale), u = Abs(Mul(at.across, scale));
  const W p = MulAdd(v, SetPack(d, T(-1) / 3), SetPack(d, T(1) / 6));
  W s = LargestRoot(d, p, Mul(u, SetPack(d, T(0.5)))), step = u, rise = u;
  const auto square_at = [&](W at_s) MIEN_LANES {
    const W du = Sub(u, at_s), dv = NegMulAdd(at_s, at_s, v);
    return MulAdd(du, du, Mul(dv, dv));
  };
  for (int i = 0; i < 2; ++i) {  // each only if it comes nearer: at the evolute the rise vanishes
    const W off = MulSub(s, s, v), slope = MulAdd(Mul(two, s), off, Sub(s, u));
    rise = MulAdd(two, MulAdd(Mul(two, s), s, off), one);
    step = Div(slope, Max(rise, SetPack(d, T(1e-30f))));
    const W next = Sub(s, step);
    s = IfThenElse(Lt(square_at(next), square_at(s)), next, s);
  }
  const W tilt = Mul(two, s), off = NegMulAdd(s, s, v);
  const W across = MulSub(tilt, Sub(u, s), off), reach2 = MulAdd(u, u, Mul(v, v));
  const W distance = Div(across, Sqrt(MulAdd(tilt, tilt, one)));
  // The next step would be 6 s step² / rise; it would change the distance by its square times rise / 2d.
  const W step2 = Mul(step, step), left = Mul(Mul(step2, step2), Mul(Mul(s, s), SetPack(d, 32)));
  const W size2 = Max(Mul(distance, distance), Mul(reach2, SetPack(d, T(0x1p-100))));
  const W allowed = Mul(Mul(rise, SetPack(d, T(0x1p-54))), Max(size2, SetPack(d, T(1e-36f))));
  return {f.mirrored ? Neg(distance) : distance, IfSettled(d, left, allowed, reach2)};
}

/// The foot (a cos, b sin) of a point in the first quadrant.
template <class W>
struct Angle {
  W cos, sin;
};

/// The vector from the foot to the point.
template <class D, class W>
HWY_INLINE Placed<W> FromFoot(D d, const EllipseFrame<hn::TFromD<D>>& f, W x, W y, Angle<W> foot) {
  return {NegMulAdd(SetPack(d, f.a), foot.cos, x), NegMulAdd(SetPack(d, f.b), foot.sin, y)};
}

/// 1/(v + focal) and 1/v, by one division.
template <class D, class W>
HWY_INLINE Angle<W> Inverses(D d, W v, W focal) {
  const W sum = Add(v, focal), inverse = Div(SetPack(d, 1), Mul(v, sum));
  return {Mul(v, inverse), Mul(sum, inverse)};
}

/// A first guess at the foot, from both ends of the secular equation
///     (a x / (v + a² − b²))² + (b y / v)² = 1,   cos = a x / (v + a² − b²),  sin = b y / v:
/// v is at least b y, at least a x − (a² − b²), and, where the first term is nearly 1, the inverse
/// of a depressed cubic's root. Then two Newton steps on 1/|(cos, sin)| = 1, which is concave and
/// nearly straight.
template <class D, class V>
HWY_INLINE Angle<Pack<V>> EllipseGuess(D d, const EllipseFrame<hn::TFromD<D>>& f, Pack<V> x,
                                       Pack<V> y) {
  using W = Pack<V>;
  using T = hn::TFromD<D>;
  const W one = SetPack(d, 1), focal = SetPack(d, f.focal);
  const W ax = Mul(x, SetPack(d, f.a)),
          by = Max(Mul(y, SetPack(d, f.b)), SetPack(d, T(sizeof(T) == 4 ? 1e-12 : 1e-30)));
  // sin³ + 3 P sin = S2 with P = −(2/3)(1 − a x / focal), S2 = 2 b y / focal.
  const W inverse = SetPack(d, 1 / f.guess_focal);
  const W p = Mul(SetPack(d, T(-2) / 3), NegMulAdd(ax, inverse, one));
  const W s2 = Mul(SetPack(d, 2), Mul(by, inverse));
  const auto guess = [&](V vp, V vs) MIEN_LANES { return RootGuessOf(d, vp, vs); };
  const W sin = Mul(Each(guess, p, s2), SetPack(d, T(1.13)));
  const W least = Max(Div(by, Min(sin, one)), Sub(ax, focal));
  W v = least;
  for (int i = 0; i < 2; ++i) {
    const auto w = Inverses(d, v, focal);
    const W c = Mul(ax, w.cos), s = Mul(by, w.sin), n2 = MulAdd(c, c, Mul(s, s));
    const W fall = MulAdd(Mul(c, c), w.cos, Mul(Mul(s, s), w.sin));
    v = Max(MulAdd(Sub(Sqrt(n2), one), Div(n2, fall), v), least);  // rounding may take it below
  }
  const auto w = Inverses(d, v, focal);
  const W c = Mul(ax, w.cos), s = Mul(by, w.sin);
  const W shrink = Div(one, Sqrt(MulAdd(c, c, Mul(s, s))));
  return {Mul(c, shrink), Mul(s, shrink)};
}

/// The foot after a step on the outline; how far that step wanted to turn, taken or not; and the second derivative
/// before it.
template <class W>
struct TurnedFoot {
  Angle<W> foot;
  W turn, rise;
};

/// One Newton step of the foot on the outline itself, at most a quarter radian, taken only if it brings the foot
/// nearer: where three feet meet it may diverge.
template <class D, class W>
HWY_INLINE TurnedFoot<W> Turned(D d, const EllipseFrame<hn::TFromD<D>>& f, W x, W y,
                                Angle<W> foot) {
  using T = hn::TFromD<D>;
  const W a = SetPack(d, f.a), b = SetPack(d, f.b), one = SetPack(d, 1);
  const auto r = FromFoot(d, f, x, y, foot);
  const W tx = Mul(a, foot.sin), ty = Mul(b, foot.cos);  // the tangent is (−tx, ty)
  const W slope = MulSub(r.across, ty, Mul(r.along, tx));
  const W bent = MulAdd(r.along, Mul(a, foot.cos), Mul(r.across, Mul(b, foot.sin)));
  const W rise = MulAdd(tx, tx, MulAdd(ty, ty, bent)), most = SetPack(d, T(0.25));
  const W free_turn = Div(slope, Max(rise, SetPack(d, T(1e-30f))));
  const W turn = Max(Min(free_turn, most), Neg(most));
  // The rotation by 2 atan(turn/2): rational, and of length 1 to rounding.
  const W half = Mul(turn, SetPack(d, T(0.5))), inverse = Div(one, MulAdd(half, half, one));
  const W cos = Mul(NegMulAdd(half, half, one), inverse), sin = Mul(turn, inverse);
  const Angle<W> next{MulSub(foot.cos, cos, Mul(foot.sin, sin)),
                      MulAdd(foot.sin, cos, Mul(foot.cos, sin))};
  const auto s = FromFoot(d, f, x, y, next);
  const auto nearer = Lt(MulAdd(s.along, s.along, Mul(s.across, s.across)),
                         MulAdd(r.along, r.along, Mul(r.across, r.across)));
  const Angle<W> best{IfThenElse(nearer, next.cos, foot.cos),
                      IfThenElse(nearer, next.sin, foot.sin)};
  return {best, turn, rise};
}

/// The foot in the first quadrant, after two turns on the outline, or three in double lanes.
template <class D, class W>
HWY_INLINE TurnedFoot<W> FootOnEllipse(D d, const EllipseFrame<hn::TFromD<D>>& f, W x, W y) {
  auto at = Turned(d, f, x, y, EllipseGuess(d, f, x, y));
  if constexpr (sizeof(hn::TFromD<D>) == 4) return Turned(d, f, x, y, at.foot);
  at = Turned(d, f, x, y, Turned(d, f, x, y, at.foot).foot);
  // Every turn leaves its rounding in the length, which is brought back to 1 here, to first order.
  const W cos = at.foot.cos, sin = at.foot.sin, half = SetPack(d, hn::TFromD<D>(0.5));
  const W grow = Mul(half, NegMulAdd(cos, cos, NegMulAdd(sin, sin, SetPack(d, 1))));
  return {{MulAdd(cos, grow, cos), MulAdd(sin, grow, sin)}, at.turn, at.rise};
}

/// The foot in the caller's own directions, relative to the centre, of a point placed there.
template <class W>
struct FootPoint {
  W x, y;
};
template <class D, class W>
HWY_INLINE FootPoint<W> FootPointOf(D d, const EllipseFrame<hn::TFromD<D>>& f,
                                    const PlacedPoint<W>& at, Angle<W> foot) {
  const W ex = CopySign(Mul(SetPack(d, f.a), foot.cos), at.along);
  const W ey = CopySign(Mul(SetPack(d, f.b), foot.sin), at.across);
  const W ax = SetPack(d, f.axis_x), ay = SetPack(d, f.axis_y);
  return {MulSub(ex, ax, Mul(ey, ay)), MulAdd(ex, ay, Mul(ey, ax))};
}

/// Near the outline the distance is the residual across the tangent: an error of the foot enters at
/// second order. Beyond a quarter radius it is the residual's length, in the caller's own directions, so
/// that the rounding of the axis counts with the ellipse's size and not with the distance.
template <class D, class W>
HWY_INLINE SignedDistance<W> FromEllipse(D d, const EllipseFrame<hn::TFromD<D>>& f, W px, W py) {
  const auto at = PlacedIn(d, f, px, py, f.scale);
  const W x = Abs(at.along), y = Abs(at.across), a = SetPack(d, f.a), b = SetPack(d, f.b);
  const auto found = FootOnEllipse(d, f, x, y);
  const auto foot = found.foot;
  const W nx = Mul(b, foot.cos), ny = Mul(a, foot.sin);  // along the normal
  const auto r = FromFoot(d, f, x, y, foot);
  const W across = Div(MulAdd(r.along, nx, Mul(r.across, ny)), Sqrt(MulAdd(nx, nx, Mul(ny, ny))));
  const W turn2 = Mul(found.turn, found.turn);
  const W allowed = Mul(found.rise, SetPack(d, hn::TFromD<D>(0x1p-60)));
  const W reach2 = IfSettled(d, Mul(turn2, turn2), allowed, MulAdd(x, x, Mul(y, y)));
  const auto outside = Gt(across, Mul(a, SetPack(d, hn::TFromD<D>(0.25))));
  if (!AnyTrue(d, outside)) return {across, reach2};
  const auto on = FootPointOf(d, f, at, foot);
  const W rx = Sub(at.x, on.x), ry = Sub(at.y, on.y);
  const W length = Sqrt(MulAdd(rx, rx, Mul(ry, ry)));
  return {IfThenElse(outside, length, across), reach2};
}

/// Far away: the rounding errors of the point's offset and of the residual are carried along.
template <class D, class W>
HWY_INLINE SignedDistance<W> FromEllipseFar(D d, const EllipseFrame<hn::TFromD<D>>& f, W px, W py) {
  const auto at = PlacedIn(d, f, px, py, f.scale);
  const W x = Abs(at.along), y = Abs(at.across), scale = SetPack(d, f.scale);
  const auto on = FootPointOf(d, f, at, FootOnEllipse(d, f, x, y).foot);
  const auto axis = [&](W p, float x0, float low, W foot, W& r, W& e) MIEN_LANES {
    const auto from = ExactDifference(Mul(p, scale), SetPack(d, x0));
    r = Sub(from.high, foot);
    e = Sub(Sub(Sub(from.high, r), foot), Sub(SetPack(d, low), from.low));
  };
  W rx, ex, ry, ey;
  axis(px, f.x0, f.low_x, on.x, rx, ex);
  axis(py, f.y0, f.low_y, on.y, ry, ey);
  return {Sqrt(CarefulSquare(rx, ex, ry, ey)), MulAdd(x, x, Mul(y, y))};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
