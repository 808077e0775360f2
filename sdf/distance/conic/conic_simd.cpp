// The batch functions of sdf/distance/distance.h for ellipses and parabola sides, compiled once per
// instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/conic/conic_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/conic/conic-inl.h"
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Points well outside the ellipse are computed once more, with care.
template <class D, class Exact>
HWY_NOINLINE void MendFarFromEllipse(D d, const EllipseFrame<float>& f, const float* x,
                                     const float* y, float* distance, const Exact& exact) {
  const auto r = FromEllipseFar(d, f, LoadPack(d, x), LoadPack(d, y));
  HWY_ALIGN float lanes[2][kParts * hn::MaxLanes(D())];
  StorePack(r.reach2, d, lanes[0]);
  StorePack(Mul(r.distance, SetPack(d, f.unscale)), d, lanes[1]);
  Mend(x, y, lanes[0], lanes[1], kParts * hn::Lanes(d), 0x1p36f, distance, exact);
}

void DistancesEllipse(const Ellipse& ellipse, const EllipseFrame<float>& frame, const float* x,
                      const float* y, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const auto exact = [&](float px, float py) { return distance(ellipse, {px, py}); };
  const auto far = [&](const float* at_x, const float* at_y, float* distance) {
    MendFarFromEllipse(d, frame, at_x, at_y, distance, exact);
  };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto r = FromEllipse(d, f, LoadPack(d, at_x), LoadPack(d, at_y));
    return CloseOrFar(d, at_x, at_y, r.reach2, Mul(r.distance, SetPack(d, f.unscale)), far);
  });
}

void DistancesParabola(const ParabolaSide& side, const ParabolaFrame<float>& frame, const float* x,
                       const float* y, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const auto exact = [&](float px, float py) { return distance(side, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto r = FromParabola(d, f, LoadPack(d, at_x), LoadPack(d, at_y));
    return Checked(d, at_x, at_y, r.reach2, 0x1p48f, Mul(r.distance, SetPack(d, f.unscale)), exact);
  });
}

void DistancesEllipseDouble(const Ellipse& ellipse, const EllipseFrame<double>& frame,
                            const double* x, const double* y, size_t count, double* out) {
  const hn::ScalableTag<double> d;
  const auto exact = [&](double px, double py) { return distance(ellipse, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const double* at_x, const double* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto r = FromEllipse(d, f, LoadPack(d, at_x), LoadPack(d, at_y));
    const auto distance = Mul(r.distance, SetPack(d, f.unscale));
    return Checked(d, at_x, at_y, r.reach2, kFar<double>, distance, exact);
  });
}

void DistancesParabolaDouble(const ParabolaSide& side, const ParabolaFrame<double>& frame,
                             const double* x, const double* y, size_t count, double* out) {
  const hn::ScalableTag<double> d;
  const auto exact = [&](double px, double py) { return distance(side, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const double* at_x, const double* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto r = FromParabola(d, f, LoadPack(d, at_x), LoadPack(d, at_y));
    const auto distance = Mul(r.distance, SetPack(d, f.unscale));
    return Checked(d, at_x, at_y, r.reach2, kFar<double>, distance, exact);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/lanes/one_by_one.h"

namespace mien {
namespace batch {
HWY_EXPORT(DistancesEllipse);
HWY_EXPORT(DistancesParabola);
HWY_EXPORT(DistancesEllipseDouble);
HWY_EXPORT(DistancesParabolaDouble);
}  // namespace batch

void distances(const Ellipse& ellipse, std::span<const float> x, std::span<const float> y,
               std::span<float> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesEllipse), batch::ellipse_frame<float>(ellipse),
                      ellipse, x, y, d);
}

void distances(const ParabolaSide& side, std::span<const float> x, std::span<const float> y,
               std::span<float> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesParabola), batch::parabola_frame<float>(side), side, x,
                      y, d);
}

void distances(const Ellipse& ellipse, std::span<const double> x, std::span<const double> y,
               std::span<double> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesEllipseDouble), batch::ellipse_frame<double>(ellipse),
                      ellipse, x, y, d);
}

void distances(const ParabolaSide& side, std::span<const double> x, std::span<const double> y,
               std::span<double> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesParabolaDouble), batch::parabola_frame<double>(side),
                      side, x, y, d);
}

}  // namespace mien
#endif
