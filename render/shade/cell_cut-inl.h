// What a straight line leaves of a square, and what a coordinate is like there. Included once per
// instruction set.
#if defined(MIEN_RENDER_SHADE_CELL_CUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#undef MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#else
#define MIEN_RENDER_SHADE_CELL_CUT_INL_H_
#endif

#include <mien/sdf/batch/fma-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where t > 0 in a square: its share, and there the mean of t, of √t, and the spread of √t.
template <class V>
struct CellCut {
  V area, t, root, spread;
};

/// t = middle + n · u over a square of that side around u = 0, |n| = 1.
///
/// Derivation.  With a = side |nx|, b = side |ny|, t is the sum of its middle and of two numbers spread evenly over
///   [−a/2, a/2] and [−b/2, b/2]. So the mean of g(t) for t > 0 is the second difference of g's second integral G over
///   the corners' values: (G(m+p) − G(m+q) − G(m−q) + G(m−p)) / (ab), p = (a+b)/2, q = |a−b|/2. For 1, t, √t: G = t²/2, t³/6, 4/15 t^(5/2).
/// Error.  b is taken as at least a/16 (t's spread grows by 1e-4 side²). Cancellation leaves 3e-4 at |m| = 4 side;
///   beyond, the moments are those of the uncut square to second order.
template <class D, class V = hn::Vec<D>>
HWY_INLINE CellCut<V> CutCell(D f, V middle, V nx, V ny, float side) {
  const V zero = hn::Zero(f), s = hn::Set(f, side), half = hn::Set(f, 0.5f);
  const V ax = hn::Mul(s, hn::Abs(nx)), ay = hn::Mul(s, hn::Abs(ny));
  const V a = hn::Max(ax, ay), b = hn::Max(hn::Min(ax, ay), hn::Mul(a, hn::Set(f, 0.0625f)));
  const V p = hn::Mul(half, hn::Add(a, b)), q = hn::Mul(half, hn::Sub(a, b));
  const V over = hn::Div(hn::Set(f, 1.0f), hn::Mul(a, b));
  V two = zero, three = zero, root5 = zero;
  const auto add = [&](V at, float sign) HWY_ATTR {
    const V t = hn::Max(at, zero), t2 = hn::Mul(t, t), by = hn::Set(f, sign);
    two = Fused(by, t2, two), three = Fused(by, hn::Mul(t2, t), three);
    root5 = Fused(by, hn::Mul(t2, hn::Sqrt(t)), root5);
  };
  add(hn::Add(middle, p), 1.0f), add(hn::Add(middle, q), -1.0f);
  add(hn::Sub(middle, q), -1.0f), add(hn::Sub(middle, p), 1.0f);
  const V area = hn::Min(hn::Mul(hn::Mul(two, half), over), hn::Set(f, 1.0f));
  const V whole = hn::Div(hn::Set(f, 1.0f), hn::Max(area, hn::Set(f, 1e-6f)));
  const V t = hn::Mul(hn::Mul(three, over), hn::Mul(whole, hn::Set(f, 1.0f / 6)));
  const V root = hn::Mul(hn::Mul(root5, over), hn::Mul(whole, hn::Set(f, 4.0f / 15)));
  const V spread = hn::Max(FusedFrom(root, root, t), zero);
  // Not cut, and far: √m (1 − v/8m²), spread v/4m, v the variance of t.
  const V v = hn::Mul(Fused(a, a, hn::Mul(b, b)), hn::Set(f, 1.0f / 12));
  const V m = hn::Max(middle, hn::Mul(s, hn::Set(f, 0.5f)));
  const V share = hn::Div(v, hn::Mul(m, m));
  const V far_root = hn::Mul(hn::Sqrt(m), FusedFrom(share, hn::Set(f, 0.125f), hn::Set(f, 1.0f)));
  const V far_spread = hn::Mul(hn::Mul(share, m), hn::Set(f, 0.25f));
  const auto far = hn::Gt(middle, hn::Mul(s, hn::Set(f, 3.0f)));
  const auto none = hn::Le(hn::Add(middle, p), zero);
  const V one = hn::Set(f, 1.0f);
  return {hn::IfThenElse(far, one, hn::IfThenElse(none, zero, area)),
          hn::IfThenElse(far, middle, t), hn::IfThenElse(far, far_root, root),
          hn::Sqrt(hn::IfThenElse(far, far_spread, spread))};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
