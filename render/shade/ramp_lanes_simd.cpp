// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp_lanes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/ramp_lanes.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;

void RadialPlaces(const RadialLanes& radial, int count, float* t) {
  const D d;
  const auto set = [&](float v) HWY_ATTR { return hn::Set(d, v); };
  const auto sx = set(radial.sx), sy = set(radial.sy);
  for (int i = 0; i < count; i += int(hn::Lanes(d))) {
    const auto step = hn::Iota(d, float(radial.from + i));
    const auto px = Fused(sx, step, set(radial.qx)), py = Fused(sy, step, set(radial.qy));
    const auto tt = Fused(px, px, hn::Mul(py, py));
    const auto gx = Fused(set(radial.ax), px, hn::Mul(set(radial.ay), py));
    const auto gy = Fused(set(radial.bx), px, hn::Mul(set(radial.by), py));
    const auto grown = hn::Div(Fused(gx, gx, hn::Mul(gy, gy)), hn::Max(tt, set(1e-30f)));
    const auto bends = hn::Sub(set(radial.trace), grown);
    hn::StoreU(hn::Sqrt(hn::Max(Fused(set(radial.variance), bends, tt), hn::Zero(d))), d, t + i);
  }
}

void LayRamp(const RampLanes& ramp, const float* t, int count, float* r, float* g, float* b,
             float* a) {
  const D d;
  const auto set = [&](float v) HWY_ATTR { return hn::Set(d, v); };
  for (size_t i = 0; i < size_t(count); i += hn::Lanes(d)) {
    const auto at = hn::Min(hn::Max(hn::LoadU(d, t + i), set(ramp.from)), set(ramp.to));
    const auto keep = hn::Sub(set(1.0f), Fused(set(ramp.slope[3]), at, set(ramp.at[3])));
    const auto lay = [&](float* plane, int k) HWY_ATTR {
      const auto own = Fused(set(ramp.slope[k]), at, set(ramp.at[k]));
      hn::StoreU(Fused(hn::LoadU(d, plane + i), keep, own), d, plane + i);
    };
    lay(r, 0), lay(g, 1), lay(b, 2), lay(a, 3);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(RadialPlaces);
HWY_EXPORT(LayRamp);
}  // namespace batch

void radial_places(const RadialLanes& radial, int count, float* t) {
  MIEN_DISPATCH(RadialPlaces)(radial, count, t);
}

void lay_ramp(const RampLanes& ramp, const float* t, int count, float* r, float* g, float* b,
              float* a) {
  MIEN_DISPATCH(LayRamp)(ramp, t, count, r, g, b, a);
}

}  // namespace mien
#endif
