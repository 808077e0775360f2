// What sixteen cells of a pixel see. Included once per instruction set.
//
// A cell is seen at its centroid. A ridge that runs through it cuts it in closed form: a square's share beyond the line
// t = e · u − off and that share's centroid are second differences of max(t, 0)² / 2 and max(t, 0)³ / 6 over its
// corners. Each side is shaded at its own centroid by its own branch. Under a round profile slopes grow as the root of
// the depth, and cells at its outline are seen at two depths.
#if defined(MIEN_RENDER_SHADE_SEEN_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_SEEN_CELLS_INL_H_
#undef MIEN_RENDER_SHADE_SEEN_CELLS_INL_H_
#else
#define MIEN_RENDER_SHADE_SEEN_CELLS_INL_H_
#endif

#include "render/shade/light/lit_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A depth in the piece's zone, whose root counts over a spread of that variance.
HWY_INLINE VF HeldDepth(const LightTile& tile, VF d, VF variance) {
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
inline CutColor MixedAtRidge(const LightTile& tile, const Encoding& encoding, const Seen& at,
                             const RidgeLanes& ridge, int k, const CellLanes& cell) {
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
      const BranchPair& r = *at.ramp;
      const VF rx = pick(r.best.nx, r.beyond.nx, true), ry = pick(r.best.ny, r.beyond.ny, true);
      away = Fused(ux, rx, Fused(uy, ry, pick(r.best.d, r.beyond.d, true)));
    }
    const VF depth = HeldDepth(tile, d, hn::Mul(cell.variance, share));
    return LitAt(tile.lamp, depth, nx, ny, hn::Add(cell.x, ux), hn::Add(cell.y, uy), away);
  };
  const LitColor near = side(back, hn::Sub(one, far), false), beyond = side(way, far, true);
  CutColor mixed;
  mixed.jump = zero;
  for (int c = 0; c < LightTile::kChannels; ++c) {
    const VF apart = hn::Sub(beyond.c[c], near.c[c]);
    mixed.c[c] = Fused(far, apart, near.c[c]);
    mixed.jump = hn::Max(mixed.jump, hn::Mul(hn::Abs(apart), Const(encoding.by[c])));
  }
  return mixed;
}

/// Colours times areas.
struct CellSum {
  float c[LightTile::kChannels] = {};
  float area = 0;

  /// In one order for all instruction sets.
  void add(const Shades& shades, const float* areas, int channels) {
    const auto total = [](const float* v, const float* by) {
      float part[4] = {};
      for (int i = 0; i < 16; ++i) part[i & 3] += v[i] * by[i];
      return (part[0] + part[1]) + (part[2] + part[3]);
    };
    area += total(areas, kAll);
    for (int k = 0; k < channels; ++k) c[k] += total(shades.c[k], areas);
  }
};

/// A pixel whose cells are looked at, with what it sees: the square around (cx, cy).
struct CellPixel {
  LightTile& tile;
  Near near;
  float cx, cy;
  float seen = 1.0f;       ///< how much of it is looked at, or little
  int side = 4;            ///< how many cells each way are looked at first
  Encoding encoding = {};  ///< of what is known of it
  float bend = 0;          ///< [1/px²] what colours bend by
  bool bends = false;      ///< colours may bend so much that cells of no side are taken for small

  /// What shows of a part lies in a pixel no darker than that.
  void shows(const float* mean) {
    float v[3];
    for (int c = 0; c < 3; ++c) v[c] = seen * mean[c];
    encoding = EncodingAt(tile, v);
  }
};

/// Sixteen cells: where, how large, and what is seen of them.
struct SixteenCells {
  alignas(64) float x[16], y[16], area[16];
  Shades shades;
  alignas(64) float jump[16];  ///< what a ridge changes colours by within the cell
  alignas(64) float away[16];  ///< [of the cell's side] how far the nearest ridge is
};

