// Sixteen places of a lit piece: what they see, their colours, and what breaks a mean over them. Included once per
// instruction set.
#if defined(MIEN_RENDER_SHADE_LIT_PLACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LIT_PLACES_INL_H_
#undef MIEN_RENDER_SHADE_LIT_PLACES_INL_H_
#else
#define MIEN_RENDER_SHADE_LIT_PLACES_INL_H_
#endif

#include "render/shade/light/lamp_lanes-inl.h"
#include "render/shade/light/light_tile.h"
#include "render/shade/nearest/near_squares-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// What places see of the relief, and of the distance that the ramp goes by: the relief's own or another.
struct Seen {
  BranchPair relief, other;
  const BranchPair* ramp = &relief;
};

/// What is asked in a square, by node; none: all.
struct Near {
  NearNode *relief = nullptr, *other = nullptr;
};

struct Shades {
  alignas(64) float c[LightTile::kChannels][16];
  alignas(64) float bounds[3][16],
      upper[3][16];  ///< and where two depths are looked at the greater ones
  alignas(64) float foot[16], inside[16];
  alignas(64) float bell[16];  ///< a highlight's peak that two depths may not see
};

/// Which of sixteen places count: all.
alignas(64) inline constexpr float kAll[16] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};

/// Enters a square around (cx, cy), of half a diagonal r.
inline void Enter(const LightTile& tile, const Near& from, float cx, float cy, float r,
                  const Near& to) {
  if (tile.rises) EnterSquare(tile.ground->area, from.relief, cx, cy, r, to.relief);
  if (tile.apart) EnterSquare(tile.ground->gradient, from.other, cx, cy, r, to.other);
}

inline void SeeFrom(const LightTile& tile, const Near& near, float cx, float cy, const float* x,
                    const float* y, Seen& to) {
  if (tile.rises) LookAround(tile.ground->area, near.relief, cx, cy, x, y, to.relief);
  if (!tile.apart) return;
  LookAround(tile.ground->gradient, near.other, cx, cy, x, y, to.other);
  to.ramp = &to.other;
}

/// The nearest ridge of both, as lanes.
struct RidgeLanes {
  VF off, ex, ey;
  hn::Mask<F> of_relief, of_ramp;
};
HWY_INLINE RidgeLanes RidgeAt(const LightTile& tile, const Seen& at, int k) {
  constexpr float kSame = 0.01f;  // [px]
  const F f;
  const auto load = [&](const float* p) HWY_ATTR { return hn::Load(f, p + k); };
  const VF far = Const(BranchPair::kFar);
  const VF relief = tile.rises ? load(at.relief.off) : far;
  const VF ramp = tile.lamp.goes_by_distance() ? load(at.ramp->off) : far;
  RidgeLanes r{hn::Min(relief, ramp), Const(1.0f), hn::Zero(f), hn::Lt(relief, far),
               hn::Lt(ramp, far)};
  const VF same = hn::Add(r.off, Const(kSame));
  r.of_relief = hn::Le(relief, same), r.of_ramp = hn::Le(ramp, same);
  if (tile.lamp.goes_by_distance()) r.ex = load(at.ramp->ex), r.ey = load(at.ramp->ey);
  if (tile.rises) {
    r.ex = hn::IfThenElse(r.of_relief, load(at.relief.ex), r.ex);
    r.ey = hn::IfThenElse(r.of_relief, load(at.relief.ey), r.ey);
  }
  return r;
}

HWY_INLINE void PutColor(const LitColor& color, int k, Shades& to) {
  const F f;
  for (int c = 0; c < LightTile::kChannels; ++c) hn::Store(color.c[c], f, to.c[c] + k);
  for (int b = 0; b < 3; ++b)
    hn::Store(color.bounds[b], f, to.bounds[b] + k), hn::Store(color.bounds[b], f, to.upper[b] + k);
  hn::Store(color.foot, f, to.foot + k), hn::Store(color.inside, f, to.inside + k);
  hn::Store(hn::Zero(f), f, to.bell + k);
}

/// Each place by itself.
inline void ShadePlaces(const LightTile& tile, const Seen& at, const float* px, const float* py,
                        Shades& to) {
  const F f;
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* p) HWY_ATTR { return hn::Load(f, p + k); };
    const VF zero = hn::Zero(f);
    const VF depth = tile.rises ? hn::Neg(load(at.relief.best.d)) : zero;
    const VF nx = tile.rises ? load(at.relief.best.nx) : zero;
    const VF ny = tile.rises ? load(at.relief.best.ny) : zero;
    const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : zero;
    PutColor(LitAt(tile.lamp, depth, nx, ny, hn::LoadU(f, px + k), hn::LoadU(f, py + k), away), k,
             to);
  }
}

