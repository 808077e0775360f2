// Distance to a quadratic Bézier, many points at a time: the SIMD twin of sdf/shape/curve/quad_bezier.h.
// Included once per instruction set. The formulas and why they hold:
// docs/derivations/quad_bezier.md.
#if defined(MIEN_SDF_BATCH_QUAD_BEZIER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_QUAD_BEZIER_INL_H_
#undef MIEN_SDF_BATCH_QUAD_BEZIER_INL_H_
#else
#define MIEN_SDF_BATCH_QUAD_BEZIER_INL_H_
#endif

#include "sdf/distance/lanes/depressed_cubic-inl.h"
#include "sdf/distance/lanes/pack-inl.h"
#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Points relative to the curve's first control point, scaled: d = p0 − p.
template <class W>
struct Offset {
  W x, y;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Offset<Pack<V>> OffsetTo(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Pack<V> x,
                                    Pack<V> y) {
  const auto scale = SetPack(d, f.scale);
  Offset<Pack<V>> o{NegMulAdd(x, scale, SetPack(d, f.x0)), NegMulAdd(y, scale, SetPack(d, f.y0))};
  if (HWY_UNLIKELY(f.has_low)) {
    o.x = Add(o.x, SetPack(d, f.x0_low));
    o.y = Add(o.y, SetPack(d, f.y0_low));
  }
  return o;
}

template <class D, class W>
HWY_INLINE W ClampToUnit(D d, W t) {
  return Min(Max(t, SetPack(d, 0)), SetPack(d, 1));
}

/// |B(t) − p|².
template <class D, class W>
HWY_INLINE W SquareAt(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o, W t) {
  const W qx = MulAdd(t, MulAdd(t, SetPack(d, f.bx), SetPack(d, f.ax2)), o.x);
  const W qy = MulAdd(t, MulAdd(t, SetPack(d, f.by), SetPack(d, f.ay2)), o.y);
  return MulAdd(qx, qx, Mul(qy, qy));
}

/// One Newton step, clamped to [0, 1], for q·g = 0 with q = B(t) − p and g = B'(t): on the curve
/// itself, whose residual q keeps the digits that the cubic's coefficients lose. `square` gets |q|²
/// before the step.
template <class D, class W>
HWY_INLINE W Polished(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o, W t, W& square) {
  using T = hn::TFromD<D>;
  const W ax2 = SetPack(d, f.ax2), ay2 = SetPack(d, f.ay2);
  const W bx2 = SetPack(d, f.bx2), by2 = SetPack(d, f.by2);
  const W qx = MulAdd(t, MulAdd(t, SetPack(d, f.bx), ax2), o.x);
  const W qy = MulAdd(t, MulAdd(t, SetPack(d, f.by), ay2), o.y);
  const W gx = MulAdd(t, bx2, ax2), gy = MulAdd(t, by2, ay2);
  square = MulAdd(qx, qx, Mul(qy, qy));
  const W slope = MulAdd(qx, gx, Mul(qy, gy));
  const W rise = MulAdd(qx, bx2, MulAdd(qy, by2, MulAdd(gx, gx, Mul(gy, gy))));
  return ClampToUnit(d, Sub(t, Div(slope, Max(rise, SetPack(d, T(1e-30f))))));
}

/// A parameter and |B(t) − p|² there.
template <class W>
struct Candidate {
  W t, square;
};

/// The nearest candidate. `rival` is the square of the nearest one that was passed over, and says whether these
/// lanes can tell the two apart. Callers that do not read t or rival do not pay for them.
template <class W>
struct Nearest {
  W t, square, rival;
};

template <class W>
HWY_INLINE Candidate<W> Nearer(Candidate<W> a, Candidate<W> b) {
  return {IfThenElse(Lt(b.square, a.square), b.t, a.t), Min(a.square, b.square)};
}
template <class M, class W>
HWY_INLINE Candidate<W> Choose(PackMask<M> m, Candidate<W> yes, Candidate<W> no) {
  return {IfThenElse(m, yes.t, no.t), IfThenElse(m, yes.square, no.square)};
}

template <class D, class W>
HWY_INLINE Candidate<W> At(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o, W t) {
  return {t, SquareAt(d, f, o, t)};
}

/// After one step on the curve from t, or before it where that was nearer: Newton's method may diverge where three
/// critical points meet.
template <class D, class W>
HWY_INLINE Candidate<W> Settled(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o, W t) {
  Candidate<W> before{t, t};
  const W after = Polished(d, f, o, t, before.square);
  return Nearer(At(d, f, o, after), before);
}

/// The nearest point of a curve that is nearly straight: from the chord by Newton, and the ends.
template <class D, class W>
HWY_INLINE Nearest<W> NearestOnStraight(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o) {
  constexpr int kSteps = sizeof(hn::TFromD<D>) == 4 ? 1 : 2;
  const W chord = MulAdd(o.x, SetPack(d, f.chord_x), Mul(o.y, SetPack(d, f.chord_y)));
  W t = ClampToUnit(d, Neg(chord)), unused;
  for (int i = 0; i < kSteps; ++i) t = Polished(d, f, o, t, unused);
  const auto begin = At(d, f, o, SetPack(d, 0)), end = At(d, f, o, SetPack(d, 1));
  const auto between = Settled(d, f, o, t), ends = Nearer(begin, end), best = Nearer(between, ends);
  const W other_end = Max(begin.square, end.square);
  const W other = IfThenElse(Ne(between.t, ends.t), Max(between.square, ends.square), other_end);
  return {best.t, best.square, other};
}

/// Whether the sign of s is in doubt: below eight roundings of its terms.
template <class D, class W>
HWY_INLINE auto InDoubt(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o, W s) {
  using T = hn::TFromD<D>;
  constexpr T kRoundings = sizeof(T) == 4 ? T(0x1p-21) : T(0x1p-50);
  const W terms = Add(Abs(Mul(o.x, SetPack(d, f.sx))),
                      Add(Abs(Mul(o.y, SetPack(d, f.sy))), Abs(SetPack(d, f.s1))));
  return Lt(Abs(s), Mul(terms, SetPack(d, kRoundings)));
}

/// The nearest point of a curved one. The whole parabola's is at the largest root; only where that
/// lies beyond an end may the opposite outer root be nearer than the end.
template <class D, class V>
HWY_INLINE Nearest<Pack<V>> NearestOnCurved(D d, const QuadBezierFrame<hn::TFromD<D>>& f,
                                            Offset<Pack<V>> o) {
  using W = Pack<V>;
  const W vertex = SetPack(d, f.vertex), zero = SetPack(d, 0);
  const W p = MulAdd(o.x, SetPack(d, f.px), MulAdd(o.y, SetPack(d, f.py), SetPack(d, f.p1)));
  const W s = MulAdd(o.x, SetPack(d, f.sx), MulAdd(o.y, SetPack(d, f.sy), SetPack(d, f.s1)));
  const W x = LargestRoot(d, p, Abs(s));
  const W free_t = Sub(CopySign(x, s), vertex), t = ClampToUnit(d, free_t);
  const W apart =
      MulAdd(Mul(x, x), SetPack(d, -0.75f), Mul(p, SetPack(d, -3)));  // of the other roots
  const auto three = Gt(apart, zero), two = And(Ne(free_t, t), three);
  // Equally large roots of either sign: which one is nearer cannot be decided here.
  const W equal = IfThenElse(And(three, InDoubt(d, f, o, s)), zero, SetPack(d, 1e30f));
  if (!AnyTrue(d, two)) {
    const auto settled = Settled(d, f, o, t);
    return {settled.t, settled.square, equal};
  }
  const W x3 = MulAdd(x, SetPack(d, 0.5f), Sqrt(Max(apart, zero)));
  const W t3 = ClampToUnit(d, Sub(CopySign(x3, Neg(s)), vertex));
  auto end = At(d, f, o, t);
  // A root so close to the end that rounding may have put it beyond is settled like any other.
  const auto close = And(two, Lt(Abs(Sub(free_t, t)), SetPack(d, 0x1p-9f)));
  if (HWY_UNLIKELY(AnyTrue(d, close))) end = Choose(close, Settled(d, f, o, t), end);
  const auto settled = Settled(d, f, o, IfThenElse(two, t3, t));
  const auto best = Choose(two, Nearer(settled, end), settled);
  // Both roots beyond the same end are one candidate, and no rivals.
  const auto rivals = And(two, Ne(settled.t, end.t));
  return {best.t, best.square,
          IfThenElse(rivals, Min(equal, Max(settled.square, end.square)), equal)};
}

template <class D, class W>
HWY_INLINE Nearest<W> NearestOn(D d, const QuadBezierFrame<hn::TFromD<D>>& f, Offset<W> o) {
  if (HWY_UNLIKELY(f.straight)) return NearestOnStraight(d, f, o);
  return NearestOnCurved(d, f, o);
}

/// |B(t) − p|² for points far away: what the rounding of the point's place and of the sum left over is
/// carried along, so that 1.5 ulps of the distance remain.
template <class D, class W>
HWY_INLINE W CarefulSquareAt(D d, const QuadBezierFrame<float>& f, W x, W y, W t) {
  const W scale = SetPack(d, f.scale);
  const auto axis = [&](W p, float p0, float low, float a2, float b, W& q, W& e) MIEN_LANES {
    const auto from = ExactDifference(SetPack(d, p0), Mul(p, scale));
    const W along = Mul(t, MulAdd(t, SetPack(d, b), SetPack(d, a2)));
    q = Add(from.high, along);
    e = Add(Sub(along, Sub(q, from.high)), Add(from.low, SetPack(d, low)));
  };
  W qx, ex, qy, ey;
  axis(x, f.x0, f.x0_low, f.ax2, f.bx, qx, ex);
  axis(y, f.y0, f.y0_low, f.ay2, f.by, qy, ey);
  return CarefulSquare(qx, ex, qy, ey);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
