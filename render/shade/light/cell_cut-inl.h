// What a straight line leaves of a square, and how far it lies from the line. Included once per
// instruction set.
#if defined(MIEN_RENDER_SHADE_CELL_CUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#undef MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#else
#define MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#endif

#include "sdf/distance/lanes/fma-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where t > 0 in a square: its share, and the mean of t there.
template <class V>
struct CellCut {
  V area, t;
};

/// t = middle + n · u over a square of that side around u = 0, |n| = 1.
///
/// Derivation.  With a = side |nx|, b = side |ny|, t is the sum of its middle and of two numbers spread evenly over
///   [−a/2, a/2] and [−b/2, b/2]. So the mean of g(t) for t > 0 is the second difference of g's second integral G over
///   the corners' values: (G(m+p) − G(m+q) − G(m−q) + G(m−p)) / (ab), p = (a+b)/2, q = |a−b|/2. For 1 and t:
///   G = t²/2, t³/6.
/// Error.  b is taken as at least a/16 (t's spread grows by 1e-4 side²); |middle| within a side, rounding leaves 1e-4.
template <class D, class V = hn::Vec<D>>
HWY_INLINE CellCut<V> CutCell(D f, V middle, V nx, V ny, V side) {
  const V zero = hn::Zero(f), half = hn::Set(f, 0.5f), one = hn::Set(f, 1.0f);
  const V ax = hn::Mul(side, hn::Abs(nx)), ay = hn::Mul(side, hn::Abs(ny));
  const V a = hn::Max(hn::Max(ax, ay), hn::Set(f, 1e-9f));
  const V b = hn::Max(hn::Min(ax, ay), hn::Mul(a, hn::Set(f, 0.0625f)));
  const V p = hn::Mul(half, hn::Add(a, b)), q = hn::Mul(half, hn::Sub(a, b));
  const V over = hn::Div(one, hn::Mul(a, b));
  V two = zero, three = zero;
  const auto add = [&](V at, float sign) HWY_ATTR {
    const V t = hn::Max(at, zero), t2 = hn::Mul(t, t), by = hn::Set(f, sign);
    two = Fused(by, t2, two), three = Fused(by, hn::Mul(t2, t), three);
  };
  add(hn::Add(middle, p), 1.0f), add(hn::Add(middle, q), -1.0f);
  add(hn::Sub(middle, q), -1.0f), add(hn::Sub(middle, p), 1.0f);
  const V area = hn::Min(hn::Max(hn::Mul(hn::Mul(two, half), over), zero), one);
  const V whole = hn::Div(one, hn::Max(area, hn::Set(f, 1e-6f)));
  const V t = hn::Mul(hn::Mul(three, over), hn::Mul(whole, hn::Set(f, 1.0f / 6)));
  return {area, hn::Min(t, hn::Add(hn::Max(middle, zero), p))};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
