// Certificates for several tiles at once, in double lanes: the SIMD twin of grid_tile.h. Included once
// per instruction set. Derivation: docs/derivations/grid_tiles.md.
#if defined(MIEN_SDF_BATCH_GRID_CERTIFICATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_GRID_CERTIFICATE_INL_H_
#undef MIEN_SDF_BATCH_GRID_CERTIFICATE_INL_H_
#else
#define MIEN_SDF_BATCH_GRID_CERTIFICATE_INL_H_
#endif

#include "sdf/distance/grid/grid_tile.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <cmath>
#include <glm/geometric.hpp>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The curve relative to a tile's middle at t, as TileCertifier::At.
template <class V>
struct CurveAt {
  V qx, qy, ux, uy, f, f1;
};

template <class V>
HWY_INLINE V DotOf(V ax, V ay, V bx, V by) {
  return Fused(ax, bx, hn::Mul(ay, by));
}

template <class D, class V>
HWY_INLINE CurveAt<V> CurveFrom(D d, const TileFacts& c, V dx, V dy, V t) {
  const V ax = hn::Set(d, c.a.x), ay = hn::Set(d, c.a.y), bx = hn::Set(d, c.b.x),
          by = hn::Set(d, c.b.y);
  CurveAt<V> at;
  at.ux = Fused(t, bx, ax), at.uy = Fused(t, by, ay);
  at.qx = Fused(t, hn::Add(ax, at.ux), dx), at.qy = Fused(t, hn::Add(ay, at.uy), dy);
  at.f = DotOf(at.qx, at.qy, at.ux, at.uy);
  at.f1 = Fused(hn::Set(d, 2), DotOf(at.ux, at.uy, at.ux, at.uy), DotOf(at.qx, at.qy, bx, by));
  return at;
}

/// Middles relative to p0 and reaches of several tiles, a guess at their feet, and what was proven: GridTile's
/// numbers, `how` as a number. `uncertain`: ask TileCertifier, which has more proofs.
template <size_t kTiles>
struct TileLanes {
  HWY_ALIGN double dx[kTiles], dy[kTiles], reach[kTiles], t[kTiles];
  HWY_ALIGN double how[kTiles], wx[kTiles], wy[kTiles], zx[kTiles], zy[kTiles], inverse[kTiles];

  GridTile Tile(size_t k) const {
    return {GridTile::How(int(how[k])), t[k], wx[k], wy[k], zx[k], zy[k], inverse[k]};
  }
};

/// As TileCertifier::one_sided, and on the side of t.
template <class D, class V>
HWY_INLINE auto IsOnOneSide(D d, const QuadBezierFrame<double>& f, const TileFacts& c, V dx, V dy,
                            V reach, V t) {
  const auto number = [&](double v) MIEN_LANES { return hn::Set(d, v); };
  const V sx = hn::Mul(dx, number(f.sx)), sy = hn::Mul(dy, number(f.sy)), s1 = number(f.s1);
  const V s = hn::Add(hn::Add(sx, sy), s1);
  const V terms = hn::Add(hn::Add(hn::Abs(sx), hn::Abs(sy)), hn::Abs(s1));
  const V least_s = Fused(terms, number(0x1p-40), hn::Mul(reach, number(c.s_change)));
  const auto is_sided = hn::Gt(hn::Abs(s), f.straight ? number(HUGE_VAL) : least_s);
  return hn::And(is_sided, hn::Gt(hn::Mul(hn::Add(t, number(f.vertex)), s), hn::Zero(d)));
}

/// The feet of the tiles' middles: two Newton steps from the guesses.
template <class V, class M>
struct SettledFeet {
  V t;
  CurveAt<V> at;
  M settled;  ///< f rose all the way, and the second step was short
};

template <class D, class V>
HWY_INLINE auto StepTwice(D d, const TileFacts& c, V dx, V dy, V t) {
  const V zero = hn::Zero(d);
  const auto before = CurveFrom(d, c, dx, dy, t);
  t = hn::Sub(t, hn::Div(before.f, before.f1));
  const auto nearly = CurveFrom(d, c, dx, dy, t);
  const V step = hn::Div(nearly.f, nearly.f1);
  t = hn::Sub(t, step);
  const auto at = CurveFrom(d, c, dx, dy, t);
  const auto rising =
      hn::And(hn::Gt(before.f1, zero), hn::And(hn::Gt(nearly.f1, zero), hn::Gt(at.f1, zero)));
  const auto settled = hn::And(rising, hn::Lt(hn::Abs(step), hn::Set(d, 0x1p-14)));
  return SettledFeet<V, decltype(settled)>{t, at, settled};
}