/// A highlight's peak between two depths under one normal, domes aside, where it is four times as bright as at the
/// darker end: two depths may not see it. Else 0. n · halfway is (z + r a) / √(1 + r²) for a rise r: most for r = a / z.
HWY_INLINE VF BellBetween(const LampLanes& lamp, VF nx, VF ny, VF shallow, VF deep) {
  constexpr float kFalls = 2.0f;  // [powers of 2]
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f), little = Const(1e-12f);
  if (!(lamp.shine > 0.0f)) return zero;
  const VF z = Const(lamp.halfway[2]), half_power = Const(0.5f * lamp.shininess);
  const VF a = Fused(nx, Const(lamp.halfway[0]), hn::Mul(ny, Const(lamp.halfway[1])));
  const VF most = hn::Max(Fused(a, a, hn::Mul(z, z)), little);
  const auto square_of = [&](VF r) HWY_ATTR {
    const VF along = hn::Max(Fused(r, a, z), zero);
    return hn::Div(hn::Mul(along, along), Fused(r, r, one));
  };
  const VF r = RiseAt(lamp, shallow), s = RiseAt(lamp, deep), rz = hn::Mul(r, z),
           sz = hn::Mul(s, z);
  const VF least = hn::Max(hn::Min(square_of(r), square_of(s)), little);
  const auto within = hn::And(hn::Le(hn::Min(rz, sz), a), hn::Le(a, hn::Max(rz, sz)));
  const auto falls = hn::Gt(hn::Mul(half_power, Log2(hn::Div(most, least))), Const(kFalls));
  const VF power = hn::Max(hn::Mul(half_power, Log2(most)), Const(-126.0f));
  const VF peak = hn::Mul(Const(lamp.shine), Exp2(power));
  return hn::IfThenElse(hn::And(within, falls), peak, zero);
}

/// The colour of cells at a round profile's outline, by two depths.
HWY_INLINE void TwoDepths(const LightTile& tile, const Seen& at, int k, const CellLanes& cell,
                          Shades& to) {
  const F f;
  const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
  const VF d = load(at.relief.best.d), nx = load(at.relief.best.nx), ny = load(at.relief.best.ny);
  const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : hn::Zero(f);
  // Light goes by the root of the depth, and depths are spread evenly over the cell: by Gauss's two places of the root,
  // each of which counts by itself, as depth = root². Exact up to the root's second degree.
  const VF zero = hn::Zero(f), shallow = Const(HWY_MAX(tile.shallow, 0.0f));
  const VF mean = hn::Min(hn::Max(hn::Neg(d), shallow), Const(tile.deep));
  const VF half = hn::Min(hn::Mul(Const(0.5f), cell.side), hn::Sub(mean, shallow));
  const VF first = hn::Sqrt(hn::Max(hn::Sub(mean, half), zero)),
           last = hn::Sqrt(hn::Add(mean, half));
  const VF middle = hn::Mul(Const(0.5f), hn::Add(first, last));
  const VF apart = hn::Mul(Const(0.288675135f), hn::Sub(last, first));
  const VF up = hn::Sub(middle, apart), down = hn::Add(middle, apart);
  const auto depth = [&](VF root)
                         HWY_ATTR { return hn::Min(hn::Mul(root, root), Const(tile.deep)); };
  LitColor color = LitAt(tile.lamp, depth(up), nx, ny, cell.x, cell.y, away);
  const LitColor other = LitAt(tile.lamp, depth(down), nx, ny, cell.x, cell.y, away);
  const VF share = hn::Div(down, hn::Max(hn::Add(up, down), Const(1e-9f)));
  for (int c = 0; c < LightTile::kChannels; ++c)
    color.c[c] = Fused(share, hn::Sub(other.c[c], color.c[c]), color.c[c]);
  PutColor(color, k, to);
  for (int b = 0; b < 3; ++b) {
    hn::Store(hn::Min(color.bounds[b], other.bounds[b]), f, to.bounds[b] + k);
    hn::Store(hn::Max(color.bounds[b], other.bounds[b]), f, to.upper[b] + k);
  }
  hn::Store(BellBetween(tile.lamp, nx, ny, depth(first), depth(last)), f, to.bell + k);
}

// [of a cell's side] A straight ridge may run through it, and one that bends.
inline constexpr float kCutCell = 0.75f, kNearCell = 1.3f;
/// The most that the outward normal turns by from a cell to the next in the list, but at ridges.
inline float MostTurn(const BranchPair& at, const float* away) {
  float most = 0.0f;
  for (int k = 0; k < 15; ++k) {
    if (HWY_MIN(away[k], away[k + 1]) < kNearCell) continue;
    most = HWY_MAX(most, std::abs(at.best.nx[k + 1] - at.best.nx[k]) +
                             std::abs(at.best.ny[k + 1] - at.best.ny[k]));
  }
  return most;
}

/// [1/px²] What a radial ramp bends by in a pixel around (x, y): across the way from its centre, as one by how far it is.
inline float RampBendAt(const LampRamp& ramp, float x, float y) {
  constexpr float kReach = 0.7072f, kCentre = 0.1f;  // [px]
  if (ramp.kind != LampRamp::Kind::radial) return 0.0f;
  const float px = x - ramp.x, py = y - ramp.y;
  const float u = px * ramp.xx + py * ramp.xy, v = px * ramp.yx + py * ramp.yy;
  const float t = std::sqrt(u * u + v * v);
  const float n = ramp.xx * ramp.xx + ramp.xy * ramp.xy + ramp.yx * ramp.yx + ramp.yy * ramp.yy;
  const float ax = u * ramp.yx - v * ramp.xx, ay = u * ramp.yy - v * ramp.xy, step = std::sqrt(n);
  // Farther than a pixel from the centre the way hardly turns within it.
  const float across2 = t > step ? (ax * ax + ay * ay) / (t * t) : n;
  float slope = 0.0f;
  for (const float by : ramp.slope) slope = HWY_MAX(slope, std::abs(by));
  return slope * across2 / HWY_MAX(t - kReach * step, kCentre * step);
}

