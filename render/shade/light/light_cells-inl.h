// A pixel or a part of one by cells. Included once per instruction set.
//
// A cell is seen at its centroid. A ridge that runs through it cuts it in closed form: a square's share beyond the line
// t = e · u − off and that share's centroid are second differences of max(t, 0)² / 2 and max(t, 0)³ / 6 over its
// corners. Each side is shaded at its own centroid by its own branch. Under a round profile slopes grow as the root of
// the depth, and cells at its outline are seen at two depths, one standard deviation apart from their mean.
//
// Where that may not suffice, cells that a ridge or a clamp runs through are divided, and only those.
#if defined(MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#undef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#else
#define MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#endif

#include "render/shade/light/lit_places-inl.h"

#include <numeric>

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
  mixed.jump = hn::IfThenElse(hn::Gt(far, zero), mixed.jump, zero);
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

/// The colour of cells at a round profile's outline, by two depths.
HWY_INLINE void TwoDepths(const LightTile& tile, const Seen& at, int k, const CellLanes& cell,
                          LitColor& color) {
  const F f;
  const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
  const VF d = load(at.relief.best.d), nx = load(at.relief.best.nx), ny = load(at.relief.best.ny);
  const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : hn::Zero(f);
  const VF mean = hn::Min(hn::Max(hn::Neg(d), Const(tile.shallow)), Const(tile.deep));
  // No farther than the shallow end: a uniform depth from there on has that deviation.
  const VF most = hn::Mul(Const(0.577350269f), hn::Sub(mean, Const(tile.shallow)));
  const VF apart = hn::Min(hn::Sqrt(cell.variance), most);
  const VF up = hn::Sub(mean, apart), down = hn::Min(hn::Add(mean, apart), Const(tile.deep));
  color = LitAt(tile.lamp, up, nx, ny, cell.x, cell.y, away);
  const LitColor other = LitAt(tile.lamp, down, nx, ny, cell.x, cell.y, away);
  for (int c = 0; c < LightTile::kChannels; ++c)
    color.c[c] = hn::Mul(Const(0.5f), hn::Add(color.c[c], other.c[c]));
}

// [of a cell's side] A ridge that bends may run through it.
inline constexpr float kNearCell = 1.3f;
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
  if (turn == 0.0f) return lamp.bend;
  // Of the most that all of this can be at once.
  constexpr float kUsual = 0.35f;
  const float s = lamp.shininess;
  return lamp.bend + kUsual * ((lamp.shine * s + lamp.diffuse) * turn * turn +
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

/// Sees sixteen cells; the first of them tell how the pixel is encoded, and whether cells are small.
inline void SeeCells(CellPixel& pixel, bool first, SixteenCells& cells) {
  // [px] Profiles are steep where cells are two depths wide. [levels · px] Seen at one depth, a row of 4 × 4 cells along
  // an outline is off by a fifth of that over the profile's width: 12 px do for 8 bits.
  constexpr float kSteep = 1.75f, kByOneDepth = 3.6f / 255, kThin = 0.15f;
  const F f;
  LightTile& tile = pixel.tile;
  Seen at;
  SeeFrom(tile, pixel.near, pixel.cx, pixel.cy, cells.x, cells.y, at);
  const bool upright = tile.rises && tile.lamp.is_round() &&
                       tile.lamp.width * tile.tolerance < kByOneDepth &&
                       MostOf16(at.relief.best.d) > -kSteep;
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    CellLanes cell{load(cells.x), load(cells.y), load(cells.area), {}, {}};
    const VF zero = hn::Zero(f);
    cell.side = hn::Sqrt(cell.area), cell.variance = hn::Mul(cell.area, Const(1.0f / 12));
    LitColor color;
    const VF d = tile.rises ? load(at.relief.best.d) : zero;
    if (upright) {
      TwoDepths(tile, at, k, cell, color);
    } else {
      const VF nx = tile.rises ? load(at.relief.best.nx) : zero;
      const VF ny = tile.rises ? load(at.relief.best.ny) : zero;
      const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : zero;
      color = LitAt(tile.lamp, HeldDepth(tile, d, cell.variance), nx, ny, cell.x, cell.y, away);
    }
    PutColor(color, k, cells.shades);
  }
  if (first) {
    CellSum sum;
    sum.add(cells.shades, cells.area, 3);
    for (float& c : sum.c) c /= sum.area;
    pixel.shows(sum.c);
  }
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    const VF area = load(cells.area), side = hn::Sqrt(area), zero = hn::Zero(f);
    const RidgeLanes ridge = RidgeAt(tile, at, k);
    hn::Store(hn::Div(ridge.off, hn::Max(side, Const(1e-6f))), f, cells.away + k);
    hn::Store(zero, f, cells.jump + k);
    // Nothing is less than no side.
    const auto cut = hn::Lt(ridge.off, hn::Mul(Const(0.75f), side));
    if (hn::AllFalse(f, cut)) continue;
    const CellLanes cell{load(cells.x), load(cells.y), area, side, hn::Mul(area, Const(1.0f / 12))};
    const CutColor mixed = MixedAtRidge(tile, pixel.encoding, at, ridge, k, cell);
    for (int c = 0; c < LightTile::kChannels; ++c)
      hn::Store(hn::IfThenElse(cut, mixed.c[c], load(cells.shades.c[c])), f, cells.shades.c[c] + k);
    hn::Store(hn::IfThenElse(cut, mixed.jump, zero), f, cells.jump + k);
  }
  if (!first || tile.fine || !tile.rises) return;
  // Light changes by some 100 levels with a normal that turns by one radian: a cell leaves 4 levels times the turn².
  constexpr float kTurn = 1.5f * 255 / 4;
  const float turn = MostTurn(at.relief, cells.away);
  pixel.bends = turn * turn > kTurn * tile.tolerance;
  // Thinner than cells: depths are not spread from the outline on where a ridge ends them.
  for (size_t k = 0; k < 16 && upright; ++k)
    pixel.bends =
        pixel.bends || (cells.area[k] > 0.0f && at.relief.off[k] - at.relief.best.d[k] < kThin);
}

