// A pixel or a part of one by cells. Included once per instruction set.
//
// Where sixteen cells do not suffice, those that a ridge or a clamp runs through are divided, and those that do not agree
// with their quarters.
#if defined(MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#undef MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#else
#define MIEN_RENDER_SHADE_LIGHT_CELLS_INL_H_
#endif

#include "render/shade/light/seen_cells-inl.h"

#include <numeric>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Which of a level's cells are looked at: of the grid of that many each way, in its order.
using CellList = std::array<std::uint16_t, CellScratch::kMost>;

/// When cells stay open.
struct OpenBy {
  float jump, kink;  ///< more of these may be off
  float apart,
      few;  ///< by how much quarters may be apart from their whole; and that times their area, of a few
  bool quarters;      ///< whether the listed cells are quarters of cells that were open
  bool small;         ///< whether nothing but ridges and clamps can matter within a cell
  float bell = 0.0f;  ///< what of a highlight a cell may not see, times its area
  float half_cell =
      0.0f;  ///< half a diagonal of a cell, of the range among those looked at together
};

/// A level's cells: of a form, or of all of the pixel.
struct CellGrid {
  int side;
  const PartForm* form;
  const PartCells* cells;  ///< none: they are smaller, and looked for one by one

  bool is_empty(size_t k) const { return cells && !(cells->area[k] > 0.0f); }
};

/// A mean by cells, as far as they were looked at.
struct CellMean {
  CellSum closed, open;
  float jump = 0;   ///< the most that a ridge changes colours by in a cell
  float kink = 0;   ///< what a clamp of the law may change
  float apart = 0;  ///< what quarters were apart from their wholes, times areas
  float torn = 0;   ///< likewise where a ridge or a clamp may run through them
  int opens = 0;    ///< how many are open: the first of their list
};

/// Where cells of less than a thirty-second are, and what the form has of them.
inline void PlaceSmall(const CellPixel& pixel, const CellGrid& grid, const CellList& list,
                       const std::uint16_t* which, int count, SixteenCells& to) {
  PartSquares squares;
  squares.side = 1.0f / float(grid.side);
  for (size_t k = 0; k < PartSquares::kCount; ++k) {
    const int cell = list[which[k < size_t(count) ? k : 0]];
    squares.left[k] = float(cell % grid.side) * squares.side;
    squares.top[k] = float(cell / grid.side) * squares.side;
    squares.x[k] = squares.left[k] + 0.5f * squares.side - 0.5f;
    squares.y[k] = squares.top[k] + 0.5f * squares.side - 0.5f;
    squares.area[k] = squares.side * squares.side;
  }
  if (grid.form) squares_of_form(*grid.form, squares);
  for (size_t k = 0; k < size_t(count); ++k)
    to.x[k] = pixel.cx + squares.x[k], to.y[k] = pixel.cy + squares.y[k],
    to.area[k] = squares.area[k];
}

/// The next sixteen listed cells of more than no area; returns how many there are. `which`: their places in the list.
inline int TakeSixteen(const CellPixel& pixel, const CellGrid& grid, const CellList& list,
                       int count, bool quarters, int& next, SixteenCells& to,
                       std::uint16_t* which) {
  int n = 0;
  if (grid.side == 4) {  // all of them, be there some without area
    const PartCells& cells = *grid.cells;
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
      if (!grid.is_empty(list[size_t(k)])) return false;
    return true;
  };
  for (; next < count && n < 16; ++next) {
    const size_t k = list[size_t(next)];
    if (n % together == 0 && unseen(next)) {
      next += together - 1;
      continue;
    }
    which[n++] = std::uint16_t(next);
    if (!grid.cells) continue;
    to.x[n - 1] = pixel.cx + grid.cells->x[k], to.y[n - 1] = pixel.cy + grid.cells->y[k];
    to.area[n - 1] = grid.cells->area[k];
  }
  if (!grid.cells && n > 0) PlaceSmall(pixel, grid, list, which, n, to);
  for (int k = n; k < 16; ++k) to.x[k] = to.x[0], to.y[k] = to.y[0], to.area[k] = 0.0f;
  return n;
}

