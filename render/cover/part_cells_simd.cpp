// A form's cells, many at once. Compiled once per instruction set.
//
// A chord leaves to its right, in a cell, what lies between it and the cell's right side. Along the chord's height in
// the cell's row, x runs evenly from u0 to u1, seen from the cell's left side, and is held to the cell: three pieces,
// left of the cell, in it and right of it, each with its area and moments in closed form.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/cover/part_cells_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/cover/part_chords.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;

/// Areas, and moments about the left top corners.
struct CellSums {
  float *area, *x, *y;
};

/// Adds to a vector of cells with these corners, from `first` on.
HWY_INLINE void AddChord(const PartChord& c, float side, const CellSums& to, size_t first, VF left,
                         VF top) {
  const F f;
  const auto set = [&](float v) HWY_ATTR { return hn::Set(f, v); };
  const VF zero = hn::Zero(f), one = set(1.0f), cell = set(side), half = set(0.5f);
  const VF slope = set((c.xq - c.xp) / (c.yq - c.yp));
  const auto held = [&](VF v, VF most) HWY_ATTR { return hn::Min(hn::Max(v, zero), most); };
  const VF y0 = held(hn::Sub(set(c.yp), top), cell), y1 = held(hn::Sub(set(c.yq), top), cell);
  const VF dy = hn::Sub(y1, y0);
  const VF shift = hn::Sub(top, set(c.yp)), from = hn::Sub(set(c.xp), left);
  const VF u0 = Fused(slope, hn::Add(y0, shift), from), u1 = Fused(slope, hn::Add(y1, shift), from);
  const VF low = hn::Min(u0, u1), high = hn::Max(u0, u1), span = hn::Sub(high, low);
  const VF over = hn::Div(one, hn::Max(span, set(1e-6f)));
  const VF l = held(low, cell), r = held(high, cell);
  const auto level = hn::Lt(span, set(1e-5f));
  const VF is_before = hn::IfThenElse(hn::Lt(low, zero), one, zero);
  const VF is_in = hn::IfThenElse(hn::And(hn::Ge(low, zero), hn::Lt(low, cell)), one, zero);
  const VF before = hn::IfThenElse(level, is_before, held(hn::Mul(hn::Neg(low), over), one));
  const VF in = hn::IfThenElse(level, is_in, hn::Mul(hn::Sub(r, l), over));
  const VF m1 = hn::Mul(half, hn::Add(l, r));
  const VF m2 = hn::Mul(Fused(l, l, Fused(l, r, hn::Mul(r, r))), set(1.0f / 3));
  const VF by = hn::Mul(set(c.sign), dy), left_of = hn::Mul(cell, before);
  const VF right = hn::Sub(cell, m1);
  const auto add = [&](float* sums, VF value) HWY_ATTR {
    hn::Store(Fused(by, value, hn::Load(f, sums + first)), f, sums + first);
  };
  add(to.area, Fused(in, right, left_of));
  const VF more = hn::Mul(half, Fused(cell, cell, hn::Neg(m2)));
  add(to.x, Fused(in, more, hn::Mul(hn::Mul(half, cell), left_of)));
  // Where along the height each piece lies.
  const auto forward = hn::Gt(u1, u0);
  const VF before_at = hn::Mul(half, before);
  const VF middle = hn::IfThenElse(level, half, hn::Mul(hn::Sub(m1, low), over));
  const auto along = [&](VF share) HWY_ATTR {
    return Fused(dy, hn::IfThenElse(forward, share, hn::Sub(one, share)), y0);
  };
  const VF wide = hn::Sub(r, l), spread = hn::Mul(hn::Mul(wide, wide), set(1.0f / 12));
  const VF covariance = hn::IfThenElse(level, zero, hn::Mul(hn::Mul(dy, over), spread));
  const VF turned = hn::IfThenElse(forward, covariance, hn::Neg(covariance));
  const VF inner = Fused(along(middle), right, hn::Neg(turned));
  add(to.y, Fused(in, inner, hn::Mul(left_of, along(before_at))));
}

/// Of moments centroids from the pixel's middle; of cells of no more area than `none` the middle.
HWY_INLINE void SetCentroids(const CellSums& sums, size_t k, float cell, float none, VF left,
                             VF top) {
  const F f;
  const VF zero = hn::Zero(f), half = hn::Set(f, 0.5f * cell), most = hn::Set(f, cell * cell);
  const VF sum = hn::Load(f, sums.area + k);
  const auto any = hn::Gt(sum, hn::Set(f, none));
  const VF over = hn::Div(hn::Set(f, 1.0f), hn::IfThenElse(any, sum, hn::Set(f, 1.0f)));
  const auto centre = [&](float* moments, VF corner) HWY_ATTR {
    const VF in = hn::Min(hn::Max(hn::Mul(hn::Load(f, moments + k), over), zero), hn::Set(f, cell));
    const VF at = hn::Sub(hn::IfThenElse(any, in, half), hn::Set(f, 0.5f));
    hn::Store(hn::Add(at, corner), f, moments + k);
  };
  centre(sums.x, left), centre(sums.y, top);
  hn::Store(hn::IfThenElse(any, hn::Min(sum, most), zero), f, sums.area + k);
}