/// Which of a level's cells are looked at: of the grid of that many each way, in its order.
using CellList = std::array<std::uint16_t, PartCells::kMost>;

/// When cells stay open.
struct OpenBy {
  float jump, kink;  ///< more of these may be off
  float apart,
      few;  ///< by how much quarters may be apart from their whole; and that times their area, of a few
  bool quarters;  ///< whether the listed cells are quarters of cells that were open
  bool small;     ///< whether nothing but ridges and clamps can matter within a cell
};

/// A mean by cells, as far as they were looked at.
struct CellMean {
  CellSum closed, open;
  float jump = 0;   ///< the most that a ridge changes colours by in a cell
  float kink = 0;   ///< what a clamp of the law may change
  float apart = 0;  ///< what quarters were apart from their wholes, times areas
  int opens = 0;    ///< how many are open: the first of their list
};

/// The next sixteen listed cells of more than no area; returns how many there are. `which`: their places in the list.
inline int TakeSixteen(const CellPixel& pixel, const PartCells& cells, const CellList& list,
                       int count, bool quarters, int& next, SixteenCells& to,
                       std::uint16_t* which) {
  int n = 0;
  if (cells.side == 4) {  // all of them, be there some without area
    const F f;
    for (; n < 16 && next == 0; n += int(hn::Lanes(f))) {
      hn::Store(hn::Add(hn::Load(f, &cells.x[size_t(n)]), hn::Set(f, pixel.cx)), f, to.x + n);
      hn::Store(hn::Add(hn::Load(f, &cells.y[size_t(n)]), hn::Set(f, pixel.cy)), f, to.y + n);
      hn::Store(hn::Load(f, &cells.area[size_t(n)]), f, to.area + n);
    }
    for (int k = 0; k < n; ++k) which[k] = std::uint16_t(k);
    next = count;
    return n;
  }
  const int together = quarters ? 4 : 1;  // those of a cell
  const auto unseen = [&](int first) {
    for (int k = first; k < first + together; ++k)
      if (cells.area[list[size_t(k)]] > 0.0f) return false;
    return true;
  };
  for (; next < count && n < 16; ++next) {
    const size_t k = list[size_t(next)];
    if (n % together == 0 && unseen(next)) {
      next += together - 1;
      continue;
    }
    to.x[n] = pixel.cx + cells.x[k], to.y[n] = pixel.cy + cells.y[k];
    to.area[n] = cells.area[k], which[n++] = std::uint16_t(next);
  }
  for (int k = n; k < 16; ++k) to.x[k] = to.x[0], to.y[k] = to.y[0], to.area[k] = 0.0f;
  return n;
}

