// The batch functions of sdf/distance/distance.h for cubic Béziers, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/cubic_bezier/cubic_bezier_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/cubic_bezier/cubic_bezier-inl.h"
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
HWY_INLINE void DistancesCubic(const CubicBezier& curve, const CubicFrame<T>& frame, const T* x,
                               const T* y, size_t count, T* out) {
  const hn::ScalableTag<T> d;
  const auto exact = [&](T px, T py) { return distance(curve, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const T* at_x, const T* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    return DistanceOf(d, at_x, at_y, CubicSquare(d, f, at_x, at_y), f.unscale, exact);
  });
}

void DistancesCubicFloat(const CubicBezier& curve, const CubicFrame<float>& frame, const float* x,
                         const float* y, size_t count, float* out) {
  DistancesCubic(curve, frame, x, y, count, out);
}
void DistancesCubicDouble(const CubicBezier& curve, const CubicFrame<double>& frame,
                          const double* x, const double* y, size_t count, double* out) {
  DistancesCubic(curve, frame, x, y, count, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/lanes/one_by_one.h"

namespace mien {
namespace batch {
HWY_EXPORT(DistancesCubicFloat);
HWY_EXPORT(DistancesCubicDouble);
}  // namespace batch

void distances(const CubicBezier& curve, std::span<const float> x, std::span<const float> y,
               std::span<float> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesCubicFloat), batch::cubic_frame<float>(curve), curve,
                      x, y, d);
}

void distances(const CubicBezier& curve, std::span<const double> x, std::span<const double> y,
               std::span<double> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesCubicDouble), batch::cubic_frame<double>(curve), curve,
                      x, y, d);
}

}  // namespace mien
#endif
