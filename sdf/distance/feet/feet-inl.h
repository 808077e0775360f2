// Feet on branches, in lanes. Included once per instruction set.
//
// Newton's method for f(t) = (B − p) · B' − w' |B − p| = 0, from a foot close by. Where f grows by at least 0.3 |B'|²
// (branches.h) two steps from a foot a square's side away leave less than 1e-3 px along the spine, so 1e-6 of a
// distance, whose error is of second order. Normals come from B' and w' alone, n · B' = −w', and so are right on a
// spine, too, where the way to the foot is all rounding.
#if defined(MIEN_SDF_DISTANCE_FEET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_DISTANCE_FEET_INL_H_
#undef MIEN_SDF_DISTANCE_FEET_INL_H_
#else
#define MIEN_SDF_DISTANCE_FEET_INL_H_
#endif

#include "sdf/distance/feet/foot_steps-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The feet seen from the disc's middle, and how they move with the place.
template <bool kStroke>
HWY_INLINE void FindMiddleFeet(Branches& b) {
  const F f;
  for (int k = 0; k < b.count; k += int(hn::Lanes(f))) {
    const BranchLanes c = AllOf(b, k);
    const VF zero = hn::Zero(f);
    VF t = hn::LoadU(f, b.row(Branches::foot) + k);
    for (int i = 0; i < 4; ++i) t = Stepped<kStroke>(c, zero, zero, t);
    const Reached at = ReachedAt(c, zero, zero, t);
    const Moves moves = MovesAt<kStroke>(c, at, SlopeAt<kStroke>(c, at, t), t);
    hn::StoreU(t, f, b.row(Branches::foot) + k);
    hn::StoreU(moves.x, f, b.row(Branches::foot_x) + k);
    hn::StoreU(moves.y, f, b.row(Branches::foot_y) + k);
  }
}

template <class M>
HWY_INLINE std::uint64_t BitsOf(M mask, int k) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(F(), mask, bytes);
  return std::uint64_t(bytes[0] | bytes[1] << 8) << k;
}

