// The last step of the accurate float mode: from a float parameter to a squared distance good to
// float's last bit. Included once per instruction set.
#if defined(MIEN_SDF_BATCH_QUAD_BEZIER_ACCURATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_QUAD_BEZIER_ACCURATE_INL_H_
#undef MIEN_SDF_BATCH_QUAD_BEZIER_ACCURATE_INL_H_
#else
#define MIEN_SDF_BATCH_QUAD_BEZIER_ACCURATE_INL_H_
#endif

#include "sdf/distance/lanes/pack-inl.h"
#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// q = B(t) − p and g = B'(t) in double lanes, for float points and parameters.
template <class V>
struct Residual {
  V qx, qy, gx, gy;
};

template <class D, class VF, class V = hn::Vec<D>>
HWY_INLINE Residual<V> ResidualAt(D d, const QuadBezierFrame<double>& f, VF x, VF y, VF t_float) {
  const auto axis = [&](VF p, double origin, double a2, double b, V t, V& q, V& g) MIEN_LANES {
    const V from = FusedFrom(hn::PromoteTo(d, p), hn::Set(d, f.scale), hn::Set(d, origin));
    const V u = Fused(t, hn::Set(d, b), hn::Set(d, a2));
    q = Fused(t, u, from);
    g = Fused(t, hn::Set(d, b), u);
  };
  Residual<V> r;
  const V t = hn::PromoteTo(d, t_float);
  axis(x, f.x0, f.ax2, f.bx, t, r.qx, r.gx);
  axis(y, f.y0, f.ay2, f.by, t, r.qy, r.gy);
  return r;
}

template <class V>
HWY_INLINE V Dot(V ax, V ay, V bx, V by) {
  return Fused(ax, bx, hn::Mul(ay, by));
}

/// |B(t − step) − p|², or |B(t) − p|² where that is smaller: B(t − s) = B(t) − s (B'(t) − s b)
/// exactly.
template <class D, class V>
HWY_INLINE V SquareAfter(D d, const QuadBezierFrame<double>& f, const Residual<V>& r, V step) {
  const V bx = hn::Set(d, f.bx), by = hn::Set(d, f.by);
  const V qx = FusedFrom(step, FusedFrom(step, bx, r.gx), r.qx);
  const V qy = FusedFrom(step, FusedFrom(step, by, r.gy), r.qy);
  return hn::Min(Dot(r.qx, r.qy, r.qx, r.qy), Dot(qx, qy, qx, qy));
}

/// The squared distance [scaled] from one vector of points, whose nearest parameters t are good to
/// float. slope and rise of the Newton step are computed in double; their quotient needs only
/// float. Where the step is so long that t was not good after all (three critical points meet), the
/// answer is NaN: "ask the scalar form".
template <class DF, class VF>
HWY_INLINE VF AccurateSquare(DF df, const QuadBezierFrame<double>& f, VF x, VF y, VF t) {
  const auto rise_of = [&](auto d, const auto& r) MIEN_LANES {
    const auto bx2 = hn::Set(d, f.bx2), by2 = hn::Set(d, f.by2);
    return Fused(r.qx, bx2, Fused(r.qy, by2, Dot(r.gx, r.gy, r.gx, r.gy)));
  };
  // t − step stays in [0, 1]; where the rise is not positive the step is refused by the clamp or
  // SquareAfter.
  const auto step_of = [&](VF slope, VF rise) MIEN_LANES {
    const VF step = hn::Div(slope, hn::Max(rise, hn::Set(df, 1e-30f)));
    return hn::Min(hn::Max(step, hn::Sub(t, hn::Set(df, 1))), t);
  };
  constexpr float kLongStep = 0x1p-16f;
  const auto refused = [&](VF step, VF square) MIEN_LANES {
    return hn::IfThenElse(hn::Gt(hn::Abs(step), hn::Set(df, kLongStep)), hn::NaN(df), square);
  };
#if HWY_TARGET == HWY_SCALAR
  const hn::Rebind<double, DF> d;
  const auto r = ResidualAt(d, f, x, y, t);
  const VF step =
      step_of(hn::DemoteTo(df, Dot(r.qx, r.qy, r.gx, r.gy)), hn::DemoteTo(df, rise_of(d, r)));
  return refused(step, hn::DemoteTo(df, SquareAfter(d, f, r, hn::PromoteTo(d, step))));
#else
  const hn::Half<DF> half;
  const hn::Repartition<double, DF> d;
  const auto low = ResidualAt(d, f, hn::LowerHalf(x), hn::LowerHalf(y), hn::LowerHalf(t));
  const auto high =
      ResidualAt(d, f, hn::UpperHalf(half, x), hn::UpperHalf(half, y), hn::UpperHalf(half, t));
  const auto demoted = [&](auto a, auto b) MIEN_LANES {
    return hn::Combine(df, hn::DemoteTo(half, b), hn::DemoteTo(half, a));
  };
  const VF slope =
      demoted(Dot(low.qx, low.qy, low.gx, low.gy), Dot(high.qx, high.qy, high.gx, high.gy));
  const VF step = step_of(slope, demoted(rise_of(d, low), rise_of(d, high)));
  return refused(step,
                 demoted(SquareAfter(d, f, low, hn::PromoteTo(d, hn::LowerHalf(step))),
                         SquareAfter(d, f, high, hn::PromoteTo(d, hn::UpperHalf(half, step)))));
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
