// Real roots of cubics, many cubics at a time: the SIMD twin of lib/math/cubic.h. Included once per
// instruction set. Derivation: docs/derivations/cubic_batches.md.
#if defined(MIEN_SDF_BATCH_CUBICS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_CUBICS_INL_H_
#undef MIEN_SDF_BATCH_CUBICS_INL_H_
#else
#define MIEN_SDF_BATCH_CUBICS_INL_H_
#endif

#include "sdf/distance/lanes/pack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// a x³ + b x² + c x + d, a > 0.
template <class W>
struct CubicPack {
  W a, b, c, d;
};

/// Roots, ascending: `high` alone, or all. `sure` is 1 where they are proven, else 0 or NaN.
template <class W>
struct RootPack {
  W low, middle, high, is_three, sure;
};

template <class W>
HWY_INLINE W CubicAt(const CubicPack<W>& f, W x) {
  return MulAdd(MulAdd(MulAdd(f.a, x, f.b), x, f.c), x, f.d);
}

/// The sum of the terms' absolute values: rounding is measured by it.
template <class W>
HWY_INLINE W TermsAt(const CubicPack<W>& f, W x) {
  const W y = Abs(x);
  return MulAdd(MulAdd(MulAdd(f.a, y, Abs(f.b)), y, Abs(f.c)), y, Abs(f.d));
}

/// x y − p for p = x y rounded: exactly, also where multiply-add is not fused (Veltkamp and Dekker).
template <class D, class W>
HWY_INLINE W ProductRest(D d, W x, W y, W p) {
  if constexpr (kNativeFma || kEmulateFma) {
    return MulSub(x, y, p);
  } else {
    const W half = SetPack(d, 0x1p27 + 1), cx = Mul(half, x), cy = Mul(half, y);
    const W xh = Sub(cx, Sub(cx, x)), yh = Sub(cy, Sub(cy, y)), xl = Sub(x, xh), yl = Sub(y, yh);
    return Add(Mul(xl, yl), Add(Mul(xl, yh), Add(Mul(xh, yl), Sub(Mul(xh, yh), p))));
  }
}

/// A cube root within 5 %, not below it: a third of the number's upper half, which is nearly its
/// logarithm. The upper half travels as a double's lower bits.
template <class D, class V>
HWY_INLINE V CubeRootAbove(D d, V x) {
  const hn::RebindToUnsigned<D> du;
  const auto carrier = hn::Set(d, 0x1p52);
  const auto upper = hn::ShiftRight<32>(hn::BitCast(du, x));
  const V logarithm = hn::Sub(hn::BitCast(d, hn::Or(upper, hn::BitCast(du, carrier))), carrier);
  const V third = hn::Add(hn::Mul(logarithm, hn::Set(d, 1.0 / 3)), hn::Set(d, 715094163.0));
  const auto bits = hn::ShiftLeft<32>(hn::BitCast(du, hn::Add(third, carrier)));
  return hn::Mul(hn::BitCast(d, bits), hn::Set(d, 1.05));
}

/// y − g / g' by Halley's rule, from g, g' and g''/2.
template <class W>
HWY_INLINE W Halley(W y, W g, W g1, W g2_half) {
  return Sub(y, Div(Mul(g, g1), NegMulAdd(g, g2_half, Mul(g1, g1))));
}

/// The root at base ± y, where s y + r y² + alpha y³ = v: two steps in y from a guess that is at most a
/// third off, then one on the cubic itself, whose value keeps the digits that base and v have lost.
template <class D, class W>
HWY_INLINE W RootFrom(D d, const CubicPack<W>& f, W base, W sign, W s, W r, W alpha, W v, W guess) {
  const W three = SetPack(d, 3), alpha3 = Mul(alpha, three);
  W y = guess;
  for (int i = 0; i < 2; ++i) {
    const W g = MulSub(MulAdd(MulAdd(alpha, y, r), y, s), y, v);
    const W g2_half = MulAdd(alpha3, y, r), g1 = MulAdd(Add(g2_half, r), y, s);
    y = Halley(y, g, g1, g2_half);
  }
  const W x = MulAdd(sign, y, base), f2_half = MulAdd(Mul(f.a, three), x, f.b);
  return Halley(x, CubicAt(f, x), MulAdd(Add(f2_half, f.b), x, f.c), f2_half);
}

/// `sure`, or 0 where the cubic's value at x is over 2⁻⁵¹ of its terms, or NaN.
template <class D, class W>
HWY_INLINE W IfRoot(D d, const CubicPack<W>& f, W x, W sure) {
  const W most = Mul(TermsAt(f, x), SetPack(d, 0x1p-51));
  return IfThenElse(Gt(most, Abs(CubicAt(f, x))), sure, SetPack(d, 0));
}

