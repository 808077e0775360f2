// Distances to a cubic Bézier, many points at a time: the SIMD twin of sdf/shape/curve/cubic_bezier.h. Included
// once per instruction set. Derivation and proof: docs/derivations/cubic_bezier.md.
#if defined(MIEN_SDF_BATCH_CUBIC_BEZIER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_CUBIC_BEZIER_INL_H_
#undef MIEN_SDF_BATCH_CUBIC_BEZIER_INL_H_
#else
#define MIEN_SDF_BATCH_CUBIC_BEZIER_INL_H_
#endif

#include "sdf/distance/cubic_bezier/cubic_bezier_frame.h"
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/pack-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A piece in which f rises through zero: where it begins (−1: there is none), and f at its begin, middle and end.
template <class V>
struct Rising {
  V begin, low, middle, high;
};

/// At most two per point of a pack.
template <class D, class T = hn::TFromD<D>>
struct Brackets {
  static constexpr size_t kMost = kParts * hn::MaxLanes(D());
  HWY_ALIGN T begin[2][kMost], low[2][kMost], middle[2][kMost], high[2][kMost];
  HWY_ALIGN T curl[kMost];  ///< bounds |f''|; NaN where the search is in doubt
  bool any_second;
};

/// |B − p|² and f at the samples, one vector of points.
template <class D, class T = hn::TFromD<D>>
struct Samples {
  static constexpr int kCount = 2 * CubicFrame<T>::kPieces + 1;
  HWY_ALIGN T square[kCount][hn::MaxLanes(D())], f[kCount][hn::MaxLanes(D())];
};

/// p0 − p, scaled.
template <class D, class V, class T = hn::TFromD<D>>
HWY_INLINE V OffsetOn(D d, V p, T scale, T origin, T low) {
  return hn::Add(FusedFrom(p, hn::Set(d, scale), hn::Set(d, origin)), hn::Set(d, low));
}

/// Fills the samples; returns the least square.
template <class D, class V, class T = hn::TFromD<D>>
HWY_INLINE V Sampled(D d, const CubicFrame<T>& f, V ox, V oy, Samples<D>& at) {
  V least = hn::Set(d, std::numeric_limits<T>::max());
  for (int i = 0; i < Samples<D>::kCount; ++i) {
    const auto& b = f.sample[i];
    const V qx = hn::Add(ox, hn::Set(d, b.x)), qy = hn::Add(oy, hn::Set(d, b.y));
    const V square = Fused(qx, qx, hn::Mul(qy, qy));
    hn::Store(square, d, at.square[i]);
    hn::Store(Fused(qx, hn::Set(d, b.ux), hn::Mul(qy, hn::Set(d, b.uy))), d, at.f[i]);
    least = hn::Min(square, least);
  }
  return least;
}

template <class V>
HWY_INLINE V Least(V a, V b, V c) {
  return hn::Min(hn::Min(a, b), c);
}
template <class V>
HWY_INLINE V Most(V a, V b, V c) {
  return hn::Max(hn::Max(a, b), c);
}
template <class M, class V>
HWY_INLINE void Keep(M m, const Rising<V>& found, Rising<V>& kept) {
  kept.begin = hn::IfThenElse(m, found.begin, kept.begin);
  kept.low = hn::IfThenElse(m, found.low, kept.low);
  kept.middle = hn::IfThenElse(m, found.middle, kept.middle);
  kept.high = hn::IfThenElse(m, found.high, kept.high);
}

/// Bounds on f over one piece, from its values at begin, middle and end: f is the parabola through them and
/// a rest that the frame bounds.
template <class V>
struct PieceBounds {
  V apart;       ///< how far the parabola is from 0, on one side; <= 0 if not proven
  V rise, fall;  ///< f's slope times the piece's width is at least rise, at most −fall
};

