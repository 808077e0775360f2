// What of a square lies in a zone of a relief, and its colour. Included once per instruction set.
#if defined(MIEN_RENDER_SHADE_LIT_PIECE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LIT_PIECE_INL_H_
#undef MIEN_RENDER_SHADE_LIT_PIECE_INL_H_
#else
#define MIEN_RENDER_SHADE_LIT_PIECE_INL_H_
#endif

#include <mien/render/shade/cell_cut-inl.h>
#include <mien/render/shade/lamp_lanes-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Spot {
  VF d, nx, ny;
};

/// A zone's depths, and the side of the squares it is seen in.
struct ZoneCell {
  float shallow, deep, side;
};

struct Piece {
  VF area, depth;  ///< share of the square; its mean depth
  LitColor color;
  VF bends;  ///< how far the three colours are from a line, at most
};

HWY_INLINE VF Third(VF a, VF mid, VF b, VF& bends) {
  const VF off = hn::Sub(hn::Add(a, b), hn::Add(mid, mid));
  bends = hn::Max(bends, hn::Abs(off));
  return Fused(off, Const(5.0f / 18), mid);
}

/// The colour by three places along the gradient, Gauss's for a number of that mean and spread: of √depth where the
/// profile is round, since light goes like it there, else of the depth.
HWY_INLINE Piece PieceOf(const LampLanes& lamp, const ZoneCell& zone, const Spot& at, VF x, VF y) {
  const F f;
  const VF depth = hn::Neg(at.d), zero = hn::Zero(f);
  const auto low = CutCell(f, hn::Sub(depth, Const(zone.shallow)), at.nx, at.ny, zone.side);
  const auto high = CutCell(f, hn::Sub(Const(zone.deep), depth), at.nx, at.ny, zone.side);
  const VF area = hn::Max(hn::Sub(hn::Add(low.area, high.area), Const(1.0f)), zero);
  const auto ends = hn::Lt(high.area, Const(1.0f));
  const VF at_end = hn::Sub(Const(zone.deep), high.t);
  const auto color_at = [&](VF to) HWY_ATTR {
    const VF back = hn::Sub(depth, to);
    return LitAt(lamp, to, at.nx, at.ny, Fused(at.nx, back, x), Fused(at.ny, back, y));
  };
  const bool round = lamp.rise_kind == LampLanes::Rise::round;
  VF mean = hn::IfThenElse(ends, at_end, hn::Add(Const(zone.shallow), low.t));
  if (!round && lamp.domes.empty()) return {area, mean, color_at(mean), zero};
  VF middle = mean, wide = Const(0.28867513f * zone.side);
  if (round) {
    middle = hn::IfThenElse(ends, hn::Sqrt(hn::Max(at_end, zero)), low.root);
    wide = hn::Min(low.spread, hn::Mul(middle, Const(0.7f)));
    mean = hn::IfThenElse(ends, at_end, low.t);
  }
  const VF off = hn::Mul(wide, Const(1.3416408f));
  const auto depth_of = [&](VF v) HWY_ATTR { return round ? hn::Mul(v, v) : v; };
  const LitColor a = color_at(depth_of(hn::Sub(middle, off))), m = color_at(depth_of(middle)),
                 b = color_at(depth_of(hn::Add(middle, off)));
  VF bends = zero;
  const LitColor color{Third(a.r, m.r, b.r, bends), Third(a.g, m.g, b.g, bends),
                       Third(a.b, m.b, b.b, bends)};
  return {area, mean, color, bends};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
