// The one rule for multiply-add. Where the instruction set has it, it is fused:
// those machines (x86 since 2013, every 64-bit ARM) all compute the same bits. Older ones multiply,
// round, add and round, unless the build asks for MIEN_SAME_BITS_WITHOUT_FMA: then they get the
// fused result the long way, exactly, at twelve times the price (docs/decisions/same_bits.md).
// Included once per instruction set.
#if defined(MIEN_SDF_BATCH_FMA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_FMA_INL_H_
#undef MIEN_SDF_BATCH_FMA_INL_H_
#else
#define MIEN_SDF_BATCH_FMA_INL_H_
#endif

#include <hwy/highway.h>

#include <cmath>
#include <type_traits>

/// What a lambda over lanes must carry: this instruction set, and to be inlined (else packs of
/// vectors travel through memory, at a third of the speed).
#undef MIEN_LANES
#define MIEN_LANES HWY_ATTR __attribute__((always_inline))

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET != HWY_SCALAR

/// x y + z of floats, rounded once. The product is exact in double precision; the sum is rounded to
/// odd (if inexact, to the neighbour whose last bit is 1), after which rounding to float is the
/// only rounding that shows: 53 >= 2·24 + 2 bits.
template <class DF, class VF = hn::Vec<DF>>
HWY_INLINE VF FusedInDouble(DF df, VF x, VF y, VF z) {
  const hn::Rebind<double, DF> d;
  const hn::RebindToSigned<decltype(d)> di;
  const auto p = hn::Mul(hn::PromoteTo(d, x), hn::PromoteTo(d, y)), c = hn::PromoteTo(d, z);
  const auto s = hn::Add(p, c), back = hn::Sub(s, p);
  const auto rest = hn::Add(hn::Sub(p, hn::Sub(s, back)), hn::Sub(c, back));  // p + c − s, exactly
  const auto zero = hn::Zero(d);
  const auto bits = hn::BitCast(di, s), one = hn::Set(di, 1);
  const auto below = hn::VecFromMask(d, hn::Lt(rest, zero)),
             above = hn::VecFromMask(d, hn::Gt(rest, zero));
  const auto inward = hn::Xor(below, hn::VecFromMask(d, hn::Lt(s, zero)));  // towards 0: bits − 1
  const auto even = hn::Sub(hn::And(bits, one), one);                       // all ones where even
  const auto step = hn::And(hn::And(hn::Or(hn::BitCast(di, inward), one), even),
                            hn::BitCast(di, hn::Or(below, above)));
  return hn::DemoteTo(df, hn::BitCast(d, hn::Add(bits, step)));
}

#endif

/// x y + z by emulation: the bits of a fused multiply-add. Doubles go through std::fma one by one.
template <class V>
HWY_INLINE V Emulated(V x, V y, V z) {
  using D = hn::DFromV<V>;
  const D d;
  if constexpr (std::is_same_v<hn::TFromD<D>, double>) {
    HWY_ALIGN double lanes[3][hn::MaxLanes(D())];
    hn::Store(x, d, lanes[0]), hn::Store(y, d, lanes[1]), hn::Store(z, d, lanes[2]);
    for (size_t i = 0; i < hn::Lanes(d); ++i)
      lanes[2][i] = std::fma(lanes[0][i], lanes[1][i], lanes[2][i]);
    return hn::Load(d, lanes[2]);
  } else {
#if HWY_TARGET == HWY_SCALAR
    return hn::Set(d, std::fma(hn::GetLane(x), hn::GetLane(y), hn::GetLane(z)));
#else
    if constexpr (hn::MaxLanes(D()) <= 2) {
      return FusedInDouble(d, x, y, z);
    } else {
      const hn::Half<D> half;
      const auto high = FusedInDouble(half, hn::UpperHalf(half, x), hn::UpperHalf(half, y),
                                      hn::UpperHalf(half, z));
      const auto low = FusedInDouble(half, hn::LowerHalf(x), hn::LowerHalf(y), hn::LowerHalf(z));
      return hn::Combine(d, high, low);
    }
#endif
  }
}

/// Whether this instruction set gives the fused bits.
// Named are those that fuse: WebAssembly's lanes, and emulated ones, multiply, round and add.
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL || \
    (HWY_ARCH_ARM_A64 && HWY_TARGET != HWY_SCALAR)
inline constexpr bool kNativeFma = true;
#else
inline constexpr bool kNativeFma = false;
#endif
#ifdef MIEN_SAME_BITS_WITHOUT_FMA
inline constexpr bool kEmulateFma = !kNativeFma;
#else
inline constexpr bool kEmulateFma = false;
#endif

/// x y + z.
template <class V>
HWY_INLINE V Fused(V x, V y, V z) {
  if constexpr (kEmulateFma) return Emulated(x, y, z);
  return hn::MulAdd(x, y, z);
}
/// z − x y.
template <class V>
HWY_INLINE V FusedFrom(V x, V y, V z) {
  if constexpr (kEmulateFma) return Emulated(hn::Neg(x), y, z);
  return hn::NegMulAdd(x, y, z);
}
/// x y − z.
template <class V>
HWY_INLINE V FusedLess(V x, V y, V z) {
  if constexpr (kEmulateFma) return Emulated(x, y, hn::Neg(z));
  return hn::MulSub(x, y, z);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