template <class D, class V>
HWY_INLINE PieceBounds<V> BoundsOn(D d, V low, V middle, V high, V turn) {
  const V three = hn::Set(d, 3), half = hn::Set(d, hn::TFromD<D>(0.5)), two = hn::Set(d, 2);
  // The parabola's slopes at the ends times the width, and its middle Bernstein coefficient; then those
  // of f's slope.
  const V a = hn::Sub(middle, low), b = hn::Sub(high, middle);
  const V slope0 = FusedLess(a, three, b), slope1 = FusedLess(b, three, a);
  const V bulge = Fused(hn::Sub(a, b), half, middle);
  const V mean = FusedFrom(turn, two, hn::Sub(high, low));
  PieceBounds<V> bounds;
  bounds.rise = hn::Min(hn::Add(hn::Min(slope0, slope1), turn), mean);
  bounds.fall = hn::Neg(hn::Max(hn::Add(hn::Max(slope0, slope1), turn), mean));
  bounds.apart = hn::Max(Least(low, high, bulge), hn::Neg(Most(low, high, bulge)));
  return bounds;
}

/// Stores one vector's brackets from place k of a pack on.
template <class D, class V>
HWY_INLINE void StoreRising(D d, const Rising<V>& r, int which, size_t k, Brackets<D>& out) {
  hn::Store(r.begin, d, out.begin[which] + k), hn::Store(r.low, d, out.low[which] + k);
  hn::Store(r.middle, d, out.middle[which] + k), hn::Store(r.high, d, out.high[which] + k);
}

/// Finds the brackets of one vector of points, which is number `part` of the pack.
template <class D, class T = hn::TFromD<D>>
HWY_INLINE void FindBrackets(D d, const CubicFrame<T>& f, const T* x, const T* y, size_t part,
                             Brackets<D>& out) {
  using V = hn::Vec<D>;
  constexpr T kUlp = std::numeric_limits<T>::epsilon();
  const V ox = OffsetOn(d, hn::LoadU(d, x), f.scale, f.x0, f.x0_low);
  const V oy = OffsetOn(d, hn::LoadU(d, y), f.scale, f.y0, f.y0_low);
  Samples<D> at;
  const V least = Sampled(d, f, ox, oy, at);
  const V away = hn::Mul(hn::Sqrt(least), hn::Set(d, T(1 + 0x1p-18))), away2 = hn::Mul(away, away);
  const V place = hn::Add(hn::Abs(ox), hn::Abs(oy));
  const V noise = Fused(place, hn::Set(d, 4 * kUlp), hn::Set(d, 16 * kUlp));
  const V noise4 = hn::Mul(noise, hn::Set(d, 4)), noise8 = hn::Mul(noise, hn::Set(d, 8));
  const V none = hn::Set(d, -1), one = hn::Set(d, 1);
  Rising<V> first{none, none, one, one}, second = first;
  auto has1 = hn::Lt(one, none), has2 = has1, doubt = has1;
  V f0 = hn::Load(d, at.f[0]), s0 = hn::Load(d, at.square[0]);
  for (int i = 0; i < CubicFrame<T>::kPieces; ++i) {
    const auto& piece = f.piece[i];
    const V fm = hn::Load(d, at.f[2 * i + 1]), f1 = hn::Load(d, at.f[2 * i + 2]), low = f0;
    const V sm = hn::Load(d, at.square[2 * i + 1]), s1 = hn::Load(d, at.square[2 * i + 2]);
    const V beyond = hn::Add(away2, hn::Set(d, piece.reach2));
    const auto near = hn::Le(Least(s0, sm, s1), Fused(away, hn::Set(d, piece.reach), beyond));
    f0 = f1, s0 = s1;
    if (hn::AllFalse(d, near)) continue;
    const V tilt = hn::Add(noise8, hn::Set(d, piece.tilt));
    const V off = hn::Add(noise4, hn::Set(d, piece.off));
    const auto b = BoundsOn(d, low, fm, f1, hn::Set(d, piece.turn));
    const auto unknown = hn::And(hn::Le(b.apart, off), hn::Le(hn::Max(b.rise, b.fall), tilt));
    const auto rises = hn::And(hn::Le(low, noise), hn::Ge(f1, hn::Neg(noise)));
    const auto up = hn::And(hn::And(near, hn::Gt(b.rise, tilt)), rises);
    const auto next = hn::And(up, has1);
    doubt = hn::Or(doubt, hn::Or(hn::And(near, unknown), hn::And(next, has2)));
    const Rising<V> found{hn::Set(d, T(i) / CubicFrame<T>::kPieces), low, fm, f1};
    Keep(next, found, second);
    Keep(hn::AndNot(has1, up), found, first);
    has2 = hn::Or(has2, next), has1 = hn::Or(has1, up);
  }
  const size_t k = part * hn::Lanes(d);
  const auto sure = hn::AndNot(doubt, hn::Lt(least, hn::Set(d, kFar<T>)));
  const V curl = Fused(away, hn::Set(d, f.curl_far), hn::Set(d, f.curl));
  hn::Store(hn::IfThenElse(sure, curl, hn::NaN(d)), d, out.curl + k);
  StoreRising(d, first, 0, k, out), StoreRising(d, second, 1, k, out);
  out.any_second = out.any_second || !hn::AllFalse(d, has2);
}

