// How a kernel walks over spans of any length. Included once per instruction set.
#if defined(MIEN_SDF_BATCH_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_BLOCKS_INL_H_
#undef MIEN_SDF_BATCH_BLOCKS_INL_H_
#else
#define MIEN_SDF_BATCH_BLOCKS_INL_H_
#endif

#include "sdf/distance/lanes/pack-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The same frame, but the compiler knows nothing of its contents. So it broadcasts constants from memory where
/// they are used (which costs nothing) instead of keeping twenty of them in registers it does not have. Measured:
/// 1.3 times the speed on AVX-512, twice on AVX2.
template <class Frame>
HWY_INLINE const Frame& Reloaded(const Frame& frame) {
  const Frame* p = &frame;
  __asm__ volatile("" : "+r"(p));
  return *p;
}

/// out[i] = kernel(x + i, y + i), a pack at a time. A rest shorter than a pack is padded with its last point: a
/// lane's result never depends on its neighbours, so a point's result does not depend on its place. Inputs are read
/// before the output is written, so out may be x or y.
template <class D, class T, class Kernel>
HWY_INLINE void ForBlocks(D d, const T* x, const T* y, size_t count, T* out, Kernel kernel) {
  const size_t step = kParts * hn::Lanes(d);
  HWY_ALIGN T rest[3][kParts * hn::MaxLanes(D())];
  for (size_t i = 0; i < count; i += step) {
    const size_t left = count - i;
    const T *from_x = x + i, *from_y = y + i;
    T* to = out + i;
    if (HWY_UNLIKELY(left < step)) {
      for (size_t k = 0; k < step; ++k) {
        rest[0][k] = from_x[std::min(k, left - 1)], rest[1][k] = from_y[std::min(k, left - 1)];
      }
      from_x = rest[0], from_y = rest[1], to = rest[2];
    }
    StorePack(kernel(from_x, from_y), d, to);
    if (HWY_UNLIKELY(left < step)) std::copy_n(rest[2], left, out + i);
  }
}

/// Lanes whose squared distance a kernel could not compute (NaN, or beyond `far`) get `exact(x,
/// y)`. Takes arrays, not packs: a pack whose address is taken lives in memory from its birth.
template <class T, class Exact>
HWY_NOINLINE void Rescue(const T* x, const T* y, const T* square, size_t count, T far, T* distance,
                         const Exact& exact) {
  for (size_t k = 0; k < count; ++k) {
    if (!(square[k] < far)) distance[k] = T(exact(x[k], y[k]));
  }
}

/// The distances, except in lanes whose `square` is NaN or not below `far`: those are rescued from
/// the points' own coordinates, so that the kernel need not keep them.
template <class D, class V, class T, class Exact>
HWY_INLINE Pack<V> Checked(D d, const T* x, const T* y, Pack<V> square, T far, Pack<V> distance,
                           const Exact& exact) {
  if (HWY_LIKELY(AllTrue(d, Lt(square, SetPack(d, far))))) return distance;
  HWY_ALIGN T lanes[2][kParts * hn::MaxLanes(D())];
  StorePack(square, d, lanes[0]), StorePack(distance, d, lanes[1]);
  Rescue(x, y, lanes[0], kParts * hn::Lanes(d), far, lanes[1], exact);
  return LoadPack(d, lanes[1]);
}

/// Up to this square [scaled] no power of the cubic's numbers overflows
/// (docs/derivations/depressed_cubic.md).
template <class T>
inline constexpr T kFar = T(sizeof(T) == 4 ? 0x1p48 : 0x1p80);

/// The root of a squared distance in the frame's scale, back in the caller's units.
template <class D, class V, class T, class Exact>
HWY_INLINE Pack<V> DistanceOf(D d, const T* x, const T* y, Pack<V> square, T unscale,
                              const Exact& exact) {
  return Checked(d, x, y, square, kFar<T>, Mul(Sqrt(square), SetPack(d, unscale)), exact);
}

/// From this square on [scaled; 2 sizes away or more] half roundings of the point's place are measured against the
/// distance and no longer against the curve's size: points this far go through `far`, which is more careful.
inline constexpr float kClose = 4;

/// The distances, except in packs with a square not below kClose (or NaN): there far(x, y, distances)
/// mends the lanes that are. It starts again from the points' own coordinates, out of line, so that
/// the kernel keeps nothing for it.
template <class D, class V, class Far>
HWY_INLINE Pack<V> CloseOrFar(D d, const float* x, const float* y, Pack<V> square, Pack<V> distance,
                              const Far& far) {
  if (HWY_LIKELY(AllTrue(d, Lt(square, SetPack(d, kClose))))) return distance;
  HWY_ALIGN float lanes[kParts * hn::MaxLanes(D())];
  StorePack(distance, d, lanes);
  far(x, y, lanes);
  return LoadPack(d, lanes);
}

/// For `far`: lanes of `distance` whose square is not below kClose are taken from `careful`, or, where
/// it is not below `most` either, from exact(x, y).
template <class Exact>
HWY_INLINE void Mend(const float* x, const float* y, const float* square, const float* careful,
                     size_t count, float most, float* distance, const Exact& exact) {
  for (size_t k = 0; k < count; ++k) {
    if (square[k] < kClose) continue;
    distance[k] = square[k] < most ? careful[k] : float(exact(x[k], y[k]));
  }
}

/// a − b x as an unevaluated sum of two floats, b a power of two: nothing is lost.
template <class W>
struct TwoFloats {
  W high, low;
};
template <class W>
HWY_INLINE TwoFloats<W> ExactDifference(W a, W bx) {
  const W high = Sub(a, bx), back = Sub(high, a);
  return {high, Sub(Sub(a, Sub(high, back)), Add(bx, back))};
}

/// |(x + ex, y + ey)|² for small ex, ey: rounded twice.
template <class W>
HWY_INLINE W CarefulSquare(W x, W ex, W y, W ey) {
  const W more = MulAdd(x, ex, Mul(y, ey));
  return MulAdd(x, x, MulAdd(y, y, Add(more, more)));
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