/// `sure`, or 0 where the value is so small that its sign is in doubt: the turn may be a double root.
template <class D, class W>
HWY_INLINE W IfNoRoot(D d, const CubicPack<W>& f, W turn, W value, W sure) {
  const W least = Mul(TermsAt(f, turn), SetPack(d, 4 * 0x1p-51));
  return IfThenElse(Gt(Abs(value), least), sure, SetPack(d, 0));
}

/// The turns and what the cubic is about each: f(m ± y) = f(m) ± slope y + bend y² + a y³.
template <class W>
struct Turns {
  W low, high, slope, bend, are_two, sure;
};

template <class D, class W>
HWY_INLINE Turns<W> TurnsOf(D d, const CubicPack<W>& f) {
  const W zero = SetPack(d, 0), one = SetPack(d, 1), a3 = Mul(f.a, SetPack(d, 3));
  const W ac = Mul(a3, f.c), bb = Mul(f.b, f.b);
  const W rest = Sub(ProductRest(d, f.b, f.b, bb), ProductRest(d, a3, f.c, ac));
  const W discriminant = Add(Sub(bb, ac), rest);
  const auto two = Gt(discriminant, zero);
  const W r = Sqrt(Max(discriminant, zero)), q = Neg(Add(f.b, CopySign(r, f.b)));
  const W inflection = Neg(Div(f.b, a3)), m = Div(q, a3), n = Div(f.c, q);
  const W low = IfThenElse(two, Min(m, n), inflection);
  const W high = IfThenElse(two, Max(m, n), inflection);
  // Two turns that rounding made one are too close to call.
  const W sure = IfThenElse(two, IfThenElse(Lt(low, high), one, zero), one);
  return {
      low, high, IfThenElse(two, zero, Neg(Div(discriminant, a3))), r, IfThenElse(two, one, zero),
      sure};
}

template <class D, class V>
HWY_INLINE RootPack<Pack<V>> RootsOf(D d, const CubicPack<Pack<V>>& f) {
  using W = Pack<V>;
  const W zero = SetPack(d, 0), one = SetPack(d, 1), minus = SetPack(d, -1);
  const auto t = TurnsOf(d, f);
  const W f1 = CubicAt(f, t.low), f2 = CubicAt(f, t.high);
  W sure = IfNoRoot(d, f, t.low, f1, IfNoRoot(d, f, t.high, f2, t.sure));
  const auto upper = Lt(f2, zero), three = And(upper, Gt(f1, zero));
  const auto outer = [&](W v) MIEN_LANES {
    const W by_cube = Each([&](V x) MIEN_LANES { return CubeRootAbove(d, x); }, Div(v, f.a));
    const W by_square = Sqrt(Div(v, t.bend));
    const W by_slope = Div(v, t.slope);
    const W other = IfThenElse(Gt(t.are_two, zero), by_square, by_slope);
    return IfThenElse(Lt(other, by_cube), other, by_cube);
  };
  // The outer root that is always there: above the high turn if it lies below 0, else below the low one.
  const W v = Abs(IfThenElse(upper, f2, f1));
  const W high = RootFrom(d, f, IfThenElse(upper, t.high, t.low), IfThenElse(upper, one, minus),
                          t.slope, t.bend, f.a, v, outer(v));
  sure = IfRoot(d, f, high, sure);
  const W is_three = IfThenElse(three, one, zero);
  if (!AnyTrue(d, three)) return {high, high, high, is_three, sure};
  const W low = RootFrom(d, f, t.low, minus, zero, t.bend, f.a, f1, outer(f1));
  const auto from_low = Lt(f1, Neg(f2));
  const W least = IfThenElse(from_low, f1, Neg(f2));
  const W half_way = Mul(Sqrt(Div(least, t.bend)), SetPack(d, 1.2247448713915890));  // √(3/2)
  const W middle =
      RootFrom(d, f, IfThenElse(from_low, t.low, t.high), IfThenElse(from_low, one, minus), zero,
               t.bend, Neg(f.a), least, half_way);
  W all = IfRoot(d, f, low, IfRoot(d, f, middle, sure));
  all = IfThenElse(
      And(And(Lt(low, t.low), Lt(t.low, middle)), And(Lt(middle, t.high), Lt(t.high, high))), all,
      zero);
  return {low, middle, high, is_three, IfThenElse(three, all, sure)};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
