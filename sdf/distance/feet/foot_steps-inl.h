// A branch's foot: Newton's steps, and where they begin. Included once per instruction set.
#if defined(MIEN_SDF_FOOT_STEPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_FOOT_STEPS_INL_H_
#undef MIEN_SDF_FOOT_STEPS_INL_H_
#else
#define MIEN_SDF_FOOT_STEPS_INL_H_
#endif

#include "sdf/distance/feet/branches.h"
#include "sdf/distance/lanes/depressed_cubic-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;

/// One branch for many places, or many branches for one.
struct BranchLanes {
  VF x0, x1, x2, y0, y1, y2, w0, w1, w2, low, high;
};

HWY_INLINE BranchLanes AllOf(const Branches& b, int k) {
  const F f;
  const auto at = [&](Branches::Row r) HWY_ATTR { return hn::LoadU(f, b.row(r) + k); };
  return {at(Branches::x0), at(Branches::x1),  at(Branches::x2),  at(Branches::y0),
          at(Branches::y1), at(Branches::y2),  at(Branches::w0),  at(Branches::w1),
          at(Branches::w2), at(Branches::low), at(Branches::high)};
}
HWY_INLINE BranchLanes OneOf(const Branches& b, int k) {
  const F f;
  const auto at = [&](Branches::Row r) HWY_ATTR { return hn::Set(f, b.row(r)[k]); };
  return {at(Branches::x0), at(Branches::x1),    at(Branches::x2),  at(Branches::y0),
          at(Branches::y1), at(Branches::y2),    at(Branches::w0),  at(Branches::w1),
          at(Branches::w2), at(Branches::least), at(Branches::most)};
}

/// Where p − B(t) points and how fast B goes there.
struct Reached {
  VF ex, ey;  ///< B − p
  VF gx, gy;  ///< B'
  VF speed2, along;
};
HWY_INLINE Reached ReachedAt(const BranchLanes& c, VF x, VF y, VF t) {
  const F f;
  const VF two = hn::Set(f, 2.0f), tt = hn::Mul(two, t);
  Reached at;
  at.ex = hn::Sub(Fused(t, Fused(t, c.x2, c.x1), c.x0), x);
  at.ey = hn::Sub(Fused(t, Fused(t, c.y2, c.y1), c.y0), y);
  at.gx = Fused(tt, c.x2, c.x1), at.gy = Fused(tt, c.y2, c.y1);
  at.speed2 = Fused(at.gx, at.gx, hn::Mul(at.gy, at.gy));
  at.along = Fused(at.ex, at.gx, hn::Mul(at.ey, at.gy));
  return at;
}

/// f and f', both times |B − p| for strokes.
struct Slope {
  VF value, rise, scale;
};
template <bool kStroke>
HWY_INLINE Slope SlopeAt(const BranchLanes& c, const Reached& at, VF t) {
  const F f;
  const VF two = hn::Set(f, 2.0f);
  const VF bends = Fused(at.ex, c.x2, hn::Mul(at.ey, c.y2));
  const VF rise = Fused(two, bends, at.speed2);
  if (!kStroke) return {at.along, rise, hn::Set(f, 1.0f)};
  const VF r2 = Fused(at.ex, at.ex, Fused(at.ey, at.ey, hn::Set(f, 1e-12f))), r = hn::Sqrt(r2);
  const VF rate = Fused(hn::Mul(two, t), c.w2, c.w1);
  const VF value = FusedFrom(rate, r2, hn::Mul(at.along, r));
  const VF less = Fused(hn::Mul(two, c.w2), r2, hn::Mul(rate, at.along));
  return {value, hn::Sub(hn::Mul(rise, r), less), r};
}

