// A few vectors that take every step together, so that one hides the others' latency. Included once
// per instruction set.
#if defined(MIEN_SDF_BATCH_PACK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_PACK_INL_H_
#undef MIEN_SDF_BATCH_PACK_INL_H_
#else
#define MIEN_SDF_BATCH_PACK_INL_H_
#endif

#include <hwy/highway.h>
#include <mien/sdf/batch/fma-inl.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// How many vectors go together. The kernels are chains of dependent steps, and processors look too
/// few instructions ahead to overlap them by themselves; four pays even where registers spill, six
/// gains nothing more (measured: docs/decisions/batch_kernels.md).
inline constexpr size_t kParts = 4;

template <class V>
struct Pack {
  V part[kParts];
};
template <class M>
struct PackMask {
  M part[kParts];
};

// Each operation of the instruction set, part by part: the same names, the same order of arguments.
#define MIEN_EACH(EXPRESSION) \
  for (size_t i = 0; i < kParts; ++i) r.part[i] = EXPRESSION;
#define MIEN_PACK_1(NAME)              \
  template <class V>                   \
  HWY_INLINE Pack<V> NAME(Pack<V> x) { \
    Pack<V> r;                         \
    MIEN_EACH(hn::NAME(x.part[i]))     \
    return r;                          \
  }
#define MIEN_PACK_2(NAME)                         \
  template <class V>                              \
  HWY_INLINE Pack<V> NAME(Pack<V> x, Pack<V> y) { \
    Pack<V> r;                                    \
    MIEN_EACH(hn::NAME(x.part[i], y.part[i]))     \
    return r;                                     \
  }
#define MIEN_PACK_COMPARE(NAME)                                                                    \
  template <class V>                                                                               \
  HWY_INLINE auto NAME(Pack<V> x, Pack<V> y)->PackMask<decltype(hn::NAME(x.part[0], y.part[0]))> { \
    PackMask<decltype(hn::NAME(x.part[0], y.part[0]))> r;                                          \
    MIEN_EACH(hn::NAME(x.part[i], y.part[i]))                                                      \
    return r;                                                                                      \
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
MIEN_PACK_COMPARE(Lt)
MIEN_PACK_COMPARE(Gt)
MIEN_PACK_COMPARE(Ne)
#undef MIEN_PACK_1
#undef MIEN_PACK_2
#undef MIEN_PACK_COMPARE

/// x y + z, by the rule of fma-inl.h.
template <class V>
HWY_INLINE Pack<V> MulAdd(Pack<V> x, Pack<V> y, Pack<V> z) {
  Pack<V> r;
  MIEN_EACH(Fused(x.part[i], y.part[i], z.part[i]))
  return r;
}
/// z − x y, by the rule of fma-inl.h.
template <class V>
HWY_INLINE Pack<V> NegMulAdd(Pack<V> x, Pack<V> y, Pack<V> z) {
  Pack<V> r;
  MIEN_EACH(FusedFrom(x.part[i], y.part[i], z.part[i]))
  return r;
}
/// x y − z, by the rule of fma-inl.h.
template <class V>
HWY_INLINE Pack<V> MulSub(Pack<V> x, Pack<V> y, Pack<V> z) {
  Pack<V> r;
  MIEN_EACH(FusedLess(x.part[i], y.part[i], z.part[i]))
  return r;
}
template <class M>
HWY_INLINE PackMask<M> And(PackMask<M> x, PackMask<M> y) {
  PackMask<M> r;
  MIEN_EACH(hn::And(x.part[i], y.part[i]))
  return r;
}
template <class M, class V>
HWY_INLINE Pack<V> IfThenElse(PackMask<M> m, Pack<V> yes, Pack<V> no) {
  Pack<V> r;
  MIEN_EACH(hn::IfThenElse(m.part[i], yes.part[i], no.part[i]))
  return r;
}
template <class D, class M>
HWY_INLINE bool AnyTrue(D d, PackMask<M> m) {
  M any = m.part[0];
  for (size_t i = 1; i < kParts; ++i) any = hn::Or(any, m.part[i]);
  return !hn::AllFalse(d, any);
}

template <class D, class M>
HWY_INLINE bool AllTrue(D d, PackMask<M> m) {
  M all = m.part[0];
  for (size_t i = 1; i < kParts; ++i) all = hn::And(all, m.part[i]);
  return hn::AllTrue(d, all);
}

/// f of each part.
template <class V, class F>
HWY_INLINE Pack<V> Each(Pack<V> x, Pack<V> y, F f) {
  Pack<V> r;
  MIEN_EACH(f(x.part[i], y.part[i]))
  return r;
}

template <class D>
HWY_INLINE Pack<hn::Vec<D>> SetPack(D d, hn::TFromD<D> value) {
  Pack<hn::Vec<D>> r;
  MIEN_EACH(hn::Set(d, value))
  return r;
}
template <class D>
HWY_INLINE Pack<hn::Vec<D>> LoadPack(D d, const hn::TFromD<D>* from) {
  Pack<hn::Vec<D>> r;
  MIEN_EACH(hn::LoadU(d, from + i * hn::Lanes(d)))
  return r;
}
template <class D>
HWY_INLINE void StorePack(Pack<hn::Vec<D>> x, D d, hn::TFromD<D>* to) {
  for (size_t i = 0; i < kParts; ++i) hn::StoreU(x.part[i], d, to + i * hn::Lanes(d));
}
#undef MIEN_EACH

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
