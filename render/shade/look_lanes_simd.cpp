// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/look_lanes_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/look_lanes.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <algorithm>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;

struct LaneColor {
  V r, g, b, a;
};

HWY_INLINE LaneColor AllOf(const std::array<float, 4>& c) {
  const D d;
  return {hn::Set(d, c[0]), hn::Set(d, c[1]), hn::Set(d, c[2]), hn::Set(d, c[3])};
}

HWY_INLINE LaneColor LoadColor(const std::array<const float*, 4>& from, size_t i) {
  const D d;
  return {hn::LoadU(d, from[0] + i), hn::LoadU(d, from[1] + i), hn::LoadU(d, from[2] + i),
          hn::LoadU(d, from[3] + i)};
}

HWY_INLINE void StoreColor(const LaneColor& c, const std::array<float*, 4>& to, size_t i) {
  const D d;
  hn::StoreU(c.r, d, to[0] + i), hn::StoreU(c.g, d, to[1] + i);
  hn::StoreU(c.b, d, to[2] + i), hn::StoreU(c.a, d, to[3] + i);
}

HWY_INLINE LaneColor LaidOver(const LaneColor& below, const LaneColor& own) {
  const V keep = hn::Sub(hn::Set(D(), 1.0f), own.a);
  return {Fused(below.r, keep, own.r), Fused(below.g, keep, own.g), Fused(below.b, keep, own.b),
          Fused(below.a, keep, own.a)};
}

HWY_INLINE LaneColor Laid(const LaneColor& below, const LaneColor& own, MixMode mode) {
  if (mode == MixMode::normal) return LaidOver(below, own);
  const V one = hn::Set(D(), 1.0f);
  const V keep = hn::Sub(one, own.a), clear = hn::Sub(one, below.a);
  const auto multiply = [&](V u, V v)
                            HWY_ATTR { return Fused(u, hn::Add(keep, v), hn::Mul(clear, v)); };
  const auto screen = [&](V u, V v) HWY_ATTR { return Fused(u, hn::Sub(one, v), v); };
  if (mode == MixMode::multiply)
    return {multiply(below.r, own.r), multiply(below.g, own.g), multiply(below.b, own.b),
            multiply(below.a, own.a)};
  return {screen(below.r, own.r), screen(below.g, own.g), screen(below.b, own.b),
          screen(below.a, own.a)};
}

HWY_INLINE LaneColor TimesAll(const LaneColor& c, float by) {
  const V v = hn::Set(D(), by);
  return {hn::Mul(c.r, v), hn::Mul(c.g, v), hn::Mul(c.b, v), hn::Mul(c.a, v)};
}

/// A ramp's colour, t counted from where it begins.
HWY_INLINE LaneColor RampColor(const LaneStep& s, V t) {
  const D d;
  const V at = hn::Min(hn::Max(t, hn::Zero(d)), hn::Set(d, s.length));
  const auto channel = [&](size_t k) HWY_ATTR {
    return Fused(hn::Set(d, s.slope[k]), at, hn::Set(d, s.color[k]));
  };
  return {channel(0), channel(1), channel(2), channel(3)};
}

HWY_INLINE V LinearPlace(const LaneStep& s, const LanePlaces& at, size_t i, V x, size_t k) {
  const D d;
  const V row = Fused(hn::Set(d, s.by_y[k]), hn::LoadU(d, at.y + i), hn::Set(d, s.q[k]));
  return Fused(hn::Set(d, s.by_x[k]), x, row);
}

