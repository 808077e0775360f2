// Distances to a stroke of varying width, many points at a time: the SIMD twin of
// sdf/shape/curve/tapered_stroke.h. Included once per instruction set. Derivation:
// docs/derivations/tapered_batches.md.
#if defined(MIEN_SDF_BATCH_TAPERED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_TAPERED_INL_H_
#undef MIEN_SDF_BATCH_TAPERED_INL_H_
#else
#define MIEN_SDF_BATCH_TAPERED_INL_H_
#endif

#include "sdf/distance/quad_bezier/quad_bezier-inl.h"
#include "sdf/distance/tapered/tapered_frame.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The largest root of a depressed cubic is good to 1.2e-5 of itself in float. In double it is better, but the
/// guess of the depth that it depends on is not: what is doubt in float lanes is doubt in double ones.
inline constexpr float kRootError = 0x1p-16f;

/// The disc at t: its depth |p − B(t)| − w(t), the smaller the nearer.
template <class W>
struct Disc {
  W t, depth;
};

template <class D, class W>
HWY_INLINE W HalfWidthAt(D d, const TaperedFrame<hn::TFromD<D>>& f, W t) {
  return MulAdd(t, MulAdd(t, SetPack(d, f.wb), SetPack(d, f.wa2)), SetPack(d, f.w0));
}

template <class D, class W>
HWY_INLINE Disc<W> DiscAt(D d, const TaperedFrame<hn::TFromD<D>>& f, Offset<W> o, W t) {
  return {t, Sub(Sqrt(SquareAt(d, f.spine, o, t)), HalfWidthAt(d, f, t))};
}

template <class W>
HWY_INLINE Disc<W> Deeper(Disc<W> a, Disc<W> b) {
  return {IfThenElse(Lt(b.depth, a.depth), b.t, a.t), Min(a.depth, b.depth)};
}

/// Near the spine |q| has a kink and no root tells where the minimum is. For a straight spine and rate
/// w' it is off the foot by w' |q| / (|B'| √(B'² − w'²)).
template <class D, class W>
HWY_INLINE Disc<W> KinkAt(D d, const TaperedFrame<hn::TFromD<D>>& f, Offset<W> o, Disc<W> foot) {
  const auto& c = f.spine;
  const W gx = MulAdd(foot.t, SetPack(d, c.bx2), SetPack(d, c.ax2));
  const W gy = MulAdd(foot.t, SetPack(d, c.by2), SetPack(d, c.ay2));
  const W rate = MulAdd(foot.t, SetPack(d, f.wb2), SetPack(d, f.wa2));
  const W speed2 = MulAdd(gx, gx, Mul(gy, gy)), tiny = SetPack(d, hn::TFromD<D>(1e-12f));
  const W steep = Sqrt(Max(Mul(speed2, NegMulAdd(rate, rate, speed2)), tiny));
  const W length = Add(foot.depth, HalfWidthAt(d, f, foot.t));
  return DiscAt(d, f, o, ClampToUnit(d, MulAdd(rate, Div(length, steep), foot.t)));
}

/// The deepest disc, the two minima that were evaluated, and the least value of the second one's lead times |q| at
/// which the roots' error does not matter.
template <class W>
struct Improvement {
  Disc<W> best, one, two;
  W least_lead;
};

/// For a guess L of the least depth: the two minima of |q|² − (w + L)², one of which is below 0 if any
/// disc is deeper; the deepest of them and of the guess.
template <class D, class V>
HWY_INLINE Improvement<Pack<V>> Improved(D d, const TaperedFrame<hn::TFromD<D>>& f,
                                         Offset<Pack<V>> o, Disc<Pack<V>> best) {
  using W = Pack<V>;
  using T = hn::TFromD<D>;
  const W level = best.depth, vertex = SetPack(d, f.vertex), zero = SetPack(d, 0);
  const auto affine = [&](T x, T y, T l, T one) MIEN_LANES {
    const W rest = MulAdd(level, SetPack(d, l), SetPack(d, one));
    return MulAdd(o.x, SetPack(d, x), MulAdd(o.y, SetPack(d, y), rest));
  };
  const W p = affine(f.px, f.py, f.pw, f.p1), s = affine(f.sx, f.sy, f.sw, f.s1);
  const W x = LargestRoot(d, p, Abs(s)), x2 = Mul(x, x);
  const W apart = MulAdd(x2, SetPack(d, hn::TFromD<D>(-0.75f)), Mul(p, SetPack(d, -3)));
  const W other =
      MulAdd(x, SetPack(d, hn::TFromD<D>(0.5f)), Sqrt(Max(apart, zero)));  // −x/2 if it is not real
  const W t = ClampToUnit(d, Sub(CopySign(x, s), vertex));
  const W t3 = ClampToUnit(d, Sub(CopySign(other, Neg(s)), vertex));
  const auto one = DiscAt(d, f, o, t), two = DiscAt(d, f, o, t3);
  const W blur = Mul(x2, SetPack(d, T(kRootError)));
  const W least = Div(Mul(Mul(blur, blur), SetPack(d, f.steep2)), Max(apart, blur));
  const auto real = Gt(apart, Mul(blur, SetPack(d, -4)));
  return {Deeper(best, Deeper(one, two)), one, two,
          IfThenElse(real, least, SetPack(d, hn::TFromD<D>(-1e30f)))};
}