/// Lets the branches in `from` go that are nowhere nearest within r of (cx, cy), and finds their feet there, to t.
template <bool kStroke>
HWY_INLINE NearBranches Narrowed(const Branches& b, std::uint64_t from, float cx, float cy, float r,
                                 BranchFeet& feet) {
  const F f;
  constexpr int kLanes = int(hn::MaxLanes(F()));
  HWY_ALIGN float keys[Branches::kStride];
  const VF x = hn::Set(f, cx), y = hn::Set(f, cy), zero = hn::Zero(f);
  std::uint64_t gone = 0, unsteady = 0;
  const std::uint64_t lanes = kLanes == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << kLanes) - 1;
  for (int k = 0; k < b.count; k += kLanes) {
    if (!(from >> k & lanes)) continue;
    const BranchLanes c = AllOf(b, k);
    const auto at_row = [&](Branches::Row row) HWY_ATTR { return hn::LoadU(f, b.row(row) + k); };
    VF t = Fused(x, at_row(Branches::foot_x),
                 Fused(y, at_row(Branches::foot_y), at_row(Branches::foot)));
    t = hn::Min(hn::Max(t, c.low), c.high);
    const auto single = hn::Gt(at_row(Branches::single), zero);
    if (!hn::AllTrue(f, single)) {
      VF start = FootOnHalf(c, x, y);
      if (!kStroke) start = OrEnd(c, x, y, start);
      const auto tapers = hn::Lt(at_row(Branches::single), zero);
      t = hn::IfThenElse(single, t, hn::IfThenElse(tapers, BestStart(c, x, y, t), start));
    }
    for (int i = 0; i < 2; ++i) t = Stepped<kStroke>(c, x, y, t);
    const Reached at = ReachedAt(c, x, y, t);
    const Slope s = SlopeAt<kStroke>(c, at, t);
    const auto held_low = hn::Le(t, c.low), held_high = hn::Ge(t, c.high);
    const auto first = hn::Le(t, at_row(Branches::first)), last = hn::Ge(t, at_row(Branches::last));
    // Held at an end that is none of the outline's: the neighbour is nearer. Where feet are hard to tell both stay, and
    // on a stretch whose width changes and which may have another foot somewhere in the square.
    const VF speed2 = hn::Mul(at.speed2, s.scale);
    const auto steady = hn::Gt(s.rise, hn::Mul(speed2, hn::Set(f, 0.35f)));
    const auto turns_low = hn::Ge(at_row(Branches::least), c.low);
    const auto turns_high = hn::Le(at_row(Branches::most), c.high);
    const auto joint_low = hn::AndNot(hn::Or(first, turns_low), held_low);
    const auto joint_high = hn::AndNot(hn::Or(last, turns_high), held_high);
    auto out = hn::And(steady, hn::Or(joint_low, joint_high));
    if (kStroke) {
      const VF bend2 = Fused(c.x2, c.x2, hn::Mul(c.y2, c.y2));
      const VF turn = hn::Mul(hn::Mul(hn::Set(f, 2.0f * r), hn::Sqrt(bend2)), s.scale);
      const auto keeps = hn::Gt(s.rise, Fused(speed2, hn::Set(f, 0.35f), turn));
      out = hn::And(out, hn::Or(keeps, hn::Ge(at_row(Branches::single), zero)));
    }
    if (!kStroke) {
      // So is the next side at a corner, where both end firmly: seen from all over the square.
      const VF r2 = hn::Set(f, r * r);
      const auto firm = hn::Gt(hn::Mul(s.value, s.value), hn::Mul(r2, at.speed2));
      const VF nx = at_row(Branches::next_x), ny = at_row(Branches::next_y);
      const VF on = hn::Neg(Fused(at.ex, nx, hn::Mul(at.ey, ny)));
      const VF next2 = hn::Mul(r2, Fused(nx, nx, hn::Mul(ny, ny)));
      const auto goes_on = hn::Or(hn::Gt(on, zero), hn::Lt(hn::Mul(on, on), next2));
      const auto begins = hn::And(hn::And(first, firm), hn::Gt(s.value, zero));
      const auto ends = hn::And(hn::And(last, firm), hn::And(hn::Lt(s.value, zero), goes_on));
      out = hn::Or(out, hn::Or(begins, ends));
    }
    gone |= BitsOf(out, k);
    // Above that share of |B'|² the stretch keeps one foot all over a square of a few pixels.
    unsteady |= BitsOf(hn::Le(s.rise, hn::Mul(speed2, hn::Set(f, 0.65f))), k);
    const VF away = hn::Sqrt(Fused(at.ex, at.ex, hn::Mul(at.ey, at.ey)));
    const VF key = hn::Sub(away, Fused(t, Fused(t, c.w2, c.w1), c.w0));
    const Moves moves = MovesAt<kStroke>(c, at, s, t);
    hn::StoreU(t, f, feet.t + k), hn::StoreU(key, f, keys + k);
    hn::StoreU(moves.x, f, feet.x + k), hn::StoreU(moves.y, f, feet.y + k);
  }
  NearBranches found;
  float best = BranchPair::kFar;
  for (std::uint64_t rest = from; rest; rest &= rest - 1)
    best = HWY_MIN(best, keys[std::countr_zero(rest)]);
  const float most = best + 2.0f * r + 0.01f;  // and what floats round
  for (std::uint64_t rest = from; rest; rest &= rest - 1) {
    const int k = std::countr_zero(rest);
    if (keys[k] < most) found.near |= std::uint64_t{1} << k;
  }
  found.key = best, found.local = found.near & ~gone;
  if (!found.local) found.local = found.near;
  constexpr float kFewPixels = 3.0f;
  found.x = cx, found.y = cy;
  found.sure = r < kFewPixels && std::popcount(found.local) == 1 && !(unsteady & found.near);
  if (!found.sure) return found;
  const int k = std::countr_zero(found.local);
  found.foot = feet.t[k], found.foot_x = feet.x[k], found.foot_y = feet.y[k];
  // Half as far again as the foot goes if it moves as at the middle.
  const float reach = 1.5f * r * (std::abs(found.foot_x) + std::abs(found.foot_y));
  found.endless = found.foot - reach > b.row(Branches::first)[k] &&
                  found.foot + reach < b.row(Branches::last)[k];
  return found;
}

/// [px] By so much less than another a side that ends is nearest.
inline constexpr float kTie = 1e-5f;
/// `moves` of a side that ends at a corner before the place comes to it.
inline constexpr float kEndsAtCorner = 0.5f;
/// The cosine of half the angle that a joint is no corner up to.
inline constexpr float kSmoothJoint = 0.9998f;

/// What one vector of places sees of a spine's branch.
struct Sight {
  VF key, nx, ny;  ///< k and its gradient
  VF beyond;  ///< k where it is nearest, seen from here: of a side that ends before, its line's
  VF sign;    ///< −1 inside a path
  VF off, ex,
      ey;     ///< of strokes: how far the spine is, where it mirrors the gradient; the way to it
  VF across;  ///< of strokes: the gradient's share across the spine
  VF moves;  ///< 1: this is no foot yet, or none of the outline's; less: its side ends at a corner before
};