/// Mean t; adds what it neglects.
HWY_INLINE V RadialPlace(const LaneStep& s, const LanePlaces& at, size_t i, V x, V& neglected) {
  const D d;
  const auto set = [&](float v) HWY_ATTR { return hn::Set(d, v); };
  const V qx = LinearPlace(s, at, i, x, 0), qy = LinearPlace(s, at, i, x, 1);
  const V tt = Fused(qx, qx, hn::Mul(qy, qy));
  const V over = hn::Div(set(1.0f), hn::Max(tt, set(1e-30f)));
  const V gx = Fused(set(s.by_x[0]), qx, hn::Mul(set(s.by_x[1]), qy));
  const V gy = Fused(set(s.by_y[0]), qx, hn::Mul(set(s.by_y[1]), qy));
  const V xx = hn::LoadU(d, at.xx + i), xy = hn::LoadU(d, at.xy + i), yy = hn::LoadU(d, at.yy + i);
  const V wide = Fused(xx, set(s.uxx), Fused(xy, set(s.uxy + s.uxy), hn::Mul(yy, set(s.uyy))));
  const V along_x = Fused(xx, gx, hn::Mul(xy, gy)), along_y = Fused(xy, gx, hn::Mul(yy, gy));
  const V along = hn::Mul(Fused(along_x, gx, hn::Mul(along_y, gy)), over);
  neglected = hn::Add(neglected, hn::Min(hn::Mul(over, set(s.neglects)), set(s.most)));
  return hn::Sqrt(hn::Max(hn::Add(tt, hn::Sub(wide, along)), hn::Zero(d)));
}

/// Levels below the current one are in `stack`, four vectors each.
float ShadeLanes(const LaneStep* steps, size_t count, const LanePlaces& at, float* stack,
                 const std::array<float*, 4>& to, float* neglected) {
  const D d;
  const size_t lanes = hn::Lanes(d);
  V worst = hn::Zero(d);
  for (size_t i = 0; i < size_t(at.count); i += lanes) {
    const V column = hn::LoadU(d, at.column + i), dx = hn::LoadU(d, at.x + i);
    const auto x = [&](const LaneStep& s)
                       HWY_ATTR { return hn::Add(hn::Sub(column, hn::Set(d, s.origin)), dx); };
    V off = hn::Zero(d);
    LaneColor color = AllOf({});
    const auto kept = [&](size_t depth) HWY_ATTR {
      float* const p = stack + 4 * lanes * depth;
      return std::array<float*, 4>{p, p + lanes, p + 2 * lanes, p + 3 * lanes};
    };
    size_t open = 0;
    for (const LaneStep* s = steps; s != steps + count; ++s) {
      switch (s->kind) {
        case LaneStep::Kind::open:
          StoreColor(color, kept(open++), 0);
          color = AllOf(s->color);
          break;
        case LaneStep::Kind::over:
          color = Laid(color, AllOf(s->color), s->mode);
          break;
        case LaneStep::Kind::linear:
          color = LaidOver(color, RampColor(*s, LinearPlace(*s, at, i, x(*s), 0)));
          break;
        case LaneStep::Kind::radial: {
          const V t = RadialPlace(*s, at, i, x(*s), off);
          color = LaidOver(color, RampColor(*s, hn::Sub(t, hn::Set(d, s->from))));
          break;
        }
        case LaneStep::Kind::given:
          color = LaidOver(color, LoadColor(s->given, i));
          break;
        case LaneStep::Kind::close: {
          const std::array<float*, 4> p = kept(--open);
          const LaneColor below = LoadColor({p[0], p[1], p[2], p[3]}, 0);
          color = Laid(below, TimesAll(color, s->color[3]), s->mode);
          break;
        }
      }
    }
    StoreColor(color, to, i);
    hn::StoreU(off, d, neglected + i);
    worst = hn::Max(worst, off);
  }
  return hn::GetLane(hn::MaxOfLanes(d, worst));
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(ShadeLanes);
}  // namespace batch

float shade_lanes(const std::vector<LaneStep>& steps, const LanePlaces& at,
                  std::vector<float>& stack, ColorRow& to, std::vector<float>& neglected) {
  const std::size_t room = std::size_t(at.count) + kColorSpare;
  const auto depth = std::count_if(
      steps.begin(), steps.end(), [](const LaneStep& s) { return s.kind == LaneStep::Kind::open; });
  stack.resize(4 * kColorSpare * std::size_t(depth));
  to.room_for(std::size_t(at.count));
  if (neglected.size() < room) neglected.resize(room);
  return MIEN_DISPATCH(ShadeLanes)(steps.data(), steps.size(), at, stack.data(),
                                   {to.r.data(), to.g.data(), to.b.data(), to.a.data()},
                                   neglected.data());
}

}  // namespace mien
#endif
