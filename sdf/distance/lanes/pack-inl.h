// A few vectors that take every step together, so that one hides the others' latency. Included once
// per instruction set.
#if defined(MIEN_SDF_BATCH_PACK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_PACK_INL_H_
#undef MIEN_SDF_BATCH_PACK_INL_H_
#else
#define MIEN_SDF_BATCH_PACK_INL_H_
#endif

#include <hwy/highway.h>
#include "sdf/distance/lanes/fma-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How many vectors go together. The kernels are chains of dependent steps, and processors look too
/// few instructions ahead to overlap them by themselves; four pays even where registers spill, six
/// gains nothing more (measured: docs/decisions/batch_kernels.md).
inline constexpr size_t kParts = 4;

/// Never take the address of one: GCC 12 then copies it through memory in pieces of 16 bytes, and
/// every wider read stalls (a third of the speed).
template <class V>
struct Pack {
  V a, b, c, d;
};
template <class M>
struct PackMask {
  M a, b, c, d;
};

// Each operation of the instruction set, part by part: the same names, the same order of arguments.
#define MIEN_PACK_1(NAME)                                                \
  template <class V>                                                     \
  HWY_INLINE Pack<V> NAME(Pack<V> x) {                                   \
    return {hn::NAME(x.a), hn::NAME(x.b), hn::NAME(x.c), hn::NAME(x.d)}; \
  }
#define MIEN_PACK_2(NAME)                                                                    \
  template <class V>                                                                         \
  HWY_INLINE Pack<V> NAME(Pack<V> x, Pack<V> y) {                                            \
    return {hn::NAME(x.a, y.a), hn::NAME(x.b, y.b), hn::NAME(x.c, y.c), hn::NAME(x.d, y.d)}; \
  }
#define MIEN_PACK_3(NAME, RULE)                                                                  \
  template <class V>                                                                             \
  HWY_INLINE Pack<V> NAME(Pack<V> x, Pack<V> y, Pack<V> z) {                                     \
    return {RULE(x.a, y.a, z.a), RULE(x.b, y.b, z.b), RULE(x.c, y.c, z.c), RULE(x.d, y.d, z.d)}; \
  }
#define MIEN_PACK_COMPARE(NAME)                                                              \
  template <class V>                                                                         \
  HWY_INLINE auto NAME(Pack<V> x, Pack<V> y)->PackMask<decltype(hn::NAME(x.a, y.a))> {       \
    return {hn::NAME(x.a, y.a), hn::NAME(x.b, y.b), hn::NAME(x.c, y.c), hn::NAME(x.d, y.d)}; \
  }
MIEN_PACK_1(Abs)
MIEN_PACK_1(Neg)
MIEN_PACK_1(Sqrt)
MIEN_PACK_2(Add)
MIEN_PACK_2(Sub)
MIEN_PACK_2(Mul)
MIEN_PACK_2(Div)
MIEN_PACK_2(Min)
MIEN_PACK_2(Max)
MIEN_PACK_2(CopySign)
MIEN_PACK_3(MulAdd, Fused)         // x y + z, by the rule of fma-inl.h
MIEN_PACK_3(NegMulAdd, FusedFrom)  // z − x y
MIEN_PACK_3(MulSub, FusedLess)     // x y − z
MIEN_PACK_COMPARE(Lt)
MIEN_PACK_COMPARE(Gt)
MIEN_PACK_COMPARE(Ne)
#undef MIEN_PACK_1
#undef MIEN_PACK_2
#undef MIEN_PACK_3
#undef MIEN_PACK_COMPARE

template <class M>
HWY_INLINE PackMask<M> And(PackMask<M> x, PackMask<M> y) {
  return {hn::And(x.a, y.a), hn::And(x.b, y.b), hn::And(x.c, y.c), hn::And(x.d, y.d)};
}
template <class M, class V>
HWY_INLINE Pack<V> IfThenElse(PackMask<M> m, Pack<V> yes, Pack<V> no) {
  return {hn::IfThenElse(m.a, yes.a, no.a), hn::IfThenElse(m.b, yes.b, no.b),
          hn::IfThenElse(m.c, yes.c, no.c), hn::IfThenElse(m.d, yes.d, no.d)};
}
template <class D, class M>
HWY_INLINE bool AnyTrue(D d, PackMask<M> m) {
  return !hn::AllFalse(d, hn::Or(hn::Or(m.a, m.b), hn::Or(m.c, m.d)));
}
template <class D, class M>
HWY_INLINE bool AllTrue(D d, PackMask<M> m) {
  return hn::AllTrue(d, hn::And(hn::And(m.a, m.b), hn::And(m.c, m.d)));
}

/// f of each part of the packs.
template <class F, class V, class... Packs>
HWY_INLINE Pack<V> Each(F f, Pack<V> x, Packs... more) {
  return {f(x.a, more.a...), f(x.b, more.b...), f(x.c, more.c...), f(x.d, more.d...)};
}

template <class D>
HWY_INLINE Pack<hn::Vec<D>> SetPack(D d, hn::TFromD<D> value) {
  const auto v = hn::Set(d, value);
  return {v, v, v, v};
}
template <class D>
HWY_INLINE Pack<hn::Vec<D>> LoadPack(D d, const hn::TFromD<D>* from) {
  const size_t n = hn::Lanes(d);
  return {hn::LoadU(d, from), hn::LoadU(d, from + n), hn::LoadU(d, from + 2 * n),
          hn::LoadU(d, from + 3 * n)};
}
template <class D>
HWY_INLINE void StorePack(Pack<hn::Vec<D>> x, D d, hn::TFromD<D>* to) {
  const size_t n = hn::Lanes(d);
  hn::StoreU(x.a, d, to), hn::StoreU(x.b, d, to + n);
  hn::StoreU(x.c, d, to + 2 * n), hn::StoreU(x.d, d, to + 3 * n);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