/// Which of sixteen cells a ridge or a clamp may run through: 1, or 0.
inline void FindBroken(const SixteenCells& now, const OpenBy& by, bool jumps, bool kinks,
                       float* broken) {
  const F f;
  alignas(64) float reach[3][16];
  for (size_t b = 0; b < 3 && kinks; ++b) {
    const float *v = now.shades.bounds[b], *u = now.shades.upper[b];
    if (!by.quarters) std::fill_n(reach[b], 16, by.half_cell * (MostOf16(u) - LeastOf16(v)));
    for (size_t k = 0; k < 16 && by.quarters; k += 4) {
      const float low = HWY_MIN(HWY_MIN(v[k], v[k + 1]), HWY_MIN(v[k + 2], v[k + 3]));
      const float high = HWY_MAX(HWY_MAX(u[k], u[k + 1]), HWY_MAX(u[k + 2], u[k + 3]));
      std::fill_n(reach[b] + k, 4, by.half_cell * (high - low));
    }
  }
  for (int k = 0; k < 16; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    const VF zero = hn::Zero(f);
    auto breaks = hn::Lt(zero, zero);
    if (jumps)
      breaks =
          hn::Or(hn::Gt(load(now.jump), Const(by.jump)), hn::Lt(load(now.away), Const(kNearCell)));
    for (int b = 0; b < 3 && kinks; ++b) {
      const VF away = hn::Max(load(now.shades.bounds[b]), hn::Neg(load(now.shades.upper[b])));
      breaks = hn::Or(breaks, hn::Le(away, load(reach[b])));
    }
    // Quarters along an outline see as deep as their whole, and agree with it whatever lies between.
    breaks = hn::Or(breaks, hn::Gt(hn::Mul(load(now.shades.bell), load(now.area)), Const(by.bell)));
    hn::Store(hn::IfThenElse(breaks, Const(1.0f), zero), f, broken + k);
  }
}

/// Closes cells but those that a ridge or a clamp may run through and, while cells are not small, those that are not
/// quarters which agree with their whole: a cell seen at its middle is off by the fourfold of what its quarters are, but
/// for terms of fourth degree.
inline void OpenCells(const CellPixel& pixel, const SixteenCells& now, const std::uint16_t* which,
                      int count, const CellList& list, const OpenBy& by, CellMean& mean,
                      CellList& open) {
  LightTile& tile = pixel.tile;
  alignas(64) float opens[16], of_open[16] = {}, of_closed[16] = {};
  FindBroken(now, by, mean.jump > by.jump, mean.kink > by.kink, opens);
  for (size_t k = 0; k < size_t(count); k += 4) {
    bool all = true;
    if (by.quarters) {
      const bool any = (opens[k] + opens[k + 1]) + (opens[k + 2] + opens[k + 3]) > 0.0f;
      const auto whole = size_t(which[k] / 4);
      const float* const a = now.area + k;
      const float area = (a[0] + a[1]) + (a[2] + a[3]);
      float more[LightTile::kChannels], most = 0.0f;
      for (size_t c = 0; c < size_t(tile.channels); ++c) {
        const float* v = now.shades.c[c] + k;
        more[c] = (a[0] * v[0] + a[1] * v[1]) + (a[2] * v[2] + a[3] * v[3]) -
                  area * tile.scratch->wholes()[c][whole];
        most = HWY_MAX(most, std::abs(more[c]) * pixel.encoding.by[c]);
      }
      (any ? mean.torn : mean.apart) += most;
      all = any || (most > by.apart * area && most > by.few);
      for (size_t c = 0; c < size_t(tile.channels) && !all && !by.small; ++c)
        mean.closed.c[c] += more[c] * (1.0f / 3);
    }
    if (!by.small) std::fill_n(opens + k, 4, all ? 1.0f : 0.0f);
  }
  const int before = mean.opens;
  for (size_t q = 0; q < size_t(count); ++q) {
    of_open[q] = opens[q] * now.area[q], of_closed[q] = now.area[q] - of_open[q];
    if (!(of_open[q] > 0.0f)) continue;
    const auto at = size_t(mean.opens++);
    open[at] = list[which[q]];
    for (size_t c = 0; c < size_t(tile.channels); ++c)
      tile.scratch->of_open()[c][at] = now.shades.c[c][q];
  }
  mean.closed.add(now.shades, of_closed, tile.channels);
  if (mean.opens > before) mean.open.add(now.shades, of_open, tile.channels);
}