/// One Newton step for f = 0 that stays in the piece.
template <class D, class W, class T = hn::TFromD<D>>
HWY_INLINE W SteppedInPiece(D d, const CubicExpansion<T>& c, W ox, W oy, W begin, W end, W t) {
  const W r = Sub(t, SetPack(d, T(0.5)));
  const auto axis = [&](W o, T m, T a, T b, T k, T u0, T v0, T k2, W& q, W& u, W& v) MIEN_LANES {
    const W rest = MulAdd(r, MulAdd(r, SetPack(d, k), SetPack(d, b)), SetPack(d, a));
    q = MulAdd(r, rest, Add(o, SetPack(d, m)));
    u = MulAdd(r, MulAdd(r, SetPack(d, k), SetPack(d, v0)), SetPack(d, u0));
    v = MulAdd(r, SetPack(d, k2), SetPack(d, v0));
  };
  W qx, ux, vx, qy, uy, vy;
  axis(ox, c.mx, c.ax, c.bx, c.cx, c.ux, c.vx, c.c2x, qx, ux, vx);
  axis(oy, c.my, c.ay, c.by, c.cy, c.uy, c.vy, c.c2y, qy, uy, vy);
  const W value = MulAdd(qx, ux, Mul(qy, uy));
  const W speed2 = Mul(MulAdd(ux, ux, Mul(uy, uy)), SetPack(d, 3));
  const W rise = MulAdd(qx, vx, MulAdd(qy, vy, speed2));
  return Min(Max(Sub(t, Div(value, Max(rise, SetPack(d, T(1e-30f))))), begin), end);
}

/// B(t) − p along one axis.
template <class D, class V>
HWY_INLINE V ResidualOn(D d, V o, V r, double m, double a, double b, double c) {
  const V rest = Fused(r, Fused(r, hn::Set(d, c), hn::Set(d, b)), hn::Set(d, a));
  return Fused(r, rest, hn::Add(o, hn::Set(d, m)));
}

/// Below this share of its terms the second derivative is in doubt: it could be mostly rounding.
inline constexpr double kLeastRise = 0x1p-36;

