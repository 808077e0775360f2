// How a kernel walks over spans of any length. Included once per instruction set.
#if defined(MIEN_SDF_BATCH_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_BLOCKS_INL_H_
#undef MIEN_SDF_BATCH_BLOCKS_INL_H_
#else
#define MIEN_SDF_BATCH_BLOCKS_INL_H_
#endif

#include <mien/sdf/batch/pack-inl.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// out[i] = kernel(x[i], y[i]), a pack at a time. A rest shorter than a pack is padded with its
/// last point: a lane's result never depends on its neighbours, so neither does a point's on where
/// it stands. Inputs are read before the output is written, so out may be x or y.
template <class D, class T, class Kernel>
HWY_INLINE void ForBlocks(D d, const T* x, const T* y, size_t count, T* out, Kernel kernel) {
  const size_t step = kParts * hn::Lanes(d);
  size_t i = 0;
  for (; i + step <= count; i += step) {
    StorePack(kernel(LoadPack(d, x + i), LoadPack(d, y + i)), d, out + i);
  }
  if (i == count) return;
  HWY_ALIGN T rest[3][kParts * hn::MaxLanes(D())];
  const size_t left = count - i;
  for (size_t k = 0; k < step; ++k) {
    rest[0][k] = x[i + std::min(k, left - 1)], rest[1][k] = y[i + std::min(k, left - 1)];
  }
  StorePack(kernel(LoadPack(d, rest[0]), LoadPack(d, rest[1])), d, rest[2]);
  std::copy_n(rest[2], left, out + i);
}

/// Lanes whose squared distance a kernel could not compute (NaN, or beyond `far`) get `exact(x,
/// y)`.
template <class D, class V, class Exact>
HWY_NOINLINE Pack<V> Rescued(D d, const Pack<V>& x, const Pack<V>& y, const Pack<V>& square,
                             hn::TFromD<D> far, const Pack<V>& distance, const Exact& exact) {
  using T = hn::TFromD<D>;
  HWY_ALIGN T lanes[4][kParts * hn::MaxLanes(D())];
  StorePack(x, d, lanes[0]), StorePack(y, d, lanes[1]);
  StorePack(square, d, lanes[2]), StorePack(distance, d, lanes[3]);
  for (size_t k = 0; k < kParts * hn::Lanes(d); ++k) {
    if (!(lanes[2][k] < far)) lanes[3][k] = T(exact(lanes[0][k], lanes[1][k]));
  }
  return LoadPack(d, lanes[3]);
}

/// The root of a squared distance in the frame's scale, back in the caller's units, far lanes
/// rescued.
template <class D, class V, class Exact>
HWY_INLINE Pack<V> DistanceOf(D d, Pack<V> x, Pack<V> y, Pack<V> square, hn::TFromD<D> unscale,
                              const Exact& exact) {
  // Up to here no power of the cubic's numbers overflows (docs/derivations/depressed_cubic.md).
  constexpr auto kFar = hn::TFromD<D>(sizeof(hn::TFromD<D>) == 4 ? 0x1p48 : 0x1p80);
  const auto distance = Mul(Sqrt(square), SetPack(d, unscale));
  if (HWY_LIKELY(AllTrue(d, Lt(square, SetPack(d, kFar))))) return distance;
  return Rescued(d, x, y, square, kFar, distance, exact);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
