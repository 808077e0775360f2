// Feet on spines at many places at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/nearest/near_feet_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/nearest/foot_form-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE VF Curve(VF t, float c0, float c1, float c2) {
  return Fused(t, Fused(t, Const(c2), Const(c1)), Const(c0));
}

/// |B(t) − p| − w(t).
template <bool kStroke>
HWY_INLINE VF KeyAt(const Spine<float>& s, VF x, VF y, VF t) {
  const VF ex = hn::Sub(Curve(t, s.x0, s.x1, s.x2), x), ey = hn::Sub(Curve(t, s.y0, s.y1, s.y2), y);
  const VF r = hn::Sqrt(Fused(ex, ex, hn::Mul(ey, ey)));
  return kStroke ? hn::Sub(r, Curve(t, s.w0, s.w1, s.w2)) : r;
}

/// Newton's method for the zero of ½ (|B − p|²)' − w' |B − p|, kept within `reach` of where it began. Four steps:
/// samples are a third of the tile's radius apart, so the first guess is within a sixth, and errors fall as their square.
template <bool kStroke>
HWY_INLINE VF Descended(const Spine<float>& s, VF x, VF y, VF t, float reach) {
  const VF zero = hn::Zero(F()), one = Const(1.0f);
  const VF least = hn::Max(hn::Sub(t, Const(reach)), zero);
  const VF most = hn::Min(hn::Add(t, Const(reach)), one);
  for (int i = 0; i < 4; ++i) {
    const VF ex = hn::Sub(Curve(t, s.x0, s.x1, s.x2), x);
    const VF ey = hn::Sub(Curve(t, s.y0, s.y1, s.y2), y);
    const VF gx = Fused(t, Const(2.0f * s.x2), Const(s.x1));
    const VF gy = Fused(t, Const(2.0f * s.y2), Const(s.y1));
    const VF speed2 = Fused(gx, gx, hn::Mul(gy, gy)), along = Fused(ex, gx, hn::Mul(ey, gy));
    VF slope = along;
    VF rise = Fused(ex, Const(2.0f * s.x2), Fused(ey, Const(2.0f * s.y2), speed2));
    if (kStroke) {
      const VF r = hn::Sqrt(Fused(ex, ex, Fused(ey, ey, Const(1e-12f))));
      const VF rate = Fused(t, Const(2.0f * s.w2), Const(s.w1));
      slope = FusedFrom(rate, r, slope);
      rise = FusedFrom(Const(2.0f * s.w2), r, rise);
      rise = hn::Sub(rise, hn::Div(hn::Mul(rate, along), r));
    }
    rise = hn::Max(rise, Fused(speed2, Const(0.05f), Const(1e-20f)));
    t = hn::Min(hn::Max(hn::Sub(t, hn::Div(slope, rise)), least), most);
  }
  return t;
}

struct Foot {
  VF key, t;
};

/// A disc that holds the places of a vector.
struct Around {
  VF x, y, away;
};

HWY_INLINE Around AroundOf(VF x, VF y) {
  const F f;
  const VF half = Const(0.5f);
  const VF mx = hn::Mul(half, hn::Add(hn::MinOfLanes(f, x), hn::MaxOfLanes(f, x)));
  const VF my = hn::Mul(half, hn::Add(hn::MinOfLanes(f, y), hn::MaxOfLanes(f, y)));
  const VF dx = hn::Sub(x, mx), dy = hn::Sub(y, my);
  return {mx, my, hn::Sqrt(hn::MaxOfLanes(f, Fused(dx, dx, hn::Mul(dy, dy))))};
}

struct SampleRange {
  int first, last;
  float least;  ///< how near the spine may come to the disc's middle
};

/// Which samples can be near a place of the disc: those no farther from its middle than the nearest sample by more than
/// the width of the disc, and their neighbours.
template <bool kStroke>
HWY_INLINE SampleRange SamplesAround(const NearSpine& near, const Around& around) {
  const F f;
  HWY_ALIGN float key[NearSpine::kMostSamples + hn::MaxLanes(F())] = {};
  const VF iota = hn::Iota(f, 0.0f);
  for (int i = 0; i < near.samples; i += int(hn::Lanes(f))) {
    const VF t = Fused(hn::Add(iota, Const(float(i))), Const(near.step), Const(near.first));
    hn::StoreU(KeyAt<kStroke>(near.spine, around.x, around.y, t), f, key + i);
  }
  float least = key[0];
  for (int i = 1; i < near.samples; ++i) least = HWY_MIN(least, key[i]);
  const float most = least + 2.0f * hn::GetLane(around.away) + near.apart;
  int first = 0, last = near.samples - 1;
  while (key[first] > most) ++first;
  while (key[last] > most) --last;
  return {HWY_MAX(first - 1, 0), HWY_MIN(last + 1, near.samples - 1), least - near.apart};
}

