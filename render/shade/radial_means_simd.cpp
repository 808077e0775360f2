// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/radial_means_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/radial_means.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cstddef>
#include <glm/geometric.hpp>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// No fused steps: the same bits on every machine.
void RadialMeans(const PaintField& field, double x, double y, double variance, const float* dx,
                 const float* dy, int count, float* t) {
  const hn::CappedTag<double, 8> d;
  const hn::Rebind<float, decltype(d)> singles;
  const auto set = [&](double v) HWY_ATTR { return hn::Set(d, v); };
  const auto both = [&](auto a, auto b, auto u, auto v)
                        HWY_ATTR { return hn::Add(hn::Mul(a, u), hn::Mul(b, v)); };
  const glm::dmat2& unit = field.unit;
  const double trace = glm::dot(unit[0], unit[0]) + glm::dot(unit[1], unit[1]);
  const auto ax = set(unit[0].x), ay = set(unit[0].y), bx = set(unit[1].x), by = set(unit[1].y);
  for (size_t i = 0; i < size_t(count); i += hn::Lanes(d)) {
    const auto at = [&](double from, const float* by_so_much, double center) HWY_ATTR {
      const auto so_much = hn::PromoteTo(d, hn::LoadU(singles, by_so_much + i));
      return hn::Sub(hn::Add(set(from), so_much), set(center));
    };
    const auto u = at(x, dx, field.center.x), v = at(y, dy, field.center.y);
    const auto qx = both(ax, bx, u, v), qy = both(ay, by, u, v);
    const auto gx = both(ax, ay, qx, qy), gy = both(bx, by, qx, qy);
    const auto tt = both(qx, qy, qx, qy);
    const auto grown = hn::Div(both(gx, gy, gx, gy), hn::Max(tt, set(1e-30)));
    const auto bends = hn::Mul(set(variance), hn::Sub(set(trace), grown));
    const auto mean = hn::Sqrt(hn::Max(hn::Add(tt, bends), hn::Zero(d)));
    hn::StoreU(hn::DemoteTo(singles, mean), singles, t + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(RadialMeans);
}  // namespace batch

void radial_means(const PaintField& field, glm::dvec2 p, double variance, const float* dx,
                  const float* dy, int count, float* t) {
  MIEN_DISPATCH(RadialMeans)(field, p.x, p.y, variance, dx, dy, count, t);
}

}  // namespace mien
#endif
