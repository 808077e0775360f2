// The largest root of a depressed cubic, many at a time, without approximate instructions: the same
// bits on every machine. Included once per instruction set. Derivation:
// docs/derivations/depressed_cubic.md.
#if defined(MIEN_SDF_BATCH_DEPRESSED_CUBIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_DEPRESSED_CUBIC_INL_H_
#undef MIEN_SDF_BATCH_DEPRESSED_CUBIC_INL_H_
#else
#define MIEN_SDF_BATCH_DEPRESSED_CUBIC_INL_H_
#endif

#include "sdf/distance/lanes/pack-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// (2/3) times the bits of a positive float, as an integer, to 1/128 of an octave: by 16-bit
/// halves, which every instruction set multiplies in one step.
template <class D, class V>
HWY_INLINE V TwoThirdsOfBits(D d, V x) {
#if HWY_TARGET == HWY_SCALAR
  const hn::RebindToUnsigned<D> du;
  const uint32_t bits = hn::GetLane(hn::BitCast(du, x));
  const uint32_t high = ((bits >> 16) * 0xAAABu) >> 16, low = ((bits & 0xFFFF) * 0xAAABu) >> 16;
  return hn::BitCast(d, hn::Set(du, high << 16 | low));
#else
  const hn::Repartition<uint16_t, D> d16;
  return hn::BitCast(d, hn::MulHigh(hn::BitCast(d16, x), hn::Set(d16, 0xAAAB)));
#endif
}

/// A first guess at the largest root x of x³ + 3 P x = S2, S2 >= 0: within 12 %, by integer
/// arithmetic on the bits of floats (a float's bits are nearly its logarithm).
///   w ≈ S2^(2/3), at least `floor`;  e ≈ x² where P < 0, x² + 3P where P >= 0: one square root of
///   a quadratic form in P and w.  The four constants were fitted together to the error after one
///   step below.
template <class D, class V>
HWY_INLINE V RootGuess(D d, V p, V s2, float floor) {
  const hn::RebindToSigned<D> di;
  const auto bits = [&](V x) MIEN_LANES { return hn::BitCast(di, x); };
  const V two_thirds = TwoThirdsOfBits(d, s2);
  const V w =
      hn::Max(hn::BitCast(d, hn::Add(bits(two_thirds), hn::Set(di, 354940940))), hn::Set(d, floor));
  const V m = hn::Abs(hn::Mul(p, hn::Set(d, 1.5f)));
  const V form = Fused(m, m, hn::Mul(w, Fused(p, hn::Set(d, -1.18407f), w)));
  const V root = hn::BitCast(d, hn::Add(hn::ShiftRight<1>(bits(form)), hn::Set(di, 0x1FBCAD53)));
  const V e = hn::Add(m, root);
  const V y = hn::BitCast(d, hn::Sub(hn::Set(di, 0x5F34CF0C), hn::ShiftRight<1>(bits(e))));  // 1/√e
  return hn::Mul(y, hn::IfThenElse(hn::Lt(p, hn::Zero(d)), e, hn::Mul(s2, y)));
}

/// The guess in lanes of float or double. The floor keeps powers of x within range where P = S2 =
/// 0.
template <class D, class V>
HWY_INLINE V RootGuessOf(D d, V p, V s2) {
  if constexpr (sizeof(hn::TFromD<D>) == 4) {
    return RootGuess(d, p, s2, 1e-8f);
  } else {
    const hn::Rebind<float, D> df;
    return hn::PromoteTo(d, RootGuess(df, hn::DemoteTo(df, p), hn::DemoteTo(df, s2), 1e-17f));
  }
}

/// One step of order four (Householder's third method, which for a cubic needs one division).
template <class D, class W>
HWY_INLINE W RootStep(D d, W p, W s2, W x) {
  using T = hn::TFromD<D>;
  constexpr T kTiny = sizeof(T) == 4 ? T(1e-35) : T(1e-290);
  const W xx = Mul(x, x), h = Add(xx, p);
  const W g = MulSub(x, MulAdd(p, SetPack(d, 3), xx), s2);
  const W gx = Mul(g, x), h3 = Mul(h, SetPack(d, 3));
  const W a = MulSub(h3, h, gx), b = Sub(a, gx);
  const W den = MulAdd(h3, b, Mul(g, Mul(g, SetPack(d, T(1) / 3))));
  return Sub(x, Div(Mul(g, a), Max(den, SetPack(d, kTiny))));
}

/// The largest root x >= 0 of x³ + 3 P x = S2, S2 >= 0: in float to 1.2e-5 of itself, in double to
/// the rounding of its coefficients.
template <class D, class V>
HWY_INLINE Pack<V> LargestRoot(D d, Pack<V> p, Pack<V> s2) {
  const auto guess = [&](V a, V b) MIEN_LANES { return RootGuessOf(d, a, b); };
  const auto x = RootStep(d, p, s2, Each(guess, p, s2));
  if constexpr (sizeof(hn::TFromD<D>) == 4) return x;
  return RootStep(d, p, s2, x);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