HWY_INLINE Foot FootOnLine(const Spine<float>& s, VF x, VF y) {
  const VF ex = hn::Sub(x, Const(s.x0)), ey = hn::Sub(y, Const(s.y0));
  const float over = 1.0f / HWY_MAX(s.x1 * s.x1 + s.y1 * s.y1, 1e-20f);
  const VF along = Fused(ex, Const(s.x1), hn::Mul(ey, Const(s.y1)));
  const VF t = hn::Min(hn::Max(hn::Mul(along, Const(over)), hn::Zero(F())), Const(1.0f));
  return {KeyAt<false>(s, x, y, t), t};
}

/// The nearest place of one spine.
template <bool kStroke>
HWY_INLINE Foot FootOn(const NearSpine& near, const SampleRange& samples, VF x, VF y) {
  const Spine<float>& s = near.spine;
  if (near.line) return FootOnLine(s, x, y);
  const VF far = Const(1e30f);
  VF best = far, at = Const(near.first);
  // The second: a sample no farther than both its neighbours, not beside the best.
  VF second = far, second_at = at, before = far, here = far;
  for (int i = samples.first; i <= samples.last + 1; ++i) {
    const VF next =
        i <= samples.last ? KeyAt<kStroke>(s, x, y, Const(near.first + float(i) * near.step)) : far;
    const VF mid = Const(near.first + float(i - 1) * near.step);  // where `here` is
    const auto valley = hn::And(hn::Le(here, before), hn::Lt(here, next));
    const auto better = hn::And(valley, hn::Lt(here, best));
    const auto other = hn::And(valley, hn::And(hn::Ge(here, best), hn::Lt(here, second)));
    second = hn::IfThenElse(better, best, hn::IfThenElse(other, here, second));
    second_at = hn::IfThenElse(better, at, hn::IfThenElse(other, mid, second_at));
    best = hn::IfThenElse(better, here, best), at = hn::IfThenElse(better, mid, at);
    before = here, here = next;
  }
  const float reach = near.samples > 1 ? 1.01f * near.step : 1.0f;
  at = Descended<kStroke>(s, x, y, at, reach);
  best = KeyAt<kStroke>(s, x, y, at);
  if (near.single || hn::AllTrue(F(), hn::Ge(second, far))) return {best, at};
  second_at = Descended<kStroke>(s, x, y, second_at, reach);
  second = KeyAt<kStroke>(s, x, y, second_at);
  const auto nearer = hn::Lt(second, best);
  return {hn::IfThenElse(nearer, second, best), hn::IfThenElse(nearer, second_at, at)};
}

constexpr float kOnSpine = 1.0f;  // [px] B is right to some 5e-5

/// The unit normal at an inner foot, by B' and w' alone: n · B' = −w', as at every such foot. Close to the spine q
/// is all rounding, but `side`, B' × q, still says on which hand n lies.
HWY_INLINE Direction NormalOnSpine(VF gx, VF gy, VF rate, VF side) {
  const F f;
  const VF speed2 = hn::Max(Fused(gx, gx, hn::Mul(gy, gy)), Const(1e-20f));
  const VF over = hn::Div(Const(1.0f), speed2), along = hn::Neg(hn::Mul(rate, over));
  const VF left = hn::Max(FusedFrom(rate, rate, speed2), hn::Zero(f));
  const VF across = hn::CopySign(hn::Mul(hn::Sqrt(left), over), side);
  return {FusedFrom(across, gy, hn::Mul(along, gx)), Fused(across, gx, hn::Mul(along, gy))};
}

/// The outline's own outward normal at a foot on a path's side: the side's, or at an end the mean of it and the next's.
HWY_INLINE Direction OutwardOf(const Spine<float>& s, VF gx, VF gy, VF t) {
  const F f;
  const VF one = Const(1.0f);
  const auto inner = hn::And(hn::Gt(t, hn::Zero(f)), hn::Lt(t, one)), end = hn::Ge(t, one);
  const VF speed2 = Fused(gx, gx, hn::Mul(gy, gy));
  const VF by = hn::Div(Const(s.side), hn::Sqrt(hn::Max(speed2, Const(1e-20f))));
  return {
      hn::IfThenElse(inner, hn::Mul(by, gy), hn::IfThenElse(end, Const(s.end_x), Const(s.begin_x))),
      hn::IfThenElse(inner, hn::Neg(hn::Mul(by, gx)),
                     hn::IfThenElse(end, Const(s.end_y), Const(s.begin_y)))};
}