/// TileCertifier::Branch without its masks: bounds on one branch of feet within `span` of a middle's.
template <class V>
struct BranchLanes {
  V middle, span, f2, most_u, most_f2, least_f1, inverse, t1;
};

/// As TileCertifier::branch.
template <class D, class V>
HWY_INLINE BranchLanes<V> BranchFrom(D d, const TileFacts& c, const CurveAt<V>& at, V reach) {
  const auto number = [&](double v) MIEN_LANES { return hn::Set(d, v); };
  const V one = number(1), b_length = number(c.b_length);
  BranchLanes<V> k;
  k.middle = hn::Div(one, at.f1);
  const V u_length = hn::Sqrt(DotOf(at.ux, at.uy, at.ux, at.uy));
  k.span = Fused(hn::Mul(number(1.5), reach), hn::Mul(u_length, k.middle), number(0x1p-18));
  k.f2 = hn::Mul(number(6), DotOf(at.ux, at.uy, number(c.b.x), number(c.b.y)));
  k.most_u = Fused(k.span, b_length, u_length);
  k.most_f2 = Fused(k.span, number(6 * c.bb), hn::Abs(k.f2));
  k.least_f1 = hn::Sub(at.f1, Fused(k.span, k.most_f2, hn::Mul(reach, b_length)));
  k.inverse = hn::Div(one, k.least_f1), k.t1 = hn::Mul(k.most_u, k.inverse);
  return k;
}

/// As TileCertifier::followed: how many steps from the start are proven enough, `how` as a number.
template <class D, class V, class M>
HWY_INLINE V FollowedHow(D d, const TileFacts& c, const CurveAt<V>& at, const BranchLanes<V>& k,
                         V reach, M inside) {
  using How = GridTile::How;
  const auto number = [&](double v) MIEN_LANES { return hn::Set(d, v); };
  const auto code = [&](How how) MIEN_LANES { return hn::Set(d, double(int(how))); };
  const V two = number(2), b_length = number(c.b_length);
  const V bend = Fused(k.most_f2, k.t1, b_length);
  const V t2 = hn::Mul(hn::Mul(hn::Add(b_length, bend), k.t1), k.inverse);
  const V t1_cubed = hn::Mul(hn::Mul(k.t1, k.t1), k.t1);
  const V t3 =
      hn::Mul(Fused(hn::Mul(number(3), bend), t2, hn::Mul(number(6 * c.bb), t1_cubed)), k.inverse);
  const V own = Fused(hn::Abs(at.f), k.inverse, number(0x1p-22));
  const V reach3 = hn::Mul(hn::Mul(reach, reach), hn::Mul(reach, number(1.0 / 6)));
  const V start = Fused(t3, reach3, own);
  const V bent = hn::Mul(number(0.5), hn::Mul(k.most_f2, k.inverse));
  const V after_one = hn::Mul(bent, hn::Mul(start, start));
  const V after_two = hn::Mul(bent, hn::Mul(after_one, after_one));
  const V uneven = hn::Mul(hn::Sub(at.f1, k.least_f1), k.middle);
  const V uneven3 = hn::Mul(hn::Mul(uneven, uneven), uneven);
  const V by_series = Fused(hn::Mul(two, uneven3), start, after_one);
  const auto is_enough = [&](V left) MIEN_LANES {
    return hn::Le(hn::Mul(hn::Mul(two, k.most_u), left), number(TileCertifier::kTolerance));
  };
  const auto stays = hn::Le(Fused(k.t1, reach, start), k.span);
  const auto multiplied =
      hn::And(hn::And(hn::Lt(uneven, number(0.25)), is_enough(by_series)), inside);
  V how = hn::IfThenElse(is_enough(after_two), code(How::two_steps), code(How::uncertain));
  how = hn::IfThenElse(is_enough(after_one), code(How::one_step), how);
  how = hn::IfThenElse(multiplied, code(How::multiplied), how);
  return hn::IfThenElse(stays, how, code(How::uncertain));
}