template <bool kStroke>
HWY_INLINE Sight SightOf(const Branches& b, int k, const BranchFeet& feet, float cx, float cy, VF x,
                         VF y) {
  const F f;
  const auto set = [&](float v) HWY_ATTR { return hn::Set(f, v); };
  const VF zero = hn::Zero(f), one = set(1.0f);
  const BranchLanes c = OneOf(b, k);
  VF t = Fused(hn::Sub(x, set(cx)), set(feet.x[k]),
               Fused(hn::Sub(y, set(cy)), set(feet.y[k]), set(feet.t[k])));
  t = hn::Min(hn::Max(t, c.low), c.high);
  const float single = b.row(Branches::single)[k];
  if (single == 0.0f) {
    t = FootOnHalf(c, x, y);
    if (!kStroke) t = OrEnd(c, x, y, t);
  }
  const VF bend2 = hn::Mul(set(9.0f), Fused(c.x2, c.x2, Fused(c.y2, c.y2, hn::Mul(c.w2, c.w2))));
  constexpr int kMostSteps = 8;
  // Each place by itself, so that vectors of any width take the same steps.
  auto goes = hn::Ge(x, x);
  for (int i = 0; i < kMostSteps; ++i) {
    const Reached from = ReachedAt(c, x, y, t);
    const Slope slope = SlopeAt<kStroke>(c, from, t);
    const VF next = hn::IfThenElse(goes, Stepped(c, from, slope, t), t);
    goes = hn::And(goes, GoesOn<kStroke>(bend2, c, from, slope, t, hn::Sub(next, t)));
    t = next;
    if (hn::AllFalse(f, goes)) break;
  }
  if (single < 0.0f) t = NearerFoot<kStroke>(c, x, y, t);
  const Reached at = ReachedAt(c, x, y, t);
  const VF qx = hn::Neg(at.ex), qy = hn::Neg(at.ey);
  const VF over = hn::Div(one, hn::Sqrt(hn::Add(at.speed2, set(1e-20f))));
  const VF nx = hn::Mul(at.gy, over), ny = hn::Neg(hn::Mul(at.gx, over));
  const VF across = Fused(qx, nx, hn::Mul(qy, ny)), hand = hn::CopySign(one, across);
  const VF first = set(b.row(Branches::first)[k]), last = set(b.row(Branches::last)[k]);
  const auto inner = hn::And(hn::Gt(t, first), hn::Lt(t, last));
  // Held where the spine turns, it is nearer on the other side.
  const auto turns = hn::And(inner, hn::Or(hn::Le(t, c.low), hn::Ge(t, c.high)));
  const bool ends = !hn::AllTrue(f, inner);
  const VF r2 = Fused(qx, qx, Fused(qy, qy, set(1e-16f)));
  Sight s;
  s.moves = hn::IfThenElse(hn::Or(turns, goes), one, zero);
  if (kStroke) {
    const VF lean = hn::Neg(hn::Mul(Fused(hn::Add(t, t), c.w2, c.w1), over));
    const VF turned = hn::Sqrt(hn::Max(FusedFrom(lean, lean, one), zero));
    const VF side = hn::Mul(hand, turned);
    const VF r = hn::Sqrt(r2);
    s.key = s.beyond = hn::Sub(r, Fused(t, Fused(t, c.w2, c.w1), c.w0)), s.sign = one;
    s.nx = FusedFrom(lean, ny, hn::Mul(side, nx)), s.ny = Fused(lean, nx, hn::Mul(side, ny));
    s.off = hn::Abs(across);
    // Where the spine comes to a halt and turns back B' gives no normal, but the way from the foot does.
    const VF along = Fused(s.nx, qx, hn::Mul(s.ny, qy));
    const auto halts = hn::And(hn::Lt(along, hn::Mul(set(0.9f), r)), hn::Gt(r, set(1e-3f)));
    const auto beside = hn::AndNot(halts, inner);
    if (!hn::AllTrue(f, beside)) {
      const VF over_r = hn::Div(one, r);
      s.nx = hn::IfThenElse(beside, s.nx, hn::Mul(qx, over_r));
      s.ny = hn::IfThenElse(beside, s.ny, hn::Mul(qy, over_r));
      // Around an end the distance is a cone, whose tip the gradient turns at.
      s.off = hn::IfThenElse(beside, s.off, r);
      s.across = hn::IfThenElse(beside, turned, one);
      s.ex = hn::IfThenElse(beside, hn::Neg(hn::Mul(hand, nx)), hn::Neg(s.nx));
      s.ey = hn::IfThenElse(beside, hn::Neg(hn::Mul(hand, ny)), hn::Neg(s.ny));
      return s;
    }
    s.ex = hn::Neg(hn::Mul(hand, nx)), s.ey = hn::Neg(hn::Mul(hand, ny)), s.across = turned;
    return s;
  }
  const auto row = [&](Branches::Row which) HWY_ATTR { return set(b.row(which)[k]); };
  const VF r = hn::Sqrt(r2);  // no less than the least, wherever the foot is
  s.key = s.beyond = r, s.sign = hn::Mul(hand, row(Branches::side));
  s.nx = hn::Mul(hand, nx), s.ny = hn::Mul(hand, ny);
  s.off = set(BranchPair::kFar), s.ex = one, s.ey = zero, s.across = zero;
  if (!ends) return s;
  const auto end = hn::Ge(t, last);
  const VF px = hn::IfThenElse(end, row(Branches::end_x), row(Branches::begin_x));
  const VF py = hn::IfThenElse(end, row(Branches::end_y), row(Branches::begin_y));
  const VF beside = hn::CopySign(one, Fused(qx, px, hn::Mul(qy, py)));
  // At a corner itself only the outline's own normal gives a direction.
  const VF over_r = hn::Div(one, r);
  const auto at_end = hn::Lt(r, set(1e-3f));
  const VF ox = hn::IfThenElse(at_end, hn::Mul(px, beside), hn::Mul(qx, over_r));
  const VF oy = hn::IfThenElse(at_end, hn::Mul(py, beside), hn::Mul(qy, over_r));
  // An end is no least distance of the outline where the side that goes on there comes nearer.
  const VF on = Fused(qx, row(Branches::next_x), hn::Mul(qy, row(Branches::next_y)));
  const VF back = Fused(qx, row(Branches::before_x), hn::Mul(qy, row(Branches::before_y)));
  const auto passes = hn::IfThenElse(end, on, hn::Neg(back));
  const auto goes_on = hn::AndNot(inner, hn::Gt(passes, zero));
  // But beyond a corner's bisector it is. Of a smooth joint the own normal is next to that between the two.
  const auto turns_on = hn::Lt(hn::Abs(Fused(nx, px, hn::Mul(ny, py))), set(kSmoothJoint));
  const auto corner = hn::And(goes_on, turns_on);
  s.moves = hn::IfThenElse(
      goes_on, hn::IfThenElse(corner, hn::Max(s.moves, set(kEndsAtCorner)), one), s.moves);
  s.key = hn::IfThenElse(corner, hn::Add(s.key, set(kTie)), s.key);
  s.beyond = hn::IfThenElse(corner, hn::Abs(across), s.beyond);
  const auto own = hn::Or(inner, corner);
  s.sign = hn::IfThenElse(own, s.sign, beside);
  s.nx = hn::IfThenElse(own, s.nx, ox), s.ny = hn::IfThenElse(own, s.ny, oy);
  return s;
}

