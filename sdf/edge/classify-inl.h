// Squares against shapes, a vector of squares at a time. Included once per instruction set. Each
// function gives two numbers per square: it lies outside if `out` > 0, inside if `in` > 0, both
// certain; derivations and error bounds: docs/derivations/classify.md.
#if defined(MIEN_SDF_EDGE_CLASSIFY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_EDGE_CLASSIFY_INL_H_
#undef MIEN_SDF_EDGE_CLASSIFY_INL_H_
#else
#define MIEN_SDF_EDGE_CLASSIFY_INL_H_
#endif

#include <mien/sdf/batch/quad_bezier-inl.h>
#include <mien/sdf/edge/classify_frame.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Verdict {
  V out, in;
};

/// half_diagonal, with all that rounding can do to a square's place added.
template <class D, class V>
HWY_INLINE V Reach(D d, V x, V y, float half_diagonal, float size) {
  const V rounding = hn::Set(d, kClassifyRounding);
  return Fused(hn::Add(hn::Abs(x), hn::Abs(y)), rounding,
               hn::Set(d, half_diagonal + (half_diagonal + size) * kClassifyRounding));
}

/// By a distance s, whose rounding is in `reach`.
template <class V>
HWY_INLINE Verdict<V> ByDistance(V s, V reach) {
  return {hn::Sub(s, reach), hn::Sub(hn::Neg(s), reach)};
}

template <class D, class V>
HWY_INLINE Verdict<V> Against(D d, const HalfPlaneSquares& f, V x, V y, float half_diagonal) {
  const V s = Fused(x, hn::Set(d, f.nx), FusedLess(y, hn::Set(d, f.ny), hn::Set(d, f.offset)));
  return ByDistance(s, Reach(d, x, y, half_diagonal, f.size));
}

template <class D, class V>
HWY_INLINE Verdict<V> Against(D d, const SegmentSquares& f, V x, V y, float half_diagonal) {
  const V tx = hn::Set(d, f.tx), ty = hn::Set(d, f.ty);
  const V qx = hn::Sub(x, hn::Set(d, f.x0)), qy = hn::Sub(y, hn::Set(d, f.y0));
  const V free = Fused(qx, tx, hn::Mul(qy, ty));
  const V along = hn::Min(hn::Max(free, hn::Zero(d)), hn::Set(d, f.length));
  const V rx = FusedFrom(along, tx, qx), ry = FusedFrom(along, ty, qy);
  const V s = hn::Sub(hn::Sqrt(Fused(rx, rx, hn::Mul(ry, ry))), hn::Set(d, f.half_width));
  return ByDistance(s, Reach(d, x, y, half_diagonal, f.size));
}

/// With F > 0 inside, F(c + u) = F(c) + u·∇F − Q(u), 0 <= Q(u) <= bend |u|²; and `rounding` of F's
/// terms. A negative bend turns both around.
template <class D, class V>
HWY_INLINE Verdict<V> ByForm(D d, V form, V slope, V reach, float bend, V terms) {
  const V rounding = hn::Mul(terms, hn::Set(d, kClassifyRounding));
  const V away = Fused(hn::Mul(slope, reach), hn::Set(d, 1 + 0x1p-20f), rounding);
  const V more = hn::Mul(hn::Mul(reach, reach), hn::Set(d, bend * (1 + 0x1p-20f)));
  const V to_in = hn::Add(away, hn::Max(more, hn::Zero(d)));
  const V to_out = hn::Sub(away, hn::Min(more, hn::Zero(d)));
  return {hn::Sub(hn::Neg(form), to_out), hn::Sub(form, to_in)};
}

template <class D, class V>
HWY_INLINE Verdict<V> Against(D d, const ParabolaSquares& f, V x, V y, float half_diagonal) {
  const V ax = hn::Set(d, f.ax), ay = hn::Set(d, f.ay), one = hn::Set(d, 1);
  const V qx = hn::Sub(x, hn::Set(d, f.x0)), qy = hn::Sub(y, hn::Set(d, f.y0));
  const V along = Fused(qx, ax, hn::Mul(qy, ay)), across = FusedLess(qy, ax, hn::Mul(qx, ay));
  const V bent = hn::Mul(across, hn::Set(d, f.bend)), rise = hn::Mul(bent, across);
  const V tilt = hn::Add(bent, bent), slope = hn::Sqrt(Fused(tilt, tilt, one));
  const V terms = hn::Add(hn::Abs(along), hn::Abs(rise));
  return ByForm(d, hn::Sub(along, rise), slope, Reach(d, x, y, half_diagonal, f.size), f.bend,
                terms);
}

template <class D, class V>
HWY_INLINE Verdict<V> Against(D d, const EllipseSquares& f, V x, V y, float half_diagonal) {
  const V qx = hn::Sub(x, hn::Set(d, f.x0)), qy = hn::Sub(y, hn::Set(d, f.y0));
  const V u = Fused(qx, hn::Set(d, f.ux), hn::Mul(qy, hn::Set(d, f.uy)));
  const V v = Fused(qx, hn::Set(d, f.vx), hn::Mul(qy, hn::Set(d, f.vy)));
  const V square = Fused(u, u, hn::Mul(v, v)), one = hn::Set(d, 1);
  const V gx = hn::Mul(u, hn::Set(d, f.u_slope)), gy = hn::Mul(v, hn::Set(d, f.v_slope));
  const V half_slope = hn::Sqrt(Fused(gx, gx, hn::Mul(gy, gy)));
  return ByForm(d, hn::Sub(one, square), hn::Add(half_slope, half_slope),
                Reach(d, x, y, half_diagonal, f.size), f.bend, hn::Add(one, square));
}

/// Four vectors of squares at once, as the curve's kernel has them.
template <class D, class V>
HWY_INLINE Verdict<Pack<V>> AgainstStroke(D d, const StrokeSquares& f, Pack<V> x, Pack<V> y,
                                          float half_diagonal) {
  using W = Pack<V>;
  const auto near = NearestOn(d, f.curve, OffsetTo(d, f.curve, x, y));
  const W distance = Mul(Sqrt(near.square), SetPack(d, f.curve.unscale)), t = near.t;
  const W width = MulAdd(t, MulAdd(t, SetPack(d, f.wb), SetPack(d, f.wa2)), SetPack(d, f.w0));
  // The kernel's own rounding is 2⁻²¹ of the larger of distance and size at most.
  const auto reach_of = [&](V vx, V vy)
                            MIEN_LANES { return Reach(d, vx, vy, half_diagonal, 2 * f.size); };
  const W reach = MulAdd(distance, SetPack(d, kClassifyRounding), Each(reach_of, x, y));
  const W by_widest = Sub(distance, SetPack(d, f.widest));
  const W inside = Sub(Sub(width, distance), reach);
  if (!(f.keep > 0)) return {Sub(by_widest, reach), inside};  // and widths may be negative
  const W by_rate = MulSub(distance, SetPack(d, f.keep), width);
  return {Sub(Max(by_rate, by_widest), reach), inside};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
