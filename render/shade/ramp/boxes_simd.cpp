// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/boxes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/ramp/integral.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cmath>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What RampIntegral::box_mean is, step by step and without fused ones, its four channels side by side.
void AddBoxMeans(const RampIntegral& ramp, const RampPlane* planes, int count, double width,
                 double* sum) {
  const hn::CappedTag<double, 4> d;
  const double h = 0.5 * width;
  for (int i = 0; i < count; ++i) {
    const RampPlane& plane = planes[i];
    const double near = RampIntegral::narrow(plane);
    if (!(std::abs(plane.gx) > near && std::abs(width * plane.gy) > near)) {
      const Mix mean = ramp.box_mean(plane, width);
      for (int k = 0; k < 4; ++k) sum[k] += mean[k];
      continue;
    }
    double s[4] = {plane.at(h, -h), plane.at(h, h), plane.at(-h, -h), plane.at(-h, h)};
    const double right = 1.0 / (s[1] - s[0]), left = 1.0 / (s[3] - s[2]), high = (h + h) / plane.gx,
                 over = 1.0 / (width * width);
    const RampIntegral::Piece* pieces[4];
    for (int n = 0; n < 4; ++n) pieces[n] = &ramp.piece(s[n]);
    for (size_t k = 0; k < 4; k += hn::Lanes(d)) {
      const auto second = [&](int n) HWY_ATTR {
        const RampIntegral::Piece& p = *pieces[n];
        const auto at = [&](const Mix& mix) HWY_ATTR { return hn::LoadU(d, &mix[int(k)]); };
        const auto u = hn::Set(d, s[n]);
        const auto bend = hn::Add(hn::Mul(hn::Set(d, 0.5), at(p.value)),
                                  hn::Mul(hn::Set(d, (1.0 / 6.0) * s[n]), at(p.slope)));
        return hn::Add(at(p.second), hn::Mul(u, hn::Add(at(p.first), hn::Mul(u, bend))));
      };
      const auto mean_first = [&](int a, int b, double over_length) HWY_ATTR {
        return hn::Mul(hn::Set(d, over_length), hn::Sub(second(b), second(a)));
      };
      const auto between =
          hn::Mul(hn::Set(d, high), hn::Sub(mean_first(0, 1, right), mean_first(2, 3, left)));
      const auto mean =
          hn::Add(hn::LoadU(d, &ramp.mean()[int(k)]), hn::Mul(hn::Set(d, over), between));
      hn::StoreU(hn::Add(hn::LoadU(d, sum + k), mean), d, sum + k);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(AddBoxMeans);
}  // namespace batch

Mix RampIntegral::sum_of_boxes(std::span<const RampPlane> planes, double width) const {
  Mix sum{0.0};
  MIEN_DISPATCH(AddBoxMeans)(*this, planes.data(), int(planes.size()), width, &sum[0]);
  return sum;
}

}  // namespace mien
#endif
