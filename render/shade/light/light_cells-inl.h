// A pixel or a part of one by cells. Included once per instruction set.
//
// A cell is seen at its centroid. A ridge that runs through it cuts it in closed form: a square's share beyond the line
// t = e · u − off and that share's centroid are second differences of max(t, 0)² / 2 and max(t, 0)³ / 6 over its
// corners. Each side is shaded at its own centroid by its own branch. Under a round profile slopes grow as the root of
// the depth, and cells at its outline are seen at two depths, one standard deviation apart from their mean.
#if defined(MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#undef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#else
#define MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#endif

#include "render/shade/light/lit_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A depth in the piece's zone, whose root counts over a spread of that variance.
HWY_INLINE VF HeldDepth(const LightTile& tile, VF d, VF variance) {
  if (tile.lamp.distance_alone) return hn::Neg(d);
  const VF depth = hn::Min(hn::Max(hn::Neg(d), Const(tile.shallow)), Const(tile.deep));
  if (!tile.lamp.is_round()) return depth;
  // The mean of a root is less than that of the mean, by an eighth of the relative variance and its square.
  const VF relative = hn::Div(variance, hn::Max(hn::Mul(depth, depth), Const(1e-12f)));
  const VF q = hn::Min(relative, Const(0.42f));
  return FusedFrom(hn::Mul(hn::Mul(depth, Const(0.25f)), q), hn::Add(Const(1.0f), q), depth);
}

/// The cells' figures where a look is taken.
struct CellLanes {
  VF x, y, area;
  VF side, variance;  ///< of a square of the cell's area
};

struct CutColor {
  VF c[LightTile::kChannels];
  VF jump;
};

/// The colour of cells that a ridge runs through.
inline CutColor MixedAtRidge(const LightTile& tile, const Seen& at, const RidgeLanes& ridge, int k,
                             const CellLanes& cell) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f), half = Const(0.5f);
  const VF ax = hn::Mul(cell.side, hn::Abs(ridge.ex)), ay = hn::Mul(cell.side, hn::Abs(ridge.ey));
  const VF a = hn::Max(hn::Max(ax, ay), Const(1e-9f));
  const VF b = hn::Max(hn::Min(ax, ay), hn::Mul(a, Const(0.0625f)));
  const VF p = hn::Mul(half, hn::Add(a, b)), q = hn::Mul(half, hn::Sub(a, b));
  const VF over = hn::Div(one, hn::Mul(a, b));
  VF two = zero, three = zero;
  const auto add = [&](VF v, VF by) HWY_ATTR {
    const VF held = hn::Max(v, zero), square = hn::Mul(held, held);
    two = Fused(by, square, two), three = Fused(by, hn::Mul(square, held), three);
  };
  const VF minus = Const(-1.0f);
  add(hn::Sub(p, ridge.off), one), add(hn::Sub(q, ridge.off), minus);
  add(hn::Sub(hn::Neg(q), ridge.off), minus), add(hn::Sub(hn::Neg(p), ridge.off), one);
  const VF far = hn::Min(hn::Max(hn::Mul(hn::Mul(half, two), over), zero), one);
  const VF past =
      hn::Div(hn::Mul(hn::Mul(three, over), Const(1.0f / 6)), hn::Max(far, Const(1e-6f)));
  const VF way = hn::Add(ridge.off, hn::Min(past, p));
  const VF back = hn::Neg(hn::Div(hn::Mul(far, way), hn::Max(hn::Sub(one, far), Const(0.1f))));
  const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
  const auto side = [&](VF ways, VF share, bool beyond) HWY_ATTR {
    const VF ux = hn::Mul(ways, ridge.ex), uy = hn::Mul(ways, ridge.ey);
    const auto pick = [&](const float* of_best, const float* of_beyond, bool ramp) HWY_ATTR {
      if (!beyond) return load(of_best);
      const auto turned = ramp ? ridge.of_ramp : ridge.of_relief;
      return hn::IfThenElse(turned, load(of_beyond), load(of_best));
    };
    VF d = zero, nx = zero, ny = zero, away = zero;
    if (tile.rises) {
      const BranchPair& r = at.relief;
      d = pick(r.best.d, r.beyond.d, false);
      nx = pick(r.best.nx, r.beyond.nx, false), ny = pick(r.best.ny, r.beyond.ny, false);
      d = Fused(ux, nx, Fused(uy, ny, d));
    }
    if (tile.lamp.goes_by_distance()) {
      const BranchPair& r = at.ramp;
      const VF rx = pick(r.best.nx, r.beyond.nx, true), ry = pick(r.best.ny, r.beyond.ny, true);
      away = Fused(ux, rx, Fused(uy, ry, pick(r.best.d, r.beyond.d, true)));
    }
    const VF depth = HeldDepth(tile, d, hn::Mul(cell.variance, share));
    return ColorAt(tile, depth, nx, ny, hn::Add(cell.x, ux), hn::Add(cell.y, uy), away);
  };
  const LitColor near = side(back, hn::Sub(one, far), false), beyond = side(way, far, true);
  CutColor mixed;
  mixed.jump = zero;
  for (int c = 0; c < LightTile::kChannels; ++c) {
    const VF apart = hn::Sub(beyond.c[c], near.c[c]);
    mixed.c[c] = Fused(far, apart, near.c[c]);
    mixed.jump = hn::Max(mixed.jump, hn::IfThenElse(hn::Gt(far, zero), hn::Abs(apart), zero));
  }
  return mixed;
}