HWY_INLINE float LeastOf16(const float* v) {
  const F f;
  VF least = hn::Load(f, v);
  for (int k = int(hn::Lanes(f)); k < 16; k += int(hn::Lanes(f)))
    least = hn::Min(least, hn::Load(f, v + k));
  return hn::GetLane(hn::MinOfLanes(f, least));
}
HWY_INLINE float MostOf16(const float* v) {
  const F f;
  VF most = hn::Load(f, v);
  for (int k = int(hn::Lanes(f)); k < 16; k += int(hn::Lanes(f)))
    most = hn::Max(most, hn::Load(f, v + k));
  return hn::GetLane(hn::MaxOfLanes(f, most));
}

struct Range {
  float low, high;
};
/// Of values at places that count: where `there` is more than 0.
HWY_INLINE Range RangeOf16(const float* v, const float* there) {
  const F f;
  const VF far = hn::Set(f, 1e9f);
  VF low = far, high = hn::Neg(far);
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const VF value = hn::Load(f, v + k);
    const auto counts = hn::Gt(hn::LoadU(f, there + k), hn::Zero(f));
    low = hn::Min(low, hn::IfThenElse(counts, value, far));
    high = hn::Max(high, hn::IfThenElse(counts, value, hn::Neg(far)));
  }
  return {hn::GetLane(hn::MinOfLanes(f, low)), hn::GetLane(hn::MaxOfLanes(f, high))};
}

/// How steeply linear light is encoded where it has that value of the blending space, or a little more.
HWY_INLINE float SteepnessAt(const LightTile& tile, float v) {
  // 1.055 / 2.4 v^(−7/12) is less than 0.72 / √v.
  if (tile.lamp.linear) return HWY_MAX(0.72f / std::sqrt(HWY_MAX(v, 0.0031f)), 0.6f);
  // 1.055 / 2.4 x^(−1.4) with x = (v + 0.055) / 1.055, by a power that is no less.
  const float x = (HWY_MAX(v, 0.0f) + 0.055f) / 1.055f;
  return HWY_MIN(0.44f / (x * std::sqrt(x)), 12.92f);
}

/// What differences of each channel are encoded as, where the channels have these values or more: all tolerances are of
/// encoded values.
struct Encoding {
  float by[LightTile::kChannels];
  float most() const { return HWY_MAX(by[0], HWY_MAX(by[1], by[2])); }
};
inline Encoding EncodingAt(const LightTile& tile, const float* v) {
  Encoding to{{1.0f, 1.0f, 1.0f, 1.0f}};
  if (!tile.lamp.linear) return to;
  for (int c = 0; c < 3; ++c) to.by[c] = SteepnessAt(tile, v[c]);
  // Opacity shows in all of them.
  to.by[3] = HWY_MAX(HWY_MAX(to.by[0], to.by[1]), to.by[2]);
  return to;
}

/// By how much a clamp of the law that begins among places, or as close to them as `margin` of their range, changes
/// colours there: what it takes or leaves, whichever is less; 0 if none begins. `there`: which places count.
HWY_INLINE float KinkAmong(const LightTile& tile, const Shades& s, const float* there,
                           float margin) {
  const LampLanes& lamp = tile.lamp;
  float less[3], most = 0.0f;  // of what is clamped
  for (int b = 0; b < 3; ++b) {
    const Range range{RangeOf16(s.bounds[b], there).low, RangeOf16(s.upper[b], there).high};
    const float beyond = margin * (range.high - range.low);
    const float up = HWY_MAX(range.high + beyond, 0.0f), down = HWY_MAX(beyond - range.low, 0.0f);
    less[b] = b == 1 ? lamp.level_shine * HWY_MIN(std::exp2(up) - 1.0f, 1.0f - std::exp2(-down))
                     : HWY_MIN(up, down);
    most = HWY_MAX(most, less[b]);
  }
  // Beyond a ramp's segment its colours are held: no place of it has them. Floats of places within are off by less.
  constexpr float kBeyond = 1e-4f;
  const float inside = RangeOf16(s.inside, there).low;
  if (most == 0.0f && inside > -kBeyond) return 0.0f;
  // A channel is clamped where it is 1.
  float change = less[2] * SteepnessAt(tile, 1.0f);
  if (inside <= -kBeyond) change = HWY_MAX(change, 1.0f);
  for (int c = 0; c < 3; ++c) {
    const float steep = SteepnessAt(tile, RangeOf16(s.c[c], there).low);
    const float light = lamp.ramp.kind == LampRamp::Kind::none ? lamp.light[size_t(c)] : 1.0f;
    change = HWY_MAX(change, steep * HWY_MAX(lamp.diffuse * light * less[0], lamp.shine * less[1]));
  }
  return change;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