/// |B − p|² in double lanes after a last Newton step from t; NaN unless it is proven that this loses at most
/// `tolerance` of the distance. `curl` bounds |f''|.
template <class D, class V>
HWY_INLINE V ProvenSquare(D d, const CubicExpansion<double>& c, V ox, V oy, V t, V curl,
                          double tolerance) {
  const V half = hn::Set(d, 0.5), r = hn::Sub(t, half);
  const V qx = ResidualOn(d, ox, r, c.mx, c.ax, c.bx, c.cx);
  const V qy = ResidualOn(d, oy, r, c.my, c.ay, c.by, c.cy);
  const V vx = Fused(r, hn::Set(d, c.c2x), hn::Set(d, c.vx));
  const V vy = Fused(r, hn::Set(d, c.c2y), hn::Set(d, c.vy));
  const V ux = Fused(r, Fused(r, hn::Set(d, c.cx), hn::Set(d, c.vx)), hn::Set(d, c.ux));
  const V uy = Fused(r, Fused(r, hn::Set(d, c.cy), hn::Set(d, c.vy)), hn::Set(d, c.uy));
  const V speed2 = hn::Mul(Fused(ux, ux, hn::Mul(uy, uy)), hn::Set(d, 3));
  const V turn_x = hn::Mul(qx, vx), turn_y = hn::Mul(qy, vy);
  const V rise = hn::Add(hn::Add(turn_x, turn_y), speed2);
  const V terms = hn::Add(hn::Add(hn::Abs(turn_x), hn::Abs(turn_y)), speed2);
  const V step = hn::Div(Fused(qx, ux, hn::Mul(qy, uy)), hn::Max(rise, hn::Set(d, 1e-30)));
  const V next = hn::Sub(hn::Min(hn::Max(hn::Sub(t, step), hn::Zero(d)), hn::Set(d, 1)), half);
  const V nx = ResidualOn(d, ox, next, c.mx, c.ax, c.bx, c.cx);
  const V ny = ResidualOn(d, oy, next, c.my, c.ay, c.by, c.cy);
  const V square = Fused(nx, nx, hn::Mul(ny, ny));
  // What Newton's step leaves of the square is at most 1.22 (curl step²)² / rise.
  const V size = hn::Abs(step), curled = hn::Mul(curl, size), miss = hn::Mul(curled, size);
  const V loss = hn::Mul(hn::Mul(miss, miss), hn::Set(d, 1.5));
  const V allowed = hn::Mul(hn::Set(d, tolerance), rise);
  const V most =
      hn::Mul(hn::Mul(allowed, allowed), hn::Max(square, hn::Set(d, tolerance * tolerance)));
  const V least_rise = hn::Max(hn::Set(d, kLeastRise), hn::Mul(terms, hn::Set(d, kLeastRise)));
  const auto isolated =
      hn::And(hn::Le(size, hn::Set(d, 1.0 / 128)),
              hn::And(hn::Gt(rise, least_rise), hn::Le(hn::Mul(curled, hn::Set(d, 16)), rise)));
  const auto proven = hn::And(isolated, hn::Le(hn::Mul(loss, loss), most));
  return hn::IfThenElse(proven, square, hn::NaN(d));
}

/// fn(d, …) in double lanes: floats are promoted, in two halves, and its result is rounded to float.
template <class DT, class Fn, class V, class... More>
HWY_INLINE V InDoubles(DT dt, Fn fn, V x, More... more) {
  if constexpr (sizeof(hn::TFromD<DT>) == 8) {
    return fn(dt, x, more...);
  } else {
#if HWY_TARGET == HWY_SCALAR
    const hn::Rebind<double, DT> d;
    return hn::DemoteTo(dt, fn(d, hn::PromoteTo(d, x), hn::PromoteTo(d, more)...));
#else
    const hn::Half<DT> half;
    const hn::Repartition<double, DT> d;
    const auto low =
        fn(d, hn::PromoteTo(d, hn::LowerHalf(x)), hn::PromoteTo(d, hn::LowerHalf(more))...);
    const auto high = fn(d, hn::PromoteTo(d, hn::UpperHalf(half, x)),
                         hn::PromoteTo(d, hn::UpperHalf(half, more))...);
    return hn::Combine(dt, hn::DemoteTo(half, high), hn::DemoteTo(half, low));
#endif
  }
}

/// How much of the distance Newton's method may lose [scaled], not counting roundings.
template <class T>
inline constexpr double kCubicTolerance = sizeof(T) == 4 ? 0x1p-27 : 0x1p-54;

/// Newton steps before the last.
template <class T>
inline constexpr int kCubicSteps = sizeof(T) == 4 ? 1 : 2;

/// |B − p|² at the nearer end.
template <class D, class W, class T = hn::TFromD<D>>
HWY_INLINE W SquareAtEnds(D d, const CubicFrame<T>& f, W px, W py) {
  using V = hn::Vec<D>;
  const auto in_doubles = [&](auto dd, auto x, auto y) MIEN_LANES {
    const auto ox = OffsetOn(dd, x, double(f.scale), double(f.x0), double(f.x0_low));
    const auto oy = OffsetOn(dd, y, double(f.scale), double(f.y0), double(f.y0_low));
    const auto ex = hn::Add(ox, hn::Set(dd, f.fine.end_x)),
               ey = hn::Add(oy, hn::Set(dd, f.fine.end_y));
    return hn::Min(Fused(ox, ox, hn::Mul(oy, oy)), Fused(ex, ex, hn::Mul(ey, ey)));
  };
  const auto ends = [&](V x, V y) MIEN_LANES { return InDoubles(d, in_doubles, x, y); };
  return Each(ends, px, py);
}

