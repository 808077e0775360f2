// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cover/part_moments_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/cover/part_moments.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <algorithm>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// ∫ f dy of (1/4 − x²)/2, y (1/2 − x), (1/8 − x³)/3, y (1/4 − x²)/2, y² (1/2 − x), y and y² down each.
void Moments(const PartStretch* from, size_t count, PartMoments& to) {
  const hn::CappedTag<float, 16> d;
  const hn::RebindToSigned<decltype(d)> di;
  constexpr int kStride = int(sizeof(PartStretch) / sizeof(float));
  static constexpr float kPlaces[] = {0.069431844f, 0.330009478f, 0.669990522f, 0.930568156f},
                         kWeights[] = {0.173927423f, 0.326072577f, 0.326072577f, 0.173927423f};
  const auto set = [&](float v) HWY_ATTR { return hn::Set(d, v); };
  const auto last = hn::Set(di, int(count) - 1);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto at = hn::Mul(hn::Min(hn::Iota(di, int(i)), last), hn::Set(di, kStride));
    const auto get = [&](const float* field)
                         HWY_ATTR { return hn::Sub(hn::GatherIndex(d, field, at), set(0.5f)); };
    const auto xp = get(&from->xp), yp = get(&from->yp), xm = get(&from->xm), ym = get(&from->ym),
               xq = get(&from->xq), yq = get(&from->yq);
    // Through both ends and the middle: p + u (slope + u · bend).
    const auto bend = [&](auto p, auto m, auto q) HWY_ATTR {
      return Fused(set(-4.0f), m, hn::Add(hn::Add(p, q), hn::Add(p, q)));
    };
    const auto x2 = bend(xp, xm, xq), y2 = bend(yp, ym, yq);
    const auto x1 = hn::Sub(hn::Sub(xq, xp), x2), y1 = hn::Sub(hn::Sub(yq, yp), y2);
    auto x = hn::Zero(d), y = x, xx = x, xy = x, yy = x, rest_y = x, rest_yy = x;
    for (size_t k = 0; k < 4; ++k) {
      const auto u = set(kPlaces[k]);
      const auto px = Fused(u, Fused(u, x2, x1), xp), py = Fused(u, Fused(u, y2, y1), yp);
      const auto dy = hn::Mul(set(kWeights[k]), Fused(hn::Add(u, u), y2, y1));
      const auto wide = hn::Mul(dy, hn::Sub(set(0.5f), px)), px2 = hn::Mul(px, px);
      const auto more = hn::Mul(dy, hn::Mul(set(0.5f), hn::Sub(set(0.25f), px2)));
      const auto tall = hn::Mul(dy, py);
      x = hn::Add(x, more), y = Fused(wide, py, y);
      xx = Fused(hn::Mul(dy, set(1.0f / 3)), hn::Sub(set(0.125f), hn::Mul(px2, px)), xx);
      xy = Fused(more, py, xy), yy = Fused(hn::Mul(wide, py), py, yy);
      rest_y = hn::Add(rest_y, tall), rest_yy = Fused(tall, py, rest_yy);
    }
    const auto put = [&](std::vector<float>& plane, auto v)
                         HWY_ATTR { hn::StoreU(v, d, plane.data() + i); };
    put(to.x, x), put(to.y, y), put(to.xx, xx), put(to.xy, xy), put(to.yy, yy);
    put(to.rest_y, rest_y), put(to.rest_yy, rest_yy);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(Moments);
}  // namespace batch

void PartMoments::make(std::span<const PartStretch> stretches) {
  constexpr std::size_t kSpare = 16;
  const std::size_t room = stretches.size() + kSpare;
  for (std::vector<float>* plane : {&x, &y, &xx, &xy, &yy, &rest_y, &rest_yy})
    if (plane->size() < room) plane->resize(room);
  if (!stretches.empty()) MIEN_DISPATCH(Moments)(stretches.data(), stretches.size(), *this);
}

}  // namespace mien
#endif
