// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/radial_planes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/ramp/radial_planes.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// With q = U (p − center), t = |q|, and g = Uᵀq / t the mean of t is √(|q|² + variance (tr UᵀU − |g|²)). Along its
/// level line, τ, t bends by |Uτ|² / t, which level lines make up for by 1 / |g|.
void RadialPlanes(const PaintField& field, double scale, double from, const RadialPlaces& at,
                  size_t count, double* planes, float* bends) {
  using D = hn::CappedTag<double, 8>;
  using V = hn::Vec<D>;
  const D d;
  const hn::Rebind<float, D> f;
  const auto set = [&](double v) HWY_ATTR { return hn::Set(d, v); };
  const glm::dmat2& u = field.unit;
  const V ux = set(u[0].x), vx = set(u[0].y), uy = set(u[1].x), vy = set(u[1].y);
  const V trace = set(glm::dot(u[0], u[0]) + glm::dot(u[1], u[1])), least = set(1e-300);
  const auto dot = [](V a, V b, V c, V e) HWY_ATTR { return Fused(a, b, hn::Mul(c, e)); };
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V x = hn::Sub(hn::LoadU(d, &at.x[i]), set(field.center.x)),
            y = hn::Sub(hn::LoadU(d, &at.y[i]), set(field.center.y));
    const V qx = dot(ux, x, uy, y), qy = dot(vx, x, vy, y), tt = dot(qx, qx, qy, qy);
    const V over = hn::Div(set(1.0), hn::Sqrt(hn::Max(tt, least)));
    const V gx = hn::Mul(over, dot(ux, qx, vx, qy)), gy = hn::Mul(over, dot(uy, qx, vy, qy));
    const V steep = dot(gx, gx, gy, gy);
    const V mean = hn::Sqrt(Fused(hn::LoadU(d, &at.variance[i]), hn::Sub(trace, steep), tt));
    const V ax = hn::Sub(hn::Mul(uy, gx), hn::Mul(ux, gy)),
            ay = hn::Sub(hn::Mul(vy, gx), hn::Mul(vx, gy));
    const V bend = dot(ax, ax, ay, ay);
    const V below = hn::Mul(hn::Mul(tt, steep), hn::Mul(steep, steep));
    const V squared = hn::Min(hn::Div(hn::Mul(bend, bend), hn::Max(below, least)), set(1e30));
    hn::StoreU(hn::DemoteTo(f, squared), f, bends + i);
    hn::StoreInterleaved3(hn::Mul(hn::Sub(mean, set(from)), set(scale)), hn::Mul(gx, set(scale)),
                          hn::Mul(gy, set(scale)), d, planes + 3 * i);
  }
}

void BendExcesses(const BendRule& rule, const float* bends, const ColorRow& colors, size_t count,
                  float* to) {
  using D = hn::CappedTag<float, 16>;
  using V = hn::Vec<D>;
  const D d;
  const auto set = [&](double v) HWY_ATTR { return hn::Set(d, float(v)); };
  // Linear light v is encoded as steeply as 0.72 / √v at most, and no more than 6 counts.
  const auto steep = [&](V v) HWY_ATTR {
    return rule.linear ? hn::Min(hn::Div(set(0.5184), hn::Max(v, set(1e-6))), set(36.0)) : set(1.0);
  };
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const V bend = hn::LoadU(d, bends + i);
    const V off = hn::Mul(set(BendRule::kLeft), hn::Sqrt(bend));
    const auto channel = [&](const std::vector<float>& from, int c) HWY_ATTR {
      return hn::Sub(hn::LoadU(d, &from[i]), hn::Mul(off, set(rule.range[c])));
    };
    const V clear = hn::Sub(set(1.0), hn::LoadU(d, &colors.a[i]));
    V most = hn::Zero(d);
    for (int c = 0; c < 3; ++c) {
      const V v = hn::Max(channel(c == 0   ? colors.r
                                  : c == 1 ? colors.g
                                           : colors.b,
                                  c),
                          set(rule.least[c]));
      most = hn::Max(most, hn::Mul(set(rule.dark[c] * rule.dark[c]), steep(v)));
      most = hn::Max(most, hn::Mul(set(rule.light[c] * rule.light[c]), steep(hn::Add(v, clear))));
    }
    hn::StoreU(hn::Mul(bend, most), d, to + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(RadialPlanes);
HWY_EXPORT(BendExcesses);
}  // namespace batch

BendRule::BendRule(const RampIntegral& ramp, double tolerance, bool in_linear)
    : range(ramp.most() - ramp.least()), least(ramp.least()), linear(in_linear) {
  dark = kLeft / tolerance * range;
  light = range.a > 0.0 ? glm::max(dark, Mix{dark.a}) : Mix{0.0};
}

void add_radial_planes(const PaintField& field, const RampIntegral& ramp, RadialPlaces& at,
                       std::vector<RampPlane>& planes, std::vector<float>& bends_squared) {
  const std::size_t count = at.x.size(), room = count + kColorSpare, before = planes.size();
  at.x.resize(room), at.y.resize(room), at.variance.resize(room);
  planes.resize(before + room), bends_squared.resize(room);
  const RampPlane none = ramp.scaled({0.0, 1.0, 0.0});  // (t − from) scale
  MIEN_DISPATCH(RadialPlanes)
  (field, none.gx, -none.t / none.gx, at, count, &planes[before].t, bends_squared.data());
  planes.resize(before + count), bends_squared.resize(count);
  at.clear();
}

void bend_excesses(const BendRule& rule, std::vector<float>& bends_squared, const ColorRow& colors,
                   std::vector<float>& to) {
  const std::size_t count = bends_squared.size(), room = count + kColorSpare;
  bends_squared.resize(room), to.resize(room);
  MIEN_DISPATCH(BendExcesses)(rule, bends_squared.data(), colors, count, to.data());
}

}  // namespace mien
#endif