/// A disc after a Newton step on q·B' − w' |q| = 0. `step` is how far it wanted to go, taken or not;
/// `missing` above 0 if that was too far for the kink of |q| near the spine (see kMostMissing).
template <class W>
struct PolishedDisc {
  Disc<W> disc;
  W step, missing;
};

/// What is left of the depth after a step s is below |q| ρ⁴, ρ = s |B'| / |q|.
template <class T>
inline constexpr T kMostMissing = T(sizeof(T) == 4 ? 0x1p-25 : 0x1p-54);

template <class D, class W>
HWY_INLINE PolishedDisc<W> Polish(D d, const TaperedFrame<hn::TFromD<D>>& f, Offset<W> o,
                                  Disc<W> best) {
  using T = hn::TFromD<D>;
  constexpr bool kFloat = sizeof(T) == 4;
  const auto& c = f.spine;
  const W t = best.t, bx2 = SetPack(d, c.bx2), by2 = SetPack(d, c.by2), wb2 = SetPack(d, f.wb2);
  const W vx = MulAdd(t, SetPack(d, c.bx), SetPack(d, c.ax2));
  const W vy = MulAdd(t, SetPack(d, c.by), SetPack(d, c.ay2));
  const W qx = MulAdd(t, vx, o.x), qy = MulAdd(t, vy, o.y);
  const W gx = MulAdd(t, SetPack(d, c.bx), vx), gy = MulAdd(t, SetPack(d, c.by), vy);
  const W rate = MulAdd(t, wb2, SetPack(d, f.wa2));
  const W square = MulAdd(qx, qx, Mul(qy, qy)), speed2 = MulAdd(gx, gx, Mul(gy, gy));
  const W length = Max(Sqrt(square), SetPack(d, hn::TFromD<D>(1e-18f)));
  const W along = MulAdd(qx, gx, Mul(qy, gy)), slope = NegMulAdd(rate, length, along);
  const W turn = MulAdd(qx, bx2, MulAdd(qy, by2, speed2));
  const W rise = Sub(NegMulAdd(wb2, length, turn), Mul(rate, Div(along, length)));
  const W next = ClampToUnit(d, Sub(t, Div(slope, Max(rise, SetPack(d, hn::TFromD<D>(1e-30f))))));
  // s⁴ |B'|⁴ − kMostMissing |q|³, both kept among the normal numbers.
  const W step = Abs(Sub(next, t));
  const W moved2 = Max(Mul(Mul(step, step), speed2), SetPack(d, T(kFloat ? 0x1p-50 : 0x1p-110)));
  const W cube = Mul(Max(square, SetPack(d, T(kFloat ? 0x1p-56 : 0x1p-140))),
                     Max(length, SetPack(d, T(kFloat ? 0x1p-28 : 0x1p-70))));
  const W missing = NegMulAdd(cube, SetPack(d, kMostMissing<T>), Mul(moved2, moved2));
  return {Deeper(best, DiscAt(d, f, o, next)), step, missing};
}

/// What was found, and reasons to doubt it (docs/derivations/tapered_batches.md): how much the last improvement
/// gained; how far the last Newton step wanted to go, by itself and relative to |q|; and by how much the least lead
/// over another minimum exceeds what it must be.
template <class W>
struct DeepestDisc {
  Disc<W> disc;
  W gain, step, missing, lead;
  W one, two;  ///< the other places that were looked at last
};

/// Minima nearer to each other than this are equally deep: their depths differ by its fourth power.
template <class T>
inline constexpr T kSameDisc = T(sizeof(T) == 4 ? 0x1p-9 : 0x1p-14);

/// The lead over a minimum, times its |q|, less what it must be at least.
template <class D, class W>
HWY_INLINE W LeadOver(D d, const TaperedFrame<hn::TFromD<D>>& f, Disc<W> minimum, Disc<W> best,
                      W least) {
  const W length =
      Max(Add(minimum.depth, HalfWidthAt(d, f, minimum.t)), SetPack(d, hn::TFromD<D>(0x1p-12f)));
  const W lead = MulSub(Sub(minimum.depth, best.depth), length, least);
  const auto same = Lt(Abs(Sub(minimum.t, best.t)), SetPack(d, kSameDisc<hn::TFromD<D>>));
  return IfThenElse(same, SetPack(d, hn::TFromD<D>(1e30f)), lead);
}

template <class D, class W>
HWY_INLINE DeepestDisc<W> DeepestOf(D d, const TaperedFrame<hn::TFromD<D>>& f, Offset<W> o) {
  const auto foot = DiscAt(d, f, o, NearestOnCurved(d, f.spine, o).t);
  const auto ends = Deeper(DiscAt(d, f, o, SetPack(d, 0)), DiscAt(d, f, o, SetPack(d, 1)));
  const auto begin = Deeper(Deeper(foot, KinkAt(d, f, o, foot)), ends);
  auto first = Improved(d, f, o, begin).best;
  if constexpr (sizeof(hn::TFromD<D>) == 8) first = Improved(d, f, o, first).best;
  const auto second = Improved(d, f, o, first);
  auto near = Polish(d, f, o, second.best).disc;
  if constexpr (sizeof(hn::TFromD<D>) == 8) near = Polish(d, f, o, near).disc;
  const auto last = Polish(d, f, o, near);
  const W one = LeadOver(d, f, second.one, last.disc, SetPack(d, f.least_lead));
  const W two = LeadOver(d, f, second.two, last.disc, second.least_lead);
  return {last.disc,     Sub(first.depth, last.disc.depth),
          last.step,     last.missing,
          Min(one, two), second.one.t,
          second.two.t};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