struct CellSum {
  float c[LightTile::kChannels] = {};
  float area = 0;
  float jump = 0;  ///< the most that a ridge changes colours by in a cell
  float kink = 0;  ///< what a clamp of the law may change
};

/// The colour of cells at a round profile's outline, by two depths.
HWY_INLINE void TwoDepths(const LightTile& tile, const Seen& at, int k, const CellLanes& cell,
                          LitColor& color) {
  const F f;
  const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
  const VF d = load(at.relief.best.d), nx = load(at.relief.best.nx), ny = load(at.relief.best.ny);
  const VF away = tile.lamp.goes_by_distance() ? load(at.ramp.best.d) : hn::Zero(f);
  const VF mean = hn::Min(hn::Max(hn::Neg(d), Const(tile.shallow)), Const(tile.deep));
  // No farther than the shallow end: a uniform depth from there on has that deviation.
  const VF most = hn::Mul(Const(0.577350269f), hn::Sub(mean, Const(tile.shallow)));
  const VF apart = hn::Min(hn::Sqrt(cell.variance), most);
  const VF up = hn::Sub(mean, apart), down = hn::Min(hn::Add(mean, apart), Const(tile.deep));
  color = ColorAt(tile, up, nx, ny, cell.x, cell.y, away);
  const LitColor other = ColorAt(tile, down, nx, ny, cell.x, cell.y, away);
  for (int c = 0; c < LightTile::kChannels; ++c)
    color.c[c] = hn::Mul(Const(0.5f), hn::Add(color.c[c], other.c[c]));
}

/// Adds sixteen cells of a 1/side pixel each way.
inline void AddCells(LightTile& tile, const NearBranches* near, const NearBranches* near_ramp,
                     float cx, float cy, const float* px, const float* py, const float* areas,
                     CellSum& sum) {
  // [px] Profiles as narrow as that are steep where cells are two depths wide.
  constexpr float kNarrow = 12.0f, kSteep = 1.75f;
  const F f;
  Seen at;
  SeeFrom(tile, near, near_ramp, cx, cy, px, py, at);
  const bool steep = tile.rises && tile.lamp.is_round() && tile.lamp.width < kNarrow &&
                     MostOf16(at.relief.best.d) > -kSteep;
  Shades shades;
  HWY_ALIGN float jumps[16];
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    CellLanes cell{hn::LoadU(f, px + k), hn::LoadU(f, py + k), hn::LoadU(f, areas + k), {}, {}};
    const VF zero = hn::Zero(f);
    cell.side = hn::Sqrt(cell.area), cell.variance = hn::Mul(cell.area, Const(1.0f / 12));
    const auto there = hn::Gt(cell.area, zero);
    LitColor color;
    const VF d = tile.rises ? load(at.relief.best.d) : zero;
    if (steep) {
      TwoDepths(tile, at, k, cell, color);
    } else {
      const VF nx = tile.rises ? load(at.relief.best.nx) : zero;
      const VF ny = tile.rises ? load(at.relief.best.ny) : zero;
      const VF away = tile.lamp.goes_by_distance() ? load(at.ramp.best.d) : zero;
      color = ColorAt(tile, HeldDepth(tile, d, cell.variance), nx, ny, cell.x, cell.y, away);
    }
    const RidgeLanes ridge = RidgeAt(tile, at, k);
    const auto cut = hn::And(there, hn::Lt(ridge.off, hn::Mul(Const(0.75f), cell.side)));
    VF jump = zero;
    if (!hn::AllFalse(f, cut)) {
      const CutColor mixed = MixedAtRidge(tile, at, ridge, k, cell);
      for (int c = 0; c < LightTile::kChannels; ++c)
        color.c[c] = hn::IfThenElse(cut, mixed.c[c], color.c[c]);
      jump = hn::IfThenElse(cut, mixed.jump, zero);
    }
    hn::Store(jump, f, jumps + k);
    PutColor(color, k, shades);
  }
  sum.kink = HWY_MAX(sum.kink, KinkAmong(tile, shades, areas, 0.1f));
  sum.jump = HWY_MAX(sum.jump, MostOf16(jumps));
  // In one order for all instruction sets.
  const auto total = [](const float* v, const float* by) {
    float part[4] = {};
    for (int i = 0; i < 16; ++i) part[i & 3] += v[i] * by[i];
    return (part[0] + part[1]) + (part[2] + part[3]);
  };
  sum.area += total(areas, kAll);
  for (int c = 0; c < tile.channels; ++c) sum.c[c] += total(shades.c[c], areas);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