/// Looks at the listed cells and lists the open ones in `open`: each of the others is a smooth stretch that is seen at
/// its middle.
inline void LookAtCells(CellPixel& pixel, const CellGrid& grid, const CellList& list, int count,
                        OpenBy by, CellMean& mean, CellList& open) {
  // [of the tolerance] Two depths leave a quarter of a highlight's peak at most. [of what closes cells] Where that much is
  // clamped, or jumps at a ridge, in one cell, no cell is taken for small.
  constexpr float kBellOfCell = 0.3f, kMuch = 36.0f, kRidge = 3.3f;
  const LightTile& tile = pixel.tile;
  SixteenCells now;
  std::uint16_t which[16];
  mean.jump = mean.kink = mean.apart = mean.torn = 0.0f, mean.opens = 0, mean.open = {};
  for (int next = 0, looks = 0;; ++looks) {
    const int n = TakeSixteen(pixel, grid, list, count, by.quarters, next, now, which);
    if (n == 0) break;
    // Half of what quarters range over, a sixth of what 4 × 4 cells do; and half as much again for their bends.
    by.half_cell = grid.side == 4 && LeastOf16(now.area) > 0.0f ? 0.25f : 0.75f;
    SeeCells(pixel, !by.quarters && looks == 0, now);
    by.bell = kBellOfCell * tile.tolerance / pixel.encoding.most();
    const float kink = KinkAmong(tile, now.shades, now.area, 0.1f), jump = MostOf16(now.jump);
    mean.kink = HWY_MAX(mean.kink, kink), mean.jump = HWY_MAX(mean.jump, jump);
    if (kink > kMuch * by.kink || jump > kMuch * kRidge * by.jump) pixel.bends = true;
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

/// Cells of how many each way are as thin as a part is: its area, by how long it is in cells.
inline float ThinnestSide(const PartCells& cells, float area) {
  int there = 0;
  for (size_t k = 0; k < size_t(cells.count()); ++k) there += cells.area[k] > 0.0f;
  return float(there) / (float(cells.side) * HWY_MAX(area, 1e-4f));
}

/// The mean over a part of the pixel, or all of it, by rounds of ever smaller cells. Those that a ridge or a clamp runs
/// through are divided further while they may be off, which is of second order in their side; the others as far as they
/// need it.
class CellRounds {
 public:
  /// `form`: none, all of the pixel.
  CellRounds(const CellPixel& pixel, const PartForm* form, float form_area)
      : pixel_(pixel),
        form_(form),
        form_area_(form_area),
        fine_(pixel.tile.fine),
        allowed_(pixel.tile.tolerance),
        scratch_(*pixel.tile.scratch) {
    pixel_.seen = HWY_MAX(form_area, 0.05f);
    pixel_.bend = BendAt(pixel_.tile.lamp, pixel_.cx, pixel_.cy);
    begun_ = HWY_MIN(SideFor(pixel_.bend, form_area, kFirst * allowed_), 8);
    least_ = SideFor(pixel_.bend, form_area, allowed_);
    pixel_.side = HWY_MAX(begun_, least_);
    pixel_.bends = fine_;
    const float few = HWY_MAX(pixel_.seen, kFewest);
    kink_by_ = kWholeKink * few, jump_by_ = kWholeJump * few;
  }

  /// Adds to the tile's `off` what the mean may be off by.
  void mean(float* to) {
    begin(begun_);
    for (int side = begun_;; side *= 2) {
      const Round round = look(side);
      if (!ends(round, take_mean(to))) {
        count_ = DivideCells(side, scratch_.open, mean_.opens, scratch_.listed);
        scratch_.turned = !scratch_.turned;
        continue;
      }
      if (side == begun_ || stays(round, to)) return;
      mean_ = {}, pixel_.bends = true;
      begin(2 * side);
    }
  }

 private:
  // [of the tolerance] A clamp that begins in the pixel leaves a 53rd of its change to 4 × 4 cells, twice that where
  // it bends, ridges less than a thirtieth of their jump; parts of few cells as much more as these are fewer.
  static constexpr float kWholeKink = 24.0f, kWholeJump = 10.0f, kFewest = 0.16f;
  // [of the tolerance] What cells may be off by at first.
  static constexpr float kFirst = 8.0f;
  static constexpr float kNever = 1e9f;

  struct Round {
    int side;
    float each;  ///< what one cell may be off by: the tolerance by how many cells bear it
    bool sees;   ///< whether cells are no larger than a part is thin
    bool small;  ///< whether nothing but ridges and clamps can matter within a cell
    bool breaks_anew;
  };

  int finest() const { return fine_ ? 4 * PartCells::kMostSide : PartCells::kMostSide; }

  /// All cells of a grid.
  void begin(int side) {
    first_ = side, count_ = side * side;
    std::iota(scratch_.listed.begin(), scratch_.listed.begin() + count_, std::uint16_t{0});
  }

  CellGrid grid(int side) {
    const bool finer = side > PartCells::kMostSide;
    if (form_ && !finer) cells_of_form(*form_, side, scratch_.of_form, side == 4 && !fine_);
    if (form_ && side == begun_) seen_from_ = ThinnestSide(scratch_.of_form, form_area_);
    return {side, form_, finer ? nullptr : form_ ? &scratch_.of_form : &whole_cells(side)};
  }

  Round look(int side) {
    // Of what is permitted to any: what closed cells may be off by.
    constexpr float kClosed = 0.3f;
    // [of the tolerance] What is permitted to quarters: to all of them, and to each of a few along an outline.
    constexpr float kApart = 2.5f, kFew = 0.1f, kFewFine = 0.03f;
    // Cells at a part's tips see too little of it to agree on, and none sees across what is thinner than it.
    constexpr int kClosesFrom = 16, kClosesBroken = 32;
    const CellGrid cells = grid(side);
    Round round{.side = side,
                .each = allowed_ * float(side * side) / (16.0f * pixel_.seen),
                .sees = side >= finest() || float(side) >= seen_from_,
                .small = !pixel_.bends && side >= least_,
                .breaks_anew = false};
    const float jumps = jump_by_ * round.each, kinks = kink_by_ * round.each;
    const bool broken = jump_ > jumps || kink_ > kinks;
    const int closes_from = broken ? kClosesBroken : form_ ? kClosesFrom : 0;
    const float closes = (fine_ && side < closes_from) || !round.sees ? -1.0f : 1.0f;
    LookAtCells(pixel_, cells, scratch_.listed, count_,
                {kClosed * jump_by_ * round.each, kClosed * kink_by_ * round.each,
                 side == finest() ? kNever : closes * kApart * allowed_ / pixel_.seen,
                 closes * (fine_ ? kFewFine : kFew) * allowed_, side > first_, round.small},
                mean_, scratch_.open);
    // A ridge or a clamp that larger cells did not see may change more than this once it is divided.
    round.breaks_anew = mean_.jump > 2.0f * jump_ + jumps || mean_.kink > 2.0f * kink_ + kinks;
    jump_ = mean_.jump, kink_ = mean_.kink;
    return round;
  }

  /// By how much the mean is apart from the one before.
  float take_mean(float* to) {
    const float area = mean_.closed.area + mean_.open.area, over = area > 0.0f ? 1.0f / area : 0.0f;
    const int channels = pixel_.tile.channels;
    for (int c = 0; c < channels; ++c) to[c] = (mean_.closed.c[c] + mean_.open.c[c]) * over;
    pixel_.shows(to);
    float apart = 0.0f;
    for (int c = 0; c < channels; ++c) {
      change_[c] = to[c] - before_[c], before_[c] = to[c];
      apart = HWY_MAX(apart, std::abs(change_[c]) * pixel_.encoding.by[c]);
    }
    return apart_ = apart * pixel_.seen;
  }

  /// Whether smaller cells would tell no more.
  bool ends(const Round& round, float apart) {
    // [of the tolerance] How much means may differ that agree, and what cells with kinks may be apart in all where sums of
    // theirs agree; for 16 bits both together, and less than that shows that no cell has crossed a kink yet.
    constexpr float kAgree = 0.7f, kTorn = 3.0f, kSettles = 2.0f, kUnseen = 0.25f, kAtOnce = 0.25f;
    const int side = round.side;
    // Sums agree by chance, too: they converge by the square of the side.
    const float now = side > first_ ? HWY_MAX(apart, mean_.apart + mean_.torn) : kNever;
    const bool converges =
        now_ < 4.0f * kSettles * allowed_ || now < (fine_ ? kAtOnce : 2.0f * kAtOnce) * allowed_;
    now_ = now;
    const bool full = 4 * mean_.opens > CellScratch::kMost;
    if (side == finest() || full || mean_.opens == 0) return true;
    // A ridge or a clamp that no cell has crossed yet may cut off the corner of a cell.
    const bool unseen = mean_.torn < kUnseen * allowed_ &&
                        HWY_MAX(mean_.kink, mean_.jump) > allowed_ * float(side * side);
    if (round.sees && fine_ && !round.breaks_anew && !unseen && now < kSettles * allowed_ &&
        converges)
      return true;
    if (!round.small || pixel_.bends) return false;
    const bool bounded = mean_.kink < kink_by_ * round.each && mean_.jump < jump_by_ * round.each;
    return bounded || (round.sees && converges && apart < kAgree * allowed_ && side > first_ &&
                       mean_.torn < kTorn * allowed_);
  }

  /// Whether the mean of the last round is close enough; cells that were closed with more left were closed too soon.
  bool stays(const Round& round, float* to) {
    // Of what cells are apart from theirs, in all or from mean to mean: how the means go on from the smallest cells, and
    // what may be left after these; what is left of cells that are settled. And how much of that a pixel bears [of the
    // tolerance], beside rounding: it may be off by six of these for 16 bits.
    constexpr float kOn = 0.4f, kSettled = 0.35f, kLast = 0.27f, kLastFine = 0.45f, kFine = 3.0f,
                    kCoarse = 1.3f;
    // Stops of a ramp cut a pixel into many parts, whose doubts add up: each has its share.
    const float again = pixel_.tile.segment ? 0.5f * HWY_MAX(form_area_, 0.05f) : 0.5f;
    const bool at_end = round.side >= PartCells::kMostSide;
    const float left = (at_end ? (fine_ ? kLastFine : kLast) : kSettled) *
                       HWY_MAX(mean_.apart + mean_.torn, apart_),
                off = left / ((fine_ ? kFine : kCoarse) * allowed_);
    if (round.side == finest())
      for (int c = 0; c < pixel_.tile.channels; ++c) to[c] += kOn * change_[c];
    if (!at_end && !(off < again)) return false;
    pixel_.tile.off += off;
    return true;
  }

  CellPixel pixel_;
  const PartForm* form_;
  float form_area_;
  bool fine_;
  float allowed_;
  CellScratch& scratch_;
  float kink_by_ = 0, jump_by_ = 0;
  int begun_ = 0, least_ = 0, first_ = 0, count_ = 0;
  float seen_from_ = 0;
  float before_[LightTile::kChannels] = {}, change_[LightTile::kChannels] = {};
  float jump_ = 0, kink_ = 0, now_ = kNever, apart_ = 0;  ///< of the round before
  CellMean mean_;
};

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