/// With q = p − B = r n, s = |B'|-part across n and h = n · B'' + w'': the foot moves so that the gradient turns by
/// −h / (s² − r h) per length of level line; 1 / r where the foot is an end. At a path's side n may be the outline's
/// own normal, which holds at r = 0 too.
template <bool kStroke>
HWY_INLINE FootForm FormOf(const Spine<float>& s, VF x, VF y, VF t, VF key) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f);
  const VF qx = hn::Sub(x, Curve(t, s.x0, s.x1, s.x2)), qy = hn::Sub(y, Curve(t, s.y0, s.y1, s.y2));
  const VF gx = Fused(t, Const(2.0f * s.x2), Const(s.x1));
  const VF gy = Fused(t, Const(2.0f * s.y2), Const(s.y1));
  const auto inner = hn::And(hn::Gt(t, zero), hn::Lt(t, one));
  const VF r2 = Fused(qx, qx, hn::Mul(qy, qy)), r = hn::Sqrt(hn::Max(r2, Const(1e-16f)));
  const VF over_r = hn::Div(one, r);
  VF nx = hn::Mul(qx, over_r), ny = hn::Mul(qy, over_r), d = key, sign = one;
  if (!kStroke) {
    const Direction out = OutwardOf(s, gx, gy, t);
    const VF across = Fused(qx, out.x, hn::Mul(qy, out.y));
    sign = hn::IfThenElse(hn::Lt(across, zero), Const(-1.0f), one);
    // At an end itself only the outline's normal gives a direction; elsewhere the line to the foot is exact.
    const auto own = hn::Or(inner, hn::Lt(r, Const(1e-3f)));
    nx = hn::IfThenElse(own, hn::Mul(out.x, sign), nx);
    ny = hn::IfThenElse(own, hn::Mul(out.y, sign), ny);
    d = hn::Mul(sign, key);
  }
  if (kStroke) {
    const VF rate = Fused(t, Const(2.0f * s.w2), Const(s.w1));
    const auto near = hn::And(inner, hn::Lt(r, Const(kOnSpine)));
    const Direction on = NormalOnSpine(gx, gy, rate, hn::Sub(hn::Mul(gx, qy), hn::Mul(gy, qx)));
    nx = hn::IfThenElse(near, on.x, nx), ny = hn::IfThenElse(near, on.y, ny);
  }
  const VF cross = hn::Sub(hn::Mul(nx, gy), hn::Mul(ny, gx)), s2 = hn::Mul(cross, cross);
  VF h = hn::Mul(Const(2.0f), Fused(nx, Const(s.x2), hn::Mul(ny, Const(s.y2))));
  if (kStroke) h = hn::Add(h, Const(2.0f * s.w2));
  const VF turn = hn::Max(FusedFrom(r, h, s2), Fused(s2, Const(0.01f), Const(1e-20f)));
  const VF bend = hn::IfThenElse(inner, hn::Neg(hn::Div(h, turn)), over_r);
  const VF held = hn::Min(hn::Max(bend, Const(-4.0f)), Const(4.0f));
  return {d, hn::Mul(sign, nx), hn::Mul(sign, ny), hn::Mul(sign, held)};
}

/// A spine that can be nearest somewhere in a disc, and its samples around there.
struct Chosen {
  const NearSpine* near;
  SampleRange samples;
};
constexpr int kMostChosen = 24;

/// Chooses those of a disc: none farther than the nearest by more than the disc is wide. Returns their number, −1
/// if they are too many.
template <bool kStroke>
HWY_INLINE int Choose(std::span<const NearSpine> spines, const Around& around, Chosen* chosen) {
  const float away = hn::GetLane(around.away);
  const float x = hn::GetLane(around.x), y = hn::GetLane(around.y);
  const float from_middle = std::sqrt(x * x + y * y);
  float best = 1e30f;
  int count = 0;
  const auto kept = [&] {
    int left = 0;
    for (int i = 0; i < count; ++i)
      if (chosen[i].samples.least <= best + 2.0f * away) chosen[left++] = chosen[i];
    return left;
  };
  for (const NearSpine& near : spines) {
    if (near.least - from_middle > best + 2.0f * away) break;
    const SampleRange samples = SamplesAround<kStroke>(near, around);
    best = HWY_MIN(best, samples.least + near.apart);
    if (samples.least > best + 2.0f * away) continue;
    if (count == kMostChosen) count = kept();
    if (count == kMostChosen) return -1;
    chosen[count++] = {&near, samples};
  }
  return kept();
}

