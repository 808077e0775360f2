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
      const BranchPair& r = *at.ramp;
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
  color = ColorAt(tile, up, nx, ny, cell.x, cell.y, away);
  const LitColor other = ColorAt(tile, down, nx, ny, cell.x, cell.y, away);
  for (int c = 0; c < LightTile::kChannels; ++c)
    color.c[c] = hn::Mul(Const(0.5f), hn::Add(color.c[c], other.c[c]));
}

/// Sees sixteen cells.
inline void SeeCells(const CellPixel& pixel, SixteenCells& cells) {
  // [px] Profiles as narrow as that are steep where cells are two depths wide.
  constexpr float kNarrow = 12.0f, kSteep = 1.75f;
  const F f;
  LightTile& tile = pixel.tile;
  Seen at;
  SeeFrom(tile, pixel.near, pixel.cx, pixel.cy, cells.x, cells.y, at);
  const bool steep = tile.rises && tile.lamp.is_round() && tile.lamp.width < kNarrow &&
                     MostOf16(at.relief.best.d) > -kSteep;
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    CellLanes cell{load(cells.x), load(cells.y), load(cells.area), {}, {}};
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
      const VF away = tile.lamp.goes_by_distance() ? load(at.ramp->best.d) : zero;
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
    hn::Store(jump, f, cells.jump + k);
    hn::Store(hn::Div(ridge.off, hn::Max(cell.side, Const(1e-6f))), f, cells.away + k);
    PutColor(color, k, cells.shades);
  }
}

/// Which of a level's cells are looked at: of the grid of that many each way, in its order.
using CellList = std::array<std::uint16_t, PartCells::kMost>;

/// A mean by cells, as far as they were looked at.
struct CellMean {
  CellSum closed, open;  ///< open: cells that a ridge or a clamp may run through
  float jump = 0;        ///< the most that a ridge changes colours by in a cell
  float kink = 0;        ///< what a clamp of the law may change
  int opens = 0;         ///< how many are open: the first of their list
};