/// Where f, as it is at t, says that the foot is.
HWY_INLINE VF Stepped(const BranchLanes& c, const Reached& at, const Slope& s, VF t) {
  const F f;
  // Less than that is no minimum; the step stays short.
  const VF least = hn::Mul(Fused(at.speed2, hn::Set(f, 0.05f), hn::Set(f, 1e-20f)), s.scale);
  const VF to = hn::Sub(t, hn::Div(s.value, hn::Max(s.rise, least)));
  return hn::Min(hn::Max(to, c.low), c.high);
}
template <bool kStroke>
HWY_INLINE VF Stepped(const BranchLanes& c, VF x, VF y, VF t) {
  const Reached at = ReachedAt(c, x, y, t);
  return Stepped(c, at, SlopeAt<kStroke>(c, at, t), t);
}

/// Whether a step may leave more than kLeft px. A step of δ px leaves δ² / 2 times f'' / f' per px. f' is ρ |B'|², and
/// f'' at most thrice what spine and width bend and, near a stroke's spine, what |B − p| bends by 1 / |B − p| times w'.
template <bool kStroke>
HWY_INLINE hn::Mask<F> GoesOn(VF bend2, const BranchLanes& c, const Reached& at, const Slope& s,
                              VF t, VF step) {
  constexpr float kLeft = 5e-4f;
  const F f;
  const VF square = hn::Mul(step, step), speed4 = hn::Mul(at.speed2, at.speed2);
  VF bends = hn::Mul(bend2, speed4);
  if (kStroke) {
    const VF rate = Fused(hn::Add(t, t), c.w2, c.w1);
    bends = hn::Mul(bends, hn::Mul(s.scale, s.scale));
    bends = Fused(hn::Mul(rate, rate), hn::Mul(speed4, at.speed2), bends);
  }
  const VF most = hn::Mul(hn::Set(f, kLeft * kLeft), hn::Mul(s.rise, s.rise));
  return hn::Gt(hn::Mul(hn::Mul(square, square), bends), most);
}

/// How the foot moves with the place.
struct Moves {
  VF x, y;
};
template <bool kStroke>
HWY_INLINE Moves MovesAt(const BranchLanes& c, const Reached& at, const Slope& s, VF t) {
  const F f;
  VF mx = hn::Mul(at.gx, s.scale), my = hn::Mul(at.gy, s.scale);
  if (kStroke) {
    const VF rate = Fused(hn::Add(t, t), c.w2, c.w1);
    mx = FusedFrom(rate, at.ex, mx), my = FusedFrom(rate, at.ey, my);
  }
  const VF least = hn::Mul(Fused(at.speed2, hn::Set(f, 0.3f), hn::Set(f, 1e-20f)), s.scale);
  const VF over = hn::Div(hn::Set(f, 1.0f), hn::Max(s.rise, least));
  return {hn::Mul(mx, over), hn::Mul(my, over)};
}

/// The foot on that half of a parabola, by the roots of its cubic, to 1.2e-5 of τ (depressed_cubic-inl.h): with τ = t −
/// the vertex's, f = 2 |x₂|² (τ³ + 3 P τ − S). On the place's own half it is the largest root. On the other one it is the
/// least distance that a place beyond the centre of curvature has there, which the rest of the cubic gives; if that has no
/// roots, the vertex.
HWY_INLINE VF FootOnHalf(const BranchLanes& c, VF x, VF y) {
  const F f;
  const VF zero = hn::Zero(f), half = hn::Set(f, 0.5f);
  const VF bend2 = hn::Max(Fused(c.x2, c.x2, hn::Mul(c.y2, c.y2)), hn::Set(f, 1e-20f));
  const VF over = hn::Div(half, bend2);
  const VF vertex = hn::Neg(hn::Mul(over, Fused(c.x1, c.x2, hn::Mul(c.y1, c.y2))));
  const Reached at = ReachedAt(c, x, y, vertex);
  const VF hand = hn::CopySign(hn::Set(f, 1.0f), hn::Sub(half, vertex));
  const VF bends = Fused(at.ex, c.x2, hn::Mul(at.ey, c.y2));
  const VF p =
      hn::Mul(hn::Mul(over, hn::Set(f, 1.0f / 3)), Fused(hn::Set(f, 2.0f), bends, at.speed2));
  const VF s = hn::Neg(hn::Mul(hn::Mul(hand, at.along), over)), away = hn::Abs(s);
  // Four times the same: compilers see that.
  const VF root = LargestRoot(f, Pack<VF>{p, p, p, p}, Pack<VF>{away, away, away, away}).a;
  const VF rest = Fused(hn::Set(f, -3.0f), hn::Mul(root, root), hn::Mul(hn::Set(f, -12.0f), p));
  const VF other = hn::Mul(half, hn::Add(root, hn::Sqrt(hn::Max(rest, zero))));
  const VF beyond = hn::IfThenElse(hn::Gt(rest, zero), other, zero);
  const VF t = Fused(hand, hn::IfThenElse(hn::Ge(s, zero), root, beyond), vertex);
  return hn::Min(hn::Max(t, c.low), c.high);
}