/// Takes the foot on one more spine where it is nearer.
template <bool kStroke>
HWY_INLINE void Take(const NearSpine& near, const SampleRange& samples, VF x, VF y, VF& best,
                     FootForm& form) {
  const Foot foot = FootOn<kStroke>(near, samples, x, y);
  const auto nearer = hn::Lt(foot.key, best);
  if (hn::AllFalse(F(), nearer)) return;
  const FootForm other = FormOf<kStroke>(near.spine, x, y, foot.t, foot.key);
  best = hn::IfThenElse(nearer, foot.key, best);
  form.d = hn::IfThenElse(nearer, other.d, form.d);
  form.nx = hn::IfThenElse(nearer, other.nx, form.nx);
  form.ny = hn::IfThenElse(nearer, other.ny, form.ny);
  form.bend = hn::IfThenElse(nearer, other.bend, form.bend);
}

template <bool kStroke>
HWY_INLINE FootForm Nearest(std::span<const NearSpine> spines, VF x, VF y) {
  VF best = Const(1e30f);
  FootForm form{best, Const(1.0f), hn::Zero(F()), hn::Zero(F())};
  const Around around = AroundOf(x, y);
  const float away = hn::GetLane(around.away);
  const VF from_middle =
      hn::Add(hn::Sqrt(Fused(around.x, around.x, hn::Mul(around.y, around.y))), around.away);
  for (const NearSpine& near : spines) {
    if (hn::AllTrue(F(), hn::Lt(best, hn::Sub(Const(near.least), from_middle)))) break;
    const SampleRange samples = SamplesAround<kStroke>(near, around);
    if (hn::AllTrue(F(), hn::Lt(best, Const(samples.least - away)))) continue;
    Take<kStroke>(near, samples, x, y, best, form);
  }
  return form;
}

/// A disc that holds all places.
Around AroundAll(std::span<const float> x, std::span<const float> y) {
  const F f;
  VF low_x = Const(x[0]), high_x = low_x, low_y = Const(y[0]), high_y = low_y;
  for (size_t k = 0; k < x.size(); k += hn::Lanes(f)) {
    const VF px = hn::LoadU(f, x.data() + k), py = hn::LoadU(f, y.data() + k);
    low_x = hn::Min(low_x, px), high_x = hn::Max(high_x, px);
    low_y = hn::Min(low_y, py), high_y = hn::Max(high_y, py);
  }
  const VF half = Const(0.5f);
  const VF x0 = hn::MinOfLanes(f, low_x), x1 = hn::MaxOfLanes(f, high_x);
  const VF y0 = hn::MinOfLanes(f, low_y), y1 = hn::MaxOfLanes(f, high_y);
  const VF wide = hn::Mul(half, hn::Sub(x1, x0)), high = hn::Mul(half, hn::Sub(y1, y0));
  return {hn::Mul(half, hn::Add(x0, x1)), hn::Mul(half, hn::Add(y0, y1)),
          hn::Sqrt(Fused(wide, wide, hn::Mul(high, high)))};
}

template <bool kStroke>
void FeetOn(std::span<const NearSpine> spines, std::span<const float> x, std::span<const float> y,
            const Feet& out) {
  const F f;
  constexpr float kSmall = 1.5f;  // [px]: so wide a disc is looked around once for all its places
  const Around around = AroundAll(x, y);
  Chosen chosen[kMostChosen];
  const int count =
      hn::GetLane(around.away) < kSmall ? Choose<kStroke>(spines, around, chosen) : -1;
  for (size_t k = 0; k < x.size(); k += hn::Lanes(f)) {
    const VF px = hn::LoadU(f, x.data() + k), py = hn::LoadU(f, y.data() + k);
    VF best = Const(1e30f);
    FootForm form{best, Const(1.0f), hn::Zero(f), hn::Zero(f)};
    if (count < 0)
      form = Nearest<kStroke>(spines, px, py);
    else
      for (int i = 0; i < count; ++i)
        Take<kStroke>(*chosen[i].near, chosen[i].samples, px, py, best, form);
    StoreForm(form, out, k);
  }
}

void SpineFeet(std::span<const NearSpine> spines, bool stroke, std::span<const float> x,
               std::span<const float> y, const Feet& out) {
  if (stroke)
    FeetOn<true>(spines, x, y, out);
  else
    FeetOn<false>(spines, x, y, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(SpineFeet);
}  // namespace batch

void spine_feet(std::span<const NearSpine> spines, bool stroke, std::span<const float> x,
                std::span<const float> y, const Feet& out) {
  MIEN_DISPATCH(SpineFeet)(spines, stroke, x, y, out);
}

}  // namespace mien
#endif
