// Area of a pixel inside an edge, many pixels at a time: the SIMD twin of render/cover/edge_coverage.h.
// Included once per instruction set.
#if defined(MIEN_RENDER_COVER_EDGE_AREA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_COVER_EDGE_AREA_INL_H_
#undef MIEN_RENDER_COVER_EDGE_AREA_INL_H_
#else
#define MIEN_RENDER_COVER_EDGE_AREA_INL_H_
#endif

#include <mien/sdf/batch/fma-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The same as EdgeArea for a straight edge.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V StraightEdgeArea(D f, V d, V gx, V gy) {
  const V half = hn::Set(f, 0.5f), zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const V ax = hn::Abs(gx), ay = hn::Abs(gy);
  const V a = hn::Max(ax, ay), b = hn::Max(hn::Min(ax, ay), hn::Set(f, 1e-5f));
  const V u = hn::Max(FusedLess(half, hn::Add(a, b), hn::Abs(d)), zero), m = hn::Min(u, b);
  const V outer = hn::Div(hn::Mul(hn::Mul(m, half), hn::Sub(hn::Add(u, u), m)), hn::Mul(a, b));
  return hn::IfThenElse(hn::Lt(d, zero), hn::Sub(one, outer), outer);
}

/// Area of the unit square inside a bent edge.
///
///   d        signed distance, square's centre to edge, times |(gx, gy)|
///   gx, gy   outward normal, of any length near 1
///   k        bend
///
/// Derivation.  The straight edge's area is a trapezoid's integral (see straight_edge_coverage); with u = (a + b)/2 − |d|,
///   m = min(u, b), both its branches are m (2u − m)/(2ab). A bend moves the edge by k t²/2 at t along it, so the area
///   loses k/6 (t2³ − t1³) over the chord [t1, t2] of the tangent.
/// Error.  Below |k|/24, reached where the tangent runs along a side of the square and just misses it while the edge
///   bends into it (0.035 |k| at 0.03, over all places and directions); 1e-5 for floats and for taking b as at least 1e-5.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V EdgeArea(D f, V d, V gx, V gy, V k) {
  const V half = hn::Set(f, 0.5f), zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const V ax = hn::Abs(gx), ay = hn::Abs(gy);
  const V a = hn::Max(ax, ay), b = hn::Max(hn::Min(ax, ay), hn::Set(f, 1e-5f));
  const V inverse = hn::Div(one, hn::Mul(a, b)), ia = hn::Mul(b, inverse), ib = hn::Mul(a, inverse);
  const V t = hn::Abs(d);
  const V u = hn::Max(FusedLess(half, hn::Add(a, b), t), zero), m = hn::Min(u, b);
  const V outer = hn::Mul(hn::Mul(m, hn::Sub(hn::Add(u, u), m)), hn::Mul(half, inverse));
  const V straight = hn::IfThenElse(hn::Lt(d, zero), hn::Sub(one, outer), outer);
  const V da = hn::Mul(d, a), db = hn::Mul(d, b);
  const V lo = hn::Max(hn::Mul(hn::Sub(db, half), ia), hn::Mul(hn::Neg(hn::Add(da, half)), ib));
  const V hi = hn::Min(hn::Mul(hn::Add(db, half), ia), hn::Mul(hn::Sub(half, da), ib));
  const V cubes = FusedLess(hn::Mul(hi, hi), hi, hn::Mul(hn::Mul(lo, lo), lo));
  const V lost =
      hn::IfThenElseZero(hn::Gt(hi, lo), hn::Mul(hn::Mul(k, hn::Set(f, 1.0f / 6)), cubes));
  return hn::Min(hn::Max(hn::Sub(straight, lost), zero), one);
}

/// The same for a rectangle of sides (wx, wy), as a share of its area.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V EdgeAreaOfStrip(D f, V d, V gx, V gy, V k, V wx, V wy) {
  const V half = hn::Set(f, 0.5f), one = hn::Set(f, 1.0f), tiny = hn::Set(f, 1e-5f);
  const V nx = hn::Max(hn::Abs(gx), tiny), ny = hn::Max(hn::Abs(gy), tiny);
  const V straight = EdgeArea(f, d, hn::Mul(nx, wx), hn::Mul(ny, wy), hn::Zero(f));
  const V inverse = hn::Div(one, hn::Mul(nx, ny)), ix = hn::Mul(ny, inverse),
          iy = hn::Mul(nx, inverse);
  const V hx = hn::Mul(wx, half), hy = hn::Mul(wy, half), dx = hn::Mul(d, nx), dy = hn::Mul(d, ny);
  const V lo = hn::Max(hn::Mul(hn::Sub(dy, hy), ix), hn::Mul(hn::Neg(hn::Add(dx, hx)), iy));
  const V hi = hn::Min(hn::Mul(hn::Add(dy, hy), ix), hn::Mul(hn::Sub(hx, dx), iy));
  const V cubes = FusedLess(hn::Mul(hi, hi), hi, hn::Mul(hn::Mul(lo, lo), lo));
  const V share = hn::Div(hn::Mul(hn::Mul(k, hn::Set(f, 1.0f / 6)), cubes), hn::Mul(wx, wy));
  const V lost = hn::IfThenElseZero(hn::Gt(hi, lo), share);
  return hn::Min(hn::Max(hn::Sub(straight, lost), hn::Zero(f)), one);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