/// |p − B| − w.
HWY_INLINE VF KeyAt(const BranchLanes& c, VF x, VF y, VF t) {
  const VF ex = hn::Sub(Fused(t, Fused(t, c.x2, c.x1), c.x0), x);
  const VF ey = hn::Sub(Fused(t, Fused(t, c.y2, c.y1), c.y0), y);
  const VF away = hn::Sqrt(Fused(ex, ex, hn::Mul(ey, ey)));
  return hn::Sub(away, Fused(t, Fused(t, c.w2, c.w1), c.w0));
}

/// t, or an end of the stretch if that is nearer: beyond the vertex of a half that ends before it a place may have a least
/// distance at the end, beside the one within. (A stroke's end is a branch of its own there.)
HWY_INLINE VF OrEnd(const BranchLanes& c, VF x, VF y, VF t) {
  VF least = KeyAt(c, x, y, t);
  for (const VF end : {c.low, c.high}) {
    const VF own = KeyAt(c, x, y, end);
    const auto nearer = hn::Lt(own, least);
    t = hn::IfThenElse(nearer, end, t), least = hn::Min(own, least);
  }
  return t;
}

/// t, or an end or some other place of the stretch if that is nearer: a stretch that is not proven to have one foot may
/// have a least distance at an end, or where it was cut, beside the one within. What goes on beyond the stretch, 0 to 1,
/// is asked farther and farther away.
HWY_INLINE VF BestStart(const BranchLanes& c, VF x, VF y, VF t) {
  constexpr float kOn = 0.5f, kBeyond = 1.5f, kFar = 3.5f;
  const F f;
  const auto held = [&](float v)
                        HWY_ATTR { return hn::Min(hn::Max(hn::Set(f, v), c.low), c.high); };
  VF least = KeyAt(c, x, y, t);
  for (const VF start : {c.low, held(1.0f - kFar), held(1.0f - kBeyond), held(kOn), held(kBeyond),
                         held(kFar), hn::Mul(hn::Set(f, 0.5f), hn::Add(c.low, c.high)), c.high}) {
    const VF own = KeyAt(c, x, y, start);
    const auto nearer = hn::Lt(own, least);
    t = hn::IfThenElse(nearer, start, t), least = hn::Min(own, least);
  }
  return t;
}

/// A foot that was found, or another one that is nearer: seen from an end or the middle where these are.
template <bool kStroke>
HWY_INLINE VF NearerFoot(const BranchLanes& c, VF x, VF y, VF t) {
  const VF start = BestStart(c, x, y, t);
  const auto other = hn::Ne(start, t);
  if (hn::AllFalse(F(), other)) return t;
  VF foot = start;
  for (int i = 0; i < 4; ++i) foot = Stepped<kStroke>(c, x, y, foot);
  const auto better = hn::Lt(KeyAt(c, x, y, foot), KeyAt(c, x, y, start));
  return hn::IfThenElse(other, hn::IfThenElse(better, foot, start), t);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