/// What may be the runner-up, once the best is known.
struct Candidate {
  alignas(64) float beyond[16], nx[16], ny[16], sign[16], moves[16];

  HWY_INLINE void put(const Sight& s) {
    const F f;
    hn::Store(s.beyond, f, beyond), hn::Store(s.nx, f, nx), hn::Store(s.ny, f, ny);
    hn::Store(s.sign, f, sign), hn::Store(s.moves, f, moves);
  }
};

/// The pair that sixteen places see of these branches, from their feet at (cx, cy).
template <bool kStroke>
HWY_INLINE void LookAt(const Branches& b, std::uint64_t which, const BranchFeet& feet, float cx,
                       float cy, const float* px, const float* py, BranchPair& to) {
  const F f;
  const VF far = hn::Set(f, BranchPair::kFar), one = hn::Set(f, 1.0f), zero = hn::Zero(f);
  const VF alike = hn::Set(f, 4e-4f);  // [of |n − n'|²] one branch's
  Candidate seen[Branches::kMost];
  for (int k = 0; k < BranchPair::kPlaces; k += int(hn::Lanes(f))) {
    const VF x = hn::LoadU(f, px + k), y = hn::LoadU(f, py + k);
    Sight best{far, one, zero, far, one, far, one, zero, zero, zero}, next = best;
    int count = 0;
    for (std::uint64_t rest = which; rest; rest &= rest - 1) {
      const Sight now = SightOf<kStroke>(b, std::countr_zero(rest), feet, cx, cy, x, y);
      seen[count++].put(now);
      const auto nearer = hn::Lt(now.key, best.key);
      const auto pick = [&](VF a, VF c) HWY_ATTR { return hn::IfThenElse(nearer, a, c); };
      best = {pick(now.key, best.key),       pick(now.nx, best.nx),
              pick(now.ny, best.ny),         pick(now.beyond, best.beyond),
              pick(now.sign, best.sign),     pick(now.off, best.off),
              pick(now.ex, best.ex),         pick(now.ey, best.ey),
              pick(now.across, best.across), pick(now.moves, best.moves)};
    }
    // The runner-up is not who comes next, but whose ridge is nearest: (d' − d)² / |n' − n|² is least.
    VF gap2 = hn::Mul(far, far), turn2 = one;
    for (int i = 0; i < count && count > 1; ++i) {
      const Candidate& c = seen[i];
      const VF key = hn::Load(f, c.beyond), nx = hn::Load(f, c.nx), ny = hn::Load(f, c.ny),
               sign = hn::Load(f, c.sign), moves = hn::Load(f, c.moves);
      const VF dx = hn::Sub(best.nx, nx), dy = hn::Sub(best.ny, ny), gap = hn::Sub(key, best.key);
      const VF own_gap2 = hn::Mul(gap, gap), own_turn2 = Fused(dx, dx, hn::Mul(dy, dy));
      // What sees the place from the other side, or comes nearer than the best foot, has its corner turned away. A foot
      // that still moves may be on its way to the best one.
      const auto corner = hn::And(hn::Eq(moves, hn::Set(f, kEndsAtCorner)),
                                  hn::And(hn::Eq(sign, best.sign), hn::Ge(gap, zero)));
      const auto sooner = hn::Lt(hn::Mul(own_gap2, turn2), hn::Mul(gap2, own_turn2));
      const auto other =
          hn::And(hn::And(hn::Gt(own_turn2, alike), sooner), hn::Or(hn::Eq(moves, zero), corner));
      const auto take = [&](VF a, VF of_next)
                            HWY_ATTR { return hn::IfThenElse(other, a, of_next); };
      gap2 = take(own_gap2, gap2), turn2 = take(own_turn2, turn2), next.key = take(key, next.key);
      next.nx = take(nx, next.nx), next.ny = take(ny, next.ny), next.sign = take(sign, next.sign);
    }
    const VF dx = hn::Sub(best.nx, next.nx), dy = hn::Sub(best.ny, next.ny);
    const VF over = hn::Div(one, hn::Sqrt(Fused(dx, dx, Fused(dy, dy, hn::Set(f, 1e-12f)))));
    VF off = hn::IfThenElse(hn::Lt(next.key, hn::Set(f, 1e8f)),
                            hn::Mul(hn::Sub(next.key, best.key), over), far);
    VF ex = hn::Mul(dx, over), ey = hn::Mul(dy, over);
    if (kStroke) {  // the spine mirrors
      const auto spine = hn::And(hn::Lt(best.off, off), hn::Gt(best.across, hn::Set(f, 0.01f)));
      const VF up = Fused(best.nx, best.ex, hn::Mul(best.ny, best.ey)), two = hn::Set(f, -2.0f);
      off = hn::IfThenElse(spine, best.off, off);
      ex = hn::IfThenElse(spine, best.ex, ex), ey = hn::IfThenElse(spine, best.ey, ey);
      const VF mirrored = Fused(hn::Mul(two, best.off), best.across, best.key);
      next.key = hn::IfThenElse(spine, mirrored, next.key);
      next.nx = hn::IfThenElse(spine, Fused(hn::Mul(two, up), best.ex, best.nx), next.nx);
      next.ny = hn::IfThenElse(spine, Fused(hn::Mul(two, up), best.ey, best.ny), next.ny);
      next.sign = hn::IfThenElse(spine, best.sign, next.sign);
    }
    const auto put = [&](const Sight& s, BranchPair::Values& v) HWY_ATTR {
      hn::StoreU(hn::Mul(s.sign, s.key), f, v.d + k);
      hn::StoreU(hn::Mul(s.sign, s.nx), f, v.nx + k);
      hn::StoreU(hn::Mul(s.sign, s.ny), f, v.ny + k);
    };
    put(best, to.best), put(next, to.beyond);
    hn::StoreU(off, f, to.off + k), hn::StoreU(ex, f, to.ex + k), hn::StoreU(ey, f, to.ey + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