/// [1/px²] What light bends by in a pixel around (x, y). A dome's slope changes by 8 height / radius² at its foot, twice
/// as fast as at its top, and that by 24 height / radius³; a highlight is a bell of 1 / √shininess in slope.
inline float BendAt(const LampLanes& lamp, float x, float y) {
  constexpr float kReach = 0.7072f;  // [px]
  float turn = 0.0f, turns_by = 0.0f;
  for (const LampDome& dome : lamp.domes) {
    const float px = x - dome.x, py = y - dome.y;
    const float u = px * dome.xx + py * dome.xy, v = px * dome.yx + py * dome.yy;
    const float n = dome.xx * dome.xx + dome.xy * dome.xy + dome.yx * dome.yx + dome.yy * dome.yy;
    const float reach = kReach * std::sqrt(n), out = std::sqrt(u * u + v * v);
    if (out > 1.0f + reach) continue;
    const float gx = u * dome.xx + v * dome.yx, gy = u * dome.xy + v * dome.yy;
    const float far = HWY_MIN(out + reach, 1.0f), near = HWY_MAX(out - reach, 0.0f);
    const float grows = near > 0.0f ? far / out : 0.0f;
    const float steep = near > 0.0f ? (gx * gx + gy * gy) * grows * grows : n * far * far;
    turn += std::abs(dome.height) * ((1.0f - near * near) * n + 2.0f * steep);
    turns_by += 6.0f * std::abs(dome.height) * far * n * std::sqrt(n);
  }
  const float s = lamp.shininess;
  return lamp.bend + RampBendAt(lamp.ramp, x, y) +
         LampLanes::kUsualBend * ((lamp.shine * s + lamp.diffuse) * turn * turn +
                                  (0.6f * lamp.shine * std::sqrt(s) + lamp.diffuse) * turns_by);
}

/// Into how many cells each way a part must be divided so that what colours bend by leaves no more than allowed: cells
/// of side h leave h² / 24 of that.
inline int SideFor(float bend, float area, float allowed) {
  const float most = bend * area / (24.0f * HWY_MAX(allowed, 1e-9f));
  int side = 4;
  while (side < PartCells::kMostSide && float(side * side) < most) side *= 2;
  return side;
}

/// Whether 4 × 4 cells may be off because encoded colours go by a root of light: e = L^(1/2.4) bends by 1.4 e'² / e.
inline bool BendsInTheDark(const LightTile& tile, const SixteenCells& cells) {
  if (tile.lamp.linear) return false;
  constexpr float kRoot = 1.4f, kOffset = 0.055f, kCells = 1.0f / (16 * 24);
  // [px] At a dome's foot light begins to change as the distance does, and a dark colour as its root.
  constexpr float kFoot = 0.3f, kDark = 0.25f;
  const bool at_foot = RangeOf16(cells.shades.foot, cells.area).low < kFoot;
  float most = 0.0f;
  for (int c = 0; c < 3; ++c) {
    const Range range = RangeOf16(cells.shades.c[c], cells.area);
    const float wide = range.high - range.low;
    if (at_foot && range.low < kDark) return true;
    most = HWY_MAX(most, kRoot * wide * wide / (HWY_MAX(range.low, 0.0f) + kOffset));
  }
  return most * kCells > tile.tolerance;
}

/// Their colours, each at its middle, or at two depths where a round profile is `upright` [px] beside them.
inline void ShadeCells(const LightTile& tile, const Seen& at, bool upright, SixteenCells& cells) {
  const F f;
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    CellLanes cell{load(cells.x), load(cells.y), load(cells.area), {}, {}};
    const VF zero = hn::Zero(f);
    cell.side = hn::Sqrt(cell.area), cell.variance = hn::Mul(cell.area, Const(1.0f / 12));
    if (upright) {
      TwoDepths(tile, at, k, cell, cells.shades);
      continue;
    }
    const VF d = tile.rises ? load(at.relief.best.d) : zero;
    const VF nx = tile.rises ? load(at.relief.best.nx) : zero;
    const VF ny = tile.rises ? load(at.relief.best.ny) : zero;
    const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : zero;
    const VF depth = HeldDepth(tile, d, cell.variance);
    PutColor(LitAt(tile.lamp, depth, nx, ny, cell.x, cell.y, away), k, cells.shades);
  }
}