struct Corners {
  alignas(64) float left[PartCells::kMost], top[PartCells::kMost];
};

/// By side: 4, 8, 16, 32.
const Corners& CornersOf(int side) {
  static const std::array<Corners, 4> made = [] {
    std::array<Corners, 4> all;
    for (int k = 0; k < 4; ++k)
      for (int i = 0, n = 4 << k; i < n * n; ++i)
        all[size_t(k)].left[i] = float(i % n) / float(n),
        all[size_t(k)].top[i] = float(i / n) / float(n);
    return all;
  }();
  return made[side == 4 ? 0 : side == 8 ? 1 : side == 16 ? 2 : 3];
}

/// To the cells of the rows that the chord crosses.
void AddToRows(const PartChord& c, int side, PartCells& to) {
  if (!(c.yq > c.yp)) return;
  const F f;
  const Corners& corners = CornersOf(side);
  const CellSums sums{to.area.data(), to.x.data(), to.y.data()};
  const int first = std::clamp(int(c.yp * float(side)), 0, side - 1),
            last = std::clamp(int(c.yq * float(side)), 0, side - 1);
  const size_t lanes = hn::Lanes(f);
  for (size_t k = size_t(first * side) / lanes * lanes; k < size_t((last + 1) * side); k += lanes)
    AddChord(c, 1.0f / float(side), sums, k, hn::Load(f, corners.left + k),
             hn::Load(f, corners.top + k));
}

void CellsOfForm(const PartForm& form, int side, PartCells& to, bool coarse) {
  const F f;
  const float cell = 1.0f / float(side);
  const int rows = PartEntry::kRows / side;
  to.side = side;
  for (int j = 0, k = 0; j < side; ++j) {
    float height = 0.0f, height_y = 0.0f;
    for (int i = 0; i < rows; ++i, ++k) {
      const float y = (float(i) + 0.5f) / PartEntry::kRows;
      height += form.left.height[size_t(k)];
      height_y += form.left.height[size_t(k)] * y + form.left.moment[size_t(k)];
    }
    const size_t row = size_t(j * side);
    std::fill_n(&to.area[row], side, cell * height);
    std::fill_n(&to.x[row], side, 0.5f * cell * cell * height);
    std::fill_n(&to.y[row], side, cell * height_y);
  }
  const float fine = coarse ? kCoarseChords : kFineChords;
  for (const PartStretch& s : form.stretches)
    for_each_chord(s, fine, [&](const PartChord& c) { AddToRows(c, side, to); });
  const CellSums sums{to.area.data(), to.x.data(), to.y.data()};
  const Corners& corners = CornersOf(side);
  constexpr float kNoArea = 1e-6f;  // [px²] what rounding leaves of an empty area
  for (size_t k = 0; k < size_t(side * side); k += hn::Lanes(f))
    SetCentroids(sums, k, cell, kNoArea, hn::Load(f, corners.left + k),
                 hn::Load(f, corners.top + k));
}

void SquaresOfForm(const PartForm& form, PartSquares& to) {
  const F f;
  constexpr float kRow = 1.0f / PartEntry::kRows;
  for (size_t k = 0; k < PartSquares::kCount; ++k) {
    // What enters a thirty-second does so at one stretch of it.
    const auto row = size_t(HWY_MIN(to.top[k] / kRow, float(PartEntry::kRows - 1)));
    const float height = form.left.height[row], half = 0.5f * HWY_MIN(std::abs(height), kRow);
    const float middle =
        (float(row) + 0.5f) * kRow + (half > 0.0f ? form.left.moment[row] / height : 0.0f);
    const float from = HWY_MAX(middle - half - to.top[k], 0.0f),
                until = HWY_MIN(middle + half - to.top[k], to.side);
    const float enters = std::copysign(HWY_MAX(until - from, 0.0f), height);
    to.area[k] = to.side * enters, to.x[k] = 0.5f * to.side * to.side * enters;
    to.y[k] = to.side * enters * 0.5f * (from + until);
  }
  const CellSums sums{to.area.data(), to.x.data(), to.y.data()};
  for (const PartStretch& s : form.stretches)
    for_each_chord(s, kFineChords, [&](const PartChord& c) {
      for (size_t k = 0; c.yq > c.yp && k < PartSquares::kCount; k += hn::Lanes(f))
        AddChord(c, to.side, sums, k, hn::Load(f, &to.left[k]), hn::Load(f, &to.top[k]));
    });
  const float none = 1e-3f * to.side * to.side;  // of these rounding leaves less
  for (size_t k = 0; k < PartSquares::kCount; k += hn::Lanes(f))
    SetCentroids(sums, k, to.side, none, hn::Load(f, &to.left[k]), hn::Load(f, &to.top[k]));
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(CellsOfForm);
HWY_EXPORT(SquaresOfForm);
}  // namespace batch

void cells_of_form(const PartForm& form, int side, PartCells& to, bool coarse) {
  MIEN_DISPATCH(CellsOfForm)(form, side, to, coarse);
}

void squares_of_form(const PartForm& form, PartSquares& to) {
  MIEN_DISPATCH(SquaresOfForm)(form, to);
}

}  // namespace mien
#endif