/// The start's linear forms of the offset from the middle.
template <class D, class V, size_t kTiles>
HWY_INLINE void StoreForms(D d, const TileFacts& c, const CurveAt<V>& at, const BranchLanes<V>& b,
                           TileLanes<kTiles>& tiles) {
  const V half = hn::Set(d, 0.5), bx = hn::Set(d, c.b.x), by = hn::Set(d, c.b.y);
  const V wx = hn::Mul(at.ux, b.middle), wy = hn::Mul(at.uy, b.middle);
  const V k = hn::Mul(half, hn::Mul(b.f2, b.middle));
  hn::Store(wx, d, tiles.wx), hn::Store(wy, d, tiles.wy);
  hn::Store(FusedFrom(k, wx, hn::Mul(bx, b.middle)), d, tiles.zx);
  hn::Store(FusedFrom(k, wy, hn::Mul(by, b.middle)), d, tiles.zy);
  hn::Store(hn::Mul(half, b.middle), d, tiles.inverse);
}

/// The same bounds in the same order as TileCertifier: convex, one side, branch, followed.
template <class D, size_t kTiles>
HWY_INLINE void CertifyLanes(D d, const QuadBezierFrame<double>& f, const TileFacts& c,
                             TileLanes<kTiles>& tiles) {
  using V = hn::Vec<D>;
  using How = GridTile::How;
  const auto number = [&](double v) MIEN_LANES { return hn::Set(d, v); };
  const V dx = hn::Load(d, tiles.dx), dy = hn::Load(d, tiles.dy), reach = hn::Load(d, tiles.reach);
  const V zero = hn::Zero(d), one = number(1), uncertain = number(int(How::uncertain));

  const auto is_convex =
      hn::Gt(CurveFrom(d, c, dx, dy, number(c.turn)).f1, hn::Mul(reach, number(c.b_length)));
  const auto first = CurveFrom(d, c, dx, dy, zero), last = CurveFrom(d, c, dx, dy, one);
  const V at_first = number(glm::length(c.a)), at_last = number(glm::length(c.a + c.b));
  const auto to_first = hn::And(is_convex, hn::Gt(first.f, hn::Mul(reach, at_first)));
  const auto to_last = hn::And(is_convex, hn::Lt(last.f, hn::Neg(hn::Mul(reach, at_last))));

  const auto [t, at, settled] = StepTwice(d, c, dx, dy, hn::Load(d, tiles.t));
  const auto b = BranchFrom(d, c, at, reach);
  const auto bounded = hn::And(hn::Gt(b.least_f1, zero), hn::Le(hn::Mul(reach, b.t1), b.span));
  const V low = hn::Sub(t, b.span), high = hn::Add(t, b.span);
  const auto inside = hn::And(bounded, hn::And(hn::Ge(low, zero), hn::Le(high, one)));
  const auto touches = hn::And(bounded, hn::And(hn::Ge(high, zero), hn::Le(low, one)));
  const auto by_side = hn::And(IsOnOneSide(d, f, c, dx, dy, reach, t), inside);
  const auto one_branch = hn::And(settled, hn::Or(by_side, hn::And(is_convex, touches)));
  V how = hn::IfThenElse(one_branch, FollowedHow(d, c, at, b, reach, inside), uncertain);

  const auto to_an_end = hn::Or(to_first, to_last);
  const V qx = hn::IfThenElse(to_first, first.qx, hn::IfThenElse(to_last, last.qx, at.qx));
  const V qy = hn::IfThenElse(to_first, first.qy, hn::IfThenElse(to_last, last.qy, at.qy));
  const V left = hn::Sub(number(TileCertifier::kClose), reach);
  const auto is_close =
      hn::And(hn::Gt(left, zero), hn::Lt(DotOf(qx, qy, qx, qy), hn::Mul(left, left)));
  how = hn::IfThenElse(to_an_end, number(int(How::end)), how);
  how = hn::IfThenElse(is_close, how, uncertain);
  hn::Store(how, d, tiles.how);
  hn::Store(hn::IfThenElse(to_first, zero, hn::IfThenElse(to_last, one, t)), d, tiles.t);
  StoreForms(d, c, at, b, tiles);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