/// Mixes what a cell shows on both sides of a ridge through it, and tells how far ridges are and what they change.
inline void CutAtRidges(const CellPixel& pixel, const Seen& at, SixteenCells& cells) {
  const F f;
  const LightTile& tile = pixel.tile;
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    const VF area = load(cells.area), side = hn::Sqrt(area), zero = hn::Zero(f);
    const RidgeLanes ridge = RidgeAt(tile, at, k);
    hn::Store(hn::Div(ridge.off, hn::Max(side, Const(1e-6f))), f, cells.away + k);
    hn::Store(zero, f, cells.jump + k);
    // Nothing is less than no side.
    const auto cut = hn::Lt(ridge.off, hn::Mul(Const(kCutCell), side));
    // For 16 bits what a ridge beside the cell would change is told, too: it may bend into a corner.
    const auto close = hn::Lt(ridge.off, hn::Mul(Const(tile.fine ? kNearCell : kCutCell), side));
    if (hn::AllFalse(f, close)) continue;
    const CellLanes cell{load(cells.x), load(cells.y), area, side, hn::Mul(area, Const(1.0f / 12))};
    const CutColor mixed = MixedAtRidge(tile, pixel.encoding, at, ridge, k, cell);
    for (int c = 0; c < LightTile::kChannels; ++c)
      hn::Store(hn::IfThenElse(cut, mixed.c[c], load(cells.shades.c[c])), f, cells.shades.c[c] + k);
    hn::Store(hn::IfThenElse(close, mixed.jump, zero), f, cells.jump + k);
  }
}

/// Whether colours bend within small cells, too. `upright`: seen at two depths.
inline bool BendsInCells(const CellPixel& pixel, const Seen& at, bool upright,
                         const SixteenCells& cells) {
  // [of the tolerance] a highlight that shows. [px] A ridge as near as that to the outline.
  constexpr float kBell = 8.0f, kThin = 0.15f;
  // Light changes by some 100 levels with a normal that turns by one radian: a cell leaves 4 levels times the turn².
  constexpr float kTurn = 1.5f * 255 / 4;
  // Thinner than cells: depths are not spread from the outline on where a ridge ends them. A highlight that rises by more
  // than this power of 2 between two depths may be a bell between them.
  constexpr float kRises = 6.0f;
  const LightTile& tile = pixel.tile;
  // In linear light dark colours are encoded steeply, and what domes bend them by with them.
  const float steep = pixel.encoding.most();
  if (BendsInTheDark(tile, cells) ||
      SideFor((pixel.bend - tile.lamp.bend) * steep, pixel.seen, tile.tolerance) > pixel.side)
    return true;
  if (!tile.rises) return false;
  const float turn = MostTurn(at.relief, cells.away);
  if (turn * turn > kTurn * tile.tolerance) return true;
  for (size_t k = 0; upright && k < 16; ++k) {
    if (!(cells.area[k] > 0.0f)) continue;
    const Shades& s = cells.shades;
    float bell = s.bell[k];
    if (s.upper[1][k] - s.bounds[1][k] > kRises)
      bell = HWY_MAX(bell, tile.lamp.shine * std::exp2(s.upper[1][k] + tile.lamp.level_power));
    if (bell * steep * pixel.seen > kBell * tile.tolerance ||
        at.relief.off[k] - at.relief.best.d[k] < kThin)
      return true;
  }
  return false;
}

/// Sees sixteen cells; the first of them tell how the pixel is encoded, and whether cells are small.
inline void SeeCells(CellPixel& pixel, bool first, SixteenCells& cells) {
  // [px] Profiles are steep where cells are two depths wide. [levels · px] Seen at one depth, a row of 4 × 4 cells along
  // an outline is off by a fifth of that over the profile's width: 12 px do for 8 bits.
  constexpr float kSteep = 1.75f, kByOneDepth = 3.6f / 255;
  LightTile& tile = pixel.tile;
  Seen at;
  SeeFrom(tile, pixel.near, pixel.cx, pixel.cy, cells.x, cells.y, at);
  const bool upright = tile.rises && tile.lamp.is_round() &&
                       tile.lamp.width * tile.tolerance < kByOneDepth &&
                       MostOf16(at.relief.best.d) > -kSteep;
  ShadeCells(tile, at, upright, cells);
  if (first) {
    CellSum sum;
    sum.add(cells.shades, cells.area, 3);
    for (float& c : sum.c) c /= sum.area;
    pixel.shows(sum.c);
  }
  CutAtRidges(pixel, at, cells);
  if (first && !tile.fine) pixel.bends = BendsInCells(pixel, at, upright, cells);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