/// Closes cells but those that a ridge or a clamp may run through and, while cells are not small, those that are not
/// quarters which agree with their whole: a cell seen at its middle is off by the fourfold of what its quarters are, but
/// for terms of fourth degree.
inline void OpenCells(const CellPixel& pixel, const SixteenCells& now, const std::uint16_t* which,
                      int count, const CellList& list, const OpenBy& by, CellMean& mean,
                      CellList& open) {
  // [of the range among cells] Half a diagonal of a cell, where the range is that of three of them or less.
  constexpr float kHalfCell = 0.75f;
  LightTile& tile = pixel.tile;
  float low[3], high[3];
  const auto range = [&](size_t first, size_t end) {
    for (int b = 0; b < 3; ++b) {
      const float* v = now.shades.bounds[b];
      low[b] = *std::min_element(v + first, v + end),
      high[b] = *std::max_element(v + first, v + end);
    }
  };
  const bool kinks = mean.kink > by.kink, jumps = mean.jump > by.jump;
  if (kinks && !by.quarters) range(0, size_t(count));
  alignas(64) float of_open[16] = {}, of_closed[16] = {};
  for (size_t k = 0; k < size_t(count); k += 4) {
    if (kinks && by.quarters) range(k, k + 4);
    const size_t end = HWY_MIN(k + 4, size_t(count));
    bool opens[4], any = false;
    for (size_t q = k; q < end; ++q) {
      bool& o = opens[q - k] = jumps && (now.jump[q] > by.jump || now.away[q] < kNearCell);
      for (int b = 0; b < 3 && kinks; ++b)
        o = o || std::abs(now.shades.bounds[b][q]) <= kHalfCell * (high[b] - low[b]);
      any = any || o;
    }
    if (!by.small) {
      bool all = any || !by.quarters;
      if (!all) {
        const auto whole = size_t(which[k] / 4);
        const float* const a = now.area + k;
        const float area = (a[0] + a[1]) + (a[2] + a[3]);
        float more[LightTile::kChannels], most = 0.0f;
        for (size_t c = 0; c < size_t(tile.channels); ++c) {
          const float* v = now.shades.c[c] + k;
          more[c] = (a[0] * v[0] + a[1] * v[1]) + (a[2] * v[2] + a[3] * v[3]) -
                    area * tile.wholes()[c][whole];
          most = HWY_MAX(most, std::abs(more[c]) * pixel.encoding.by[c]);
        }
        mean.apart += most;
        all = most > by.apart * area && most > by.few;
        for (size_t c = 0; c < size_t(tile.channels) && !all; ++c)
          mean.closed.c[c] += more[c] * (1.0f / 3);
      }
      std::fill_n(opens, 4, all);
    }
    for (size_t q = k; q < end; ++q) {
      if (!(now.area[q] > 0.0f)) continue;
      (opens[q - k] ? of_open : of_closed)[q] = now.area[q];
      if (!opens[q - k]) continue;
      const auto at = size_t(mean.opens++);
      open[at] = list[which[q]];
      for (size_t c = 0; c < size_t(tile.channels) && !by.small; ++c)
        tile.of_open()[c][at] = now.shades.c[c][q];
    }
  }
  mean.closed.add(now.shades, of_closed, tile.channels);
  mean.open.add(now.shades, of_open, tile.channels);
}

/// Looks at the listed cells and lists the open ones in `open`: each of the others is a smooth stretch that is seen at
/// its middle.
inline void LookAtCells(CellPixel& pixel, const PartCells& cells, const CellList& list, int count,
                        OpenBy by, CellMean& mean, CellList& open) {
  const LightTile& tile = pixel.tile;
  SixteenCells now;
  std::uint16_t which[16];
  mean.jump = mean.kink = mean.apart = 0.0f, mean.opens = 0, mean.open = {};
  for (int next = 0, looks = 0;; ++looks) {
    const int n = TakeSixteen(pixel, cells, list, count, by.quarters, next, now, which);
    if (n == 0) break;
    SeeCells(pixel, !by.quarters && looks == 0, now);
    const float kink = KinkAmong(tile, now.shades, now.area, 0.1f), jump = MostOf16(now.jump);
    mean.kink = HWY_MAX(mean.kink, kink), mean.jump = HWY_MAX(mean.jump, jump);
    if (pixel.bends) by.small = false;
    if (by.small && kink <= by.kink && jump <= by.jump)
      mean.closed.add(now.shades, now.area, tile.channels);
    else
      OpenCells(pixel, now, which, n, list, by, mean, open);
  }
}

/// Divides the listed cells of a grid of `side` each way.
inline int DivideCells(int side, const CellList& cells, int count, CellList& to) {
  int made = 0;
  for (int k = 0; k < count; ++k) {
    const int first = 2 * (cells[size_t(k)] / side) * 2 * side + 2 * (cells[size_t(k)] % side);
    for (const int by : {0, 1, 2 * side, 2 * side + 1})
      to[size_t(made++)] = std::uint16_t(first + by);
  }
  return made;
}