/// The next sixteen listed cells of more than no area; returns how many there are. `which`: their places in the list.
inline int TakeSixteen(const CellPixel& pixel, const PartCells& cells, const CellList& list,
                       int count, int& next, SixteenCells& to, std::uint16_t* which) {
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
  const int together = pixel.tile.fine ? 4 : 1;  // the quarters of a cell
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

/// When cells stay open.
struct OpenBy {
  /// More of these may be off.
  float jump, kink;
  /// For 16 bits: by how much quarters may be apart from their whole; and that times their area, of a few.
  float apart, few;
  /// Whether the listed cells are quarters of cells that were open.
  bool quarters;
};

/// [of the range among cells] Half a diagonal of a cell, where the range is that of three of them or less.
inline constexpr float kHalfCell = 0.75f;
/// [of a cell's side] A ridge that bends may run through it.
inline constexpr float kNearCell = 1.3f;

/// For 16 bits: opens cells but those that are quarters of a cell which nothing runs through and which they agree with.
/// A cell seen at its middle is off by the fourfold of what its quarters are, but for terms of fourth degree.
inline void OpenQuarters(LightTile& tile, const SixteenCells& now, const std::uint16_t* which,
                         int count, const CellList& list, const OpenBy& by, CellMean& mean,
                         CellList& open) {
  for (size_t k = 0; k < size_t(count); k += 4) {
    CellSum sum;
    const float* area = now.area + k;
    for (size_t q = 0; q < 4; ++q) {
      sum.area += area[q];
      for (size_t c = 0; c < size_t(tile.channels); ++c)
        sum.c[c] += area[q] * now.shades.c[c][k + q];
    }
    if (!(sum.area > 0.0f)) continue;
    bool opens = !by.quarters;
    for (size_t q = k; q < k + 4; ++q)
      opens = opens || now.jump[q] > by.jump || (mean.jump > by.jump && now.away[q] < kNearCell);
    for (int b = 0; b < 3 && !opens && mean.kink > by.kink; ++b) {
      const float* v = now.shades.bounds[b] + k;
      const float low = HWY_MIN(HWY_MIN(v[0], v[1]), HWY_MIN(v[2], v[3])),
                  high = HWY_MAX(HWY_MAX(v[0], v[1]), HWY_MAX(v[2], v[3]));
      const float reach = kHalfCell * (high - low);
      opens = low <= reach && high >= -reach;
    }
    float apart = 0.0f;
    const auto whole = size_t(which[k] / 4);
    for (size_t c = 0; c < size_t(tile.channels) && !opens; ++c)
      apart = HWY_MAX(apart, std::abs(sum.c[c] / sum.area - tile.wholes[c][whole]));
    opens = opens || (apart > by.apart && apart * sum.area > by.few);
    CellSum& to = opens ? mean.open : mean.closed;
    to.area += sum.area;
    for (size_t c = 0; c < size_t(tile.channels); ++c)
      to.c[c] +=
          opens ? sum.c[c] : sum.c[c] + (sum.c[c] - sum.area * tile.wholes[c][whole]) * (1.0f / 3);
    for (size_t q = 0; opens && q < 4; ++q) {
      if (!(area[q] > 0.0f)) continue;
      const auto at = size_t(mean.opens++);
      open[at] = list[which[k + q]];
      for (size_t c = 0; c < size_t(tile.channels); ++c)
        tile.of_open[c][at] = now.shades.c[c][k + q];
    }
  }
}

/// Looks at the listed cells and lists the open ones in `open`: each of the others is a smooth stretch that is seen at
/// its middle.
inline void LookAtCells(const CellPixel& pixel, const PartCells& cells, const CellList& list,
                        int count, const OpenBy& by, CellMean& mean, CellList& open) {
  LightTile& tile = pixel.tile;
  SixteenCells now;
  std::uint16_t which[16];
  mean.jump = mean.kink = 0.0f, mean.opens = 0, mean.open = {};
  for (int next = 0;;) {
    const int n = TakeSixteen(pixel, cells, list, count, next, now, which);
    if (n == 0) break;
    SeeCells(pixel, now);
    const float kink = KinkAmong(tile, now.shades, now.area, 0.1f), jump = MostOf16(now.jump);
    mean.kink = HWY_MAX(mean.kink, kink), mean.jump = HWY_MAX(mean.jump, jump);
    if (tile.fine) {
      OpenQuarters(tile, now, which, n, list, by, mean, open);
      continue;
    }
    if (kink <= by.kink && jump <= by.jump) {
      mean.closed.add(now.shades, now.area, tile.channels);
      continue;
    }
    float reach[3] = {-1.0f, -1.0f, -1.0f};
    for (int b = 0; b < 3 && kink > by.kink; ++b) {
      const Range range = RangeOf16(now.shades.bounds[b], now.area);
      reach[b] = kHalfCell * (range.high - range.low);
    }
    alignas(64) float of_open[16] = {}, of_closed[16] = {};
    for (int k = 0; k < n; ++k) {
      if (!(now.area[k] > 0.0f)) continue;
      bool opens = now.jump[k] > by.jump || (jump > by.jump && now.away[k] < kNearCell);
      for (int b = 0; b < 3; ++b) opens = opens || std::abs(now.shades.bounds[b][k]) <= reach[b];
      (opens ? of_open : of_closed)[k] = now.area[k];
      if (opens) open[size_t(mean.opens++)] = list[which[k]];
    }
    mean.closed.add(now.shades, of_closed, tile.channels);
    mean.open.add(now.shades, of_open, tile.channels);
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

/// Into how many cells each way a part must be divided at least. Over a round profile's width w, or over a narrow dome
/// or the highlight on one, colours make all their change, some 200 levels with a bend of 4 / w²: cells of side h leave
/// 33 (h / w)² of its area, and half of that at most by two depths.
inline int LeastSide(const LightTile& tile, float area, float allowed) {
  float width = 2.0f * tile.lamp.finest;
  if (tile.rises && tile.lamp.is_round()) width = HWY_MIN(width, tile.lamp.width);
  const float most = 0.066f * area / HWY_MAX(allowed, 1e-9f);  // of (w / h)²
  int side = 4;
  while (side < PartCells::kMostSide && width * width * float(side * side) < most) side *= 2;
  return side;
}

/// The mean over a part of the pixel, or all of it. Cells that a ridge or a clamp runs through are divided further while
/// they may be off, which is of second order in their side.
inline void MeanByCells(const CellPixel& pixel, const PartForm* form, float form_area, float* to) {
  // [of the tolerance] A clamp that begins in the pixel leaves a 53rd of its change to 4 × 4 cells; ridges less than a
  // thirtieth of their jump.
  constexpr float kKink = 45.0f, kJump = 10.0f, kAgree = 0.7f;
  // Of what is permitted to any; and what this may shrink to in darker pixels before closed cells count again.
  constexpr float kClosed = 0.3f, kStricter = 0.8f;
  // Of what is permitted to quarters: to all of them, and to each of a few along an outline.
  constexpr float kApart = 1.0f, kFew = 0.04f;
  LightTile& tile = pixel.tile;
  float before[LightTile::kChannels] = {}, allowed = tile.tolerance;
  // Cells for 16 bits are divided where they need it, and begin as those for 8.
  const float coarse = tile.fine ? 8.0f : 1.0f;
  int side = LeastSide(tile, form_area, coarse * allowed), least = side, count = side * side;
  CellList &list = tile.listed, &open = tile.open;
  CellMean mean;
  bool quarters = false;
  const auto begin = [&](int now) {
    mean = {}, side = least = now, count = now * now, quarters = false;
    std::iota(list.begin(), list.begin() + count, std::uint16_t{0});
  };
  begin(side);
  for (;;) {
    if (form) cells_of_form(*form, side, tile.cells, side == 4 && !tile.fine);
    const PartCells& cells = form ? tile.cells : whole_cells(side);
    const float finer = float(side * side) / 16.0f, seen = HWY_MAX(form_area, 0.05f);
    const float most_jump = kJump * finer / seen, most_kink = kKink * finer / seen;
    LookAtCells(pixel, cells, list, count,
                {kClosed * most_jump * allowed, kClosed * most_kink * allowed,
                 kApart * allowed / seen, kFew * allowed, quarters},
                mean, open);
    const float area = mean.closed.area + mean.open.area, over = area > 0.0f ? 1.0f / area : 0.0f;
    float apart = 0.0f;
    for (int c = 0; c < tile.channels; ++c) {
      to[c] = (mean.closed.c[c] + mean.open.c[c]) * over;
      apart = HWY_MAX(apart, std::abs(to[c] - before[c])), before[c] = to[c];
    }
    if (side == PartCells::kMostSide) return;
    const float before_that = allowed;
    // What shows of a part lies in a pixel no darker than that.
    if (tile.lamp.linear) allowed = AllowedAt(tile, seen * HWY_MIN(to[0], HWY_MIN(to[1], to[2])));
    const bool bounded = mean.kink < most_kink * allowed && mean.jump < most_jump * allowed;
    const bool agrees = side > least && apart * seen < kAgree * allowed;
    const int now = HWY_MAX(side, LeastSide(tile, form_area, coarse * allowed));
    if (now == side && (tile.fine ? bounded && agrees && side > 2 * least : bounded || agrees))
      return;
    if (now > side || allowed < kStricter * before_that) {
      begin(now);  // all of them again: too many were closed
      continue;
    }
    if (mean.opens == 0) return;
    count = DivideCells(side, open, mean.opens, list), side *= 2, quarters = true;
    std::swap(tile.wholes, tile.of_open);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
