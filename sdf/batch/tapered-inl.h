// Distances to a stroke of varying width, many points at a time: the SIMD twin of
// sdf/shape/tapered_stroke.h. Included once per instruction set. Derivation:
// docs/derivations/tapered_batches.md.
#if defined(MIEN_SDF_BATCH_TAPERED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_TAPERED_INL_H_
#undef MIEN_SDF_BATCH_TAPERED_INL_H_
#else
#define MIEN_SDF_BATCH_TAPERED_INL_H_
#endif

#include <mien/sdf/batch/quad_bezier-inl.h>
#include <mien/sdf/batch/tapered_frame.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The disc at t: its depth |p − B(t)| − w(t), the smaller the nearer.
template <class W>
struct Disc {
  W t, depth;
};

template <class D, class W>
HWY_INLINE W HalfWidthAt(D d, const TaperedFrame& f, W t) {
  return MulAdd(t, MulAdd(t, SetPack(d, f.wb), SetPack(d, f.wa2)), SetPack(d, f.w0));
}

template <class D, class W>
HWY_INLINE Disc<W> DiscAt(D d, const TaperedFrame& f, Offset<W> o, W t) {
  return {t, Sub(Sqrt(SquareAt(d, f.spine, o, t)), HalfWidthAt(d, f, t))};
}

template <class W>
HWY_INLINE Disc<W> Deeper(Disc<W> a, Disc<W> b) {
  return {IfThenElse(Lt(b.depth, a.depth), b.t, a.t), Min(a.depth, b.depth)};
}

/// For a guess L of the least depth: the two minima of |q|² − (w + L)², one of which is below 0 if any
/// disc is deeper; the deepest of them and of the guess.
template <class D, class V>
HWY_INLINE Disc<Pack<V>> Improved(D d, const TaperedFrame& f, Offset<Pack<V>> o,
                                  Disc<Pack<V>> best) {
  using W = Pack<V>;
  const W level = best.depth, vertex = SetPack(d, f.vertex), zero = SetPack(d, 0);
  const auto affine = [&](float x, float y, float l, float one) MIEN_LANES {
    const W rest = MulAdd(level, SetPack(d, l), SetPack(d, one));
    return MulAdd(o.x, SetPack(d, x), MulAdd(o.y, SetPack(d, y), rest));
  };
  const W p = affine(f.px, f.py, f.pw, f.p1), s = affine(f.sx, f.sy, f.sw, f.s1);
  const W x = LargestRoot(d, p, Abs(s));
  const W apart = MulAdd(Mul(x, x), SetPack(d, -0.75f), Mul(p, SetPack(d, -3)));
  const W other = MulAdd(x, SetPack(d, 0.5f), Sqrt(Max(apart, zero)));  // −x/2 if it is not real
  const W t = ClampToUnit(d, Sub(CopySign(x, s), vertex));
  const W t3 = ClampToUnit(d, Sub(CopySign(other, Neg(s)), vertex));
  return Deeper(best, Deeper(DiscAt(d, f, o, t), DiscAt(d, f, o, t3)));
}

/// One Newton step on q·B' − w' |q| = 0, if it goes deeper; `step` gets its size, taken or not.
template <class D, class W>
HWY_INLINE Disc<W> PolishedDisc(D d, const TaperedFrame& f, Offset<W> o, Disc<W> best, W& step) {
  const auto& c = f.spine;
  const W t = best.t, bx2 = SetPack(d, c.bx2), by2 = SetPack(d, c.by2), wb2 = SetPack(d, f.wb2);
  const W vx = MulAdd(t, SetPack(d, c.bx), SetPack(d, c.ax2));
  const W vy = MulAdd(t, SetPack(d, c.by), SetPack(d, c.ay2));
  const W qx = MulAdd(t, vx, o.x), qy = MulAdd(t, vy, o.y);
  const W gx = MulAdd(t, SetPack(d, c.bx), vx), gy = MulAdd(t, SetPack(d, c.by), vy);
  const W rate = MulAdd(t, wb2, SetPack(d, f.wa2));
  const W length = Max(Sqrt(MulAdd(qx, qx, Mul(qy, qy))), SetPack(d, 1e-18f));
  const W along = MulAdd(qx, gx, Mul(qy, gy)), slope = NegMulAdd(rate, length, along);
  const W turn = MulAdd(qx, bx2, MulAdd(qy, by2, MulAdd(gx, gx, Mul(gy, gy))));
  const W rise = Sub(NegMulAdd(wb2, length, turn), Mul(rate, Div(along, length)));
  const W next = ClampToUnit(d, Sub(t, Div(slope, Max(rise, SetPack(d, 1e-30f)))));
  step = Abs(Sub(next, t));
  return Deeper(best, DiscAt(d, f, o, next));
}

/// What was found; what the last improvement gained, and how far the last Newton step wanted to go.
/// Where one of them is large, more were due: the disc is in doubt.
template <class W>
struct DeepestDisc {
  Disc<W> disc;
  W gain, step;
};

template <class D, class W>
HWY_INLINE DeepestDisc<W> DeepestOf(D d, const TaperedFrame& f, Offset<W> o) {
  const auto foot = DiscAt(d, f, o, NearestOnCurved(d, f.spine, o).t);
  const auto ends = Deeper(DiscAt(d, f, o, SetPack(d, 0)), DiscAt(d, f, o, SetPack(d, 1)));
  const auto first = Improved(d, f, o, Deeper(foot, ends));
  const auto second = Improved(d, f, o, first);
  W step;
  const auto polished = PolishedDisc(d, f, o, PolishedDisc(d, f, o, second, step), step);
  return {polished, Sub(first.depth, polished.depth), step};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