/// The least square in the brackets of one kind, the largest number where there is none; NaN where it is not
/// proven.
template <class D, class T = hn::TFromD<D>>
HWY_INLINE Pack<hn::Vec<D>> SquareInBracket(D d, const CubicFrame<T>& f, const T* x, const T* y,
                                            const Brackets<D>& found, int which) {
  using V = hn::Vec<D>;
  using W = Pack<V>;
  const W begin = LoadPack(d, found.begin[which]), zero = SetPack(d, 0);
  // The half in which it rises through zero, and the straight line's zero there.
  const W middle = LoadPack(d, found.middle[which]);
  const auto upper = Lt(middle, zero);
  const W low = IfThenElse(upper, middle, LoadPack(d, found.low[which]));
  const W high = IfThenElse(upper, LoadPack(d, found.high[which]), middle);
  const W px = LoadPack(d, x), py = LoadPack(d, y);
  const auto offset = [&](T origin, T rest) MIEN_LANES {
    return [&f, d, origin, rest](V p) MIEN_LANES { return OffsetOn(d, p, f.scale, origin, rest); };
  };
  const W ox = Each(offset(f.x0, f.x0_low), px), oy = Each(offset(f.y0, f.y0_low), py);
  const W width = SetPack(d, T(0.5) / CubicFrame<T>::kPieces);
  const W from = Add(Max(begin, zero), IfThenElse(upper, width, zero)), end = Add(from, width);
  W t = MulAdd(width, Div(low, Sub(low, high)), from);
  t = Min(Max(t, from), end);
  for (int i = 0; i < kCubicSteps<T>; ++i) t = SteppedInPiece(d, f.curve, ox, oy, from, end, t);
  const auto proven = [&](V vx, V vy, V vt, V curl) MIEN_LANES {
    const auto in_doubles = [&](auto dd, auto x2, auto y2, auto t2, auto curl2) MIEN_LANES {
      const auto o_x = OffsetOn(dd, x2, double(f.scale), double(f.x0), double(f.x0_low));
      const auto o_y = OffsetOn(dd, y2, double(f.scale), double(f.y0), double(f.y0_low));
      return ProvenSquare(dd, f.fine, o_x, o_y, t2, curl2, kCubicTolerance<T>);
    };
    return InDoubles(d, in_doubles, vx, vy, vt, curl);
  };
  const W square = Each(proven, px, py, t, LoadPack(d, found.curl));
  return IfThenElse(Lt(begin, zero), SetPack(d, std::numeric_limits<T>::max()), square);
}

/// The lesser of two, or NaN if either is.
template <class D, class W>
HWY_INLINE W LesserOrNan(D d, W a, W b) {
  return IfThenElse(Gt(b, a), a, MulAdd(a, SetPack(d, 0), b));
}

/// The squared distances of a pack of points, NaN where they are not proven.
template <class D, class T = hn::TFromD<D>>
HWY_INLINE Pack<hn::Vec<D>> CubicSquare(D d, const CubicFrame<T>& f, const T* x, const T* y) {
  Brackets<D> found;
  found.any_second = false;
  const size_t n = hn::Lanes(d);
  for (size_t part = 0; part < kParts; ++part) {
    FindBrackets(d, f, x + part * n, y + part * n, part, found);
  }
  auto square = LesserOrNan(d, SquareAtEnds(d, f, LoadPack(d, x), LoadPack(d, y)),
                            SquareInBracket(d, f, x, y, found, 0));
  if (HWY_UNLIKELY(found.any_second))
    square = LesserOrNan(d, square, SquareInBracket(d, f, x, y, found, 1));
  // A curl that is NaN marks doubt. That of a segment run at an even speed is 0.
  const auto curl = LoadPack(d, found.curl);
  return IfThenElse(Gt(curl, SetPack(d, -1)), square, curl);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