/// The mean over a part of the pixel, or all of it. Cells that a ridge or a clamp runs through are divided further while
/// they may be off, which is of second order in their side; the others as far as they need it.
inline void MeanByCells(CellPixel pixel, const PartForm* form, float form_area, float* to) {
  // [of the tolerance] A clamp that begins in the pixel leaves a 53rd of its change to 4 × 4 cells, twice that where
  // it bends; ridges less than a thirtieth of their jump.
  constexpr float kKink = 24.0f, kJump = 10.0f, kAgree = 0.7f;
  // Of what is permitted to any: what closed cells may be off by.
  constexpr float kClosed = 0.3f;
  // [of the tolerance] What is permitted to quarters: to all of them, and to each of a few along an outline. And what
  // cells may be off by at first.
  constexpr float kApart = 1.0f, kFew = 0.04f, kFirst = 8.0f;
  // Of what cells are apart from theirs, in all or from mean to mean: how the means go on from the smallest cells, and
  // what may be left after these; what is left of cells that are settled. And how much of that a pixel bears [of the
  // tolerance], beside rounding: it may be off by six of these for 16 bits.
  constexpr float kOn = 0.4f, kSettled = 0.35f, kFine = 4.0f, kCoarse = 1.6f;
  const float last_left = pixel.tile.fine ? 0.45f : 0.27f;
  LightTile& tile = pixel.tile;
  const float allowed = tile.tolerance;
  float before[LightTile::kChannels] = {};
  pixel.seen = HWY_MAX(form_area, 0.05f);
  // Of that: cells that were closed with more left were closed too soon. Stops of a ramp cut a pixel into many parts,
  // whose doubts add up: each has its share.
  const float again = tile.segment ? 0.5f * pixel.seen : 0.5f;
  const float bend = BendAt(tile.lamp, pixel.cx, pixel.cy);
  const int begun = HWY_MIN(SideFor(bend, form_area, kFirst * allowed), 8);
  int first = begun;
  const int least = SideFor(bend, form_area, allowed);
  pixel.bends = tile.fine;
  CellList &list = tile.listed, &open = tile.open;
  CellMean mean;
  int count = first * first;
  std::iota(list.begin(), list.begin() + count, std::uint16_t{0});
  for (int side = first;; side *= 2) {
    if (form) cells_of_form(*form, side, tile.cells, side == 4 && !tile.fine);
    const PartCells& cells = form ? tile.cells : whole_cells(side);
    const bool small = !pixel.bends && side >= least;
    const bool last = side == PartCells::kMostSide;
    const float each = allowed * float(side * side) / (16.0f * pixel.seen);
    LookAtCells(pixel, cells, list, count,
                {kClosed * kJump * each, kClosed * kKink * each,
                 last ? 1e9f : kApart * allowed / pixel.seen, kFew * allowed, side > first, small},
                mean, open);
    const float area = mean.closed.area + mean.open.area, over = area > 0.0f ? 1.0f / area : 0.0f;
    float apart = 0.0f, change[LightTile::kChannels];
    for (int c = 0; c < tile.channels; ++c) to[c] = (mean.closed.c[c] + mean.open.c[c]) * over;
    pixel.shows(to);
    for (int c = 0; c < tile.channels; ++c) {
      change[c] = to[c] - before[c], before[c] = to[c];
      apart = HWY_MAX(apart, std::abs(change[c]) * pixel.encoding.by[c]);
    }
    const bool bounded = mean.kink < kKink * each && mean.jump < kJump * each;
    const bool agrees = side > first && apart * pixel.seen < kAgree * allowed;
    if (last || mean.opens == 0 || (small && !pixel.bends && (bounded || agrees))) {
      if (side == begun) return;
      const float left = (last ? last_left : kSettled) * HWY_MAX(mean.apart, apart * pixel.seen),
                  off = left / ((tile.fine ? kFine : kCoarse) * allowed);
      for (int c = 0; c < tile.channels && last; ++c) to[c] += kOn * change[c];
      if (last || off < again) return void(tile.off += off);
      first = 2 * side, count = first * first, mean = {}, pixel.bends = true;
      std::iota(list.begin(), list.begin() + count, std::uint16_t{0});
      continue;
    }
    count = DivideCells(side, open, mean.opens, list), tile.turned = !tile.turned;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
