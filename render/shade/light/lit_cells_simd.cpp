// Cells of a pixel in lanes. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/light/lit_cells_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/blend/transfer.h"
#include "render/shade/light/cell_cut-inl.h"
#include "render/shade/light/lamp_lanes-inl.h"
#include "render/shade/light/lit_cells.h"
#include "render/shade/light/ridge-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Gradients closer than this are one branch: what is left of their difference makes a level at a slope of 1.
constexpr float kSameBranch = 0.02f;

/// Depths in a zone, and what cells are like there.
struct Zone {
  const LampLanes& lamp;
  VF shallow, deep, spread;  ///< spread: variance of the depth within a whole cell
};

/// The light over what is left of a cell by Gauss's four places along the gradient: for profiles that rise and shine
/// within a few cells. `most`: how far up and down the cell's part goes, at most.
HWY_INLINE LitColor ColorOfFour(const Zone& zone, VF share, VF most, const Spot& at, VF x, VF y) {
  constexpr float kPlace[] = {-0.86113631f, -0.33998104f, 0.33998104f, 0.86113631f};
  constexpr float kWeight[] = {0.17392742f, 0.32607258f, 0.32607258f, 0.17392742f};
  const F f;
  const VF depth = hn::Max(hn::Neg(at.d), zone.shallow);
  // Depths spread evenly by √3 times their deviation, but none beyond the zone's end.
  const VF even = hn::Sqrt(hn::Mul(hn::Mul(zone.spread, share), Const(3.0f)));
  const VF reach = hn::Min(hn::Min(even, most), hn::Sub(depth, zone.shallow));
  const VF zero = hn::Zero(f);
  LitColor mean{zero, zero, zero, {zero, zero, zero}};
  for (int k = 0; k < 4; ++k) {
    const VF there = hn::Min(Fused(Const(kPlace[k]), reach, depth), zone.deep);
    const LitColor c = LitAt(zone.lamp, there, at.nx, at.ny, x, y);
    const auto add = [&](VF& sum, VF v) HWY_ATTR { sum = Fused(Const(kWeight[k]), v, sum); };
    add(mean.r, c.r), add(mean.g, c.g), add(mean.b, c.b);
    for (int i = 0; i < 3; ++i) add(mean.bounds[i], c.bounds[i]);
  }
  return mean;
}

/// The light over what is left of a cell, by one place. Where the profile is round, light goes like √depth: for depths
/// of mean m and variance q m² the mean of √ is that at m (1 − q/4 (1 + q)), an outline's strips (q = 1/3) and corners
/// (q = 1/2) within 2 %.
HWY_INLINE LitColor ColorOf(const Zone& zone, VF share, VF most, const Spot& at, VF x, VF y) {
  if (zone.lamp.is_narrow()) return ColorOfFour(zone, share, most, at, x, y);
  VF depth = hn::Min(hn::Max(hn::Neg(at.d), zone.shallow), zone.deep);
  if (zone.lamp.rise_kind == LampLanes::Rise::round) {
    const VF m2 = hn::Max(hn::Mul(depth, depth), Const(1e-12f));
    const VF q = hn::Min(hn::Div(hn::Mul(zone.spread, share), m2), Const(0.42f));
    const VF quarter = hn::Mul(q, Const(0.25f));
    depth = FusedFrom(hn::Mul(depth, quarter), hn::Add(q, Const(1.0f)), depth);
  }
  return LitAt(zone.lamp, depth, at.nx, at.ny, x, y);
}

HWY_INLINE VF Mixed(VF share, VF a, VF b) {
  return Fused(share, hn::Sub(b, a), a);
}

HWY_INLINE Spot MovedBy(const Spot& at, VF ex, VF ey, VF way) {
  return {Fused(Fused(at.nx, ex, hn::Mul(at.ny, ey)), way, at.d), at.nx, at.ny};
}

/// A cell that a ridge cuts: two branches, each at the middle of its part. What is left of a cell is treated as a
/// square of that area around its centroid. `jump`: by how much the branches' colours differ there, else 0.
HWY_INLINE void MixRidge(const Zone& zone, VF side, VF left, const Spot& here, const Ridge& ridge,
                         VF x, VF y, LitColor& color, VF& jump) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f);
  const auto cut = CutCell(f, hn::Neg(ridge.offset), ridge.ex, ridge.ey, side);
  const auto touched = hn::And(hn::Lt(ridge.offset, side), hn::Gt(cut.area, zero));
  if (hn::AllFalse(f, touched)) return;
  const VF share = hn::IfThenElseZero(touched, cut.area), way = hn::Add(ridge.offset, cut.t);
  const VF back = hn::Neg(hn::Div(hn::Mul(share, way), hn::Max(hn::Sub(one, share), Const(0.1f))));
  const auto color_at = [&](const Spot& at, VF along, VF part) HWY_ATTR {
    // A part's depths end at the ridge.
    const VF up = hn::Abs(Fused(at.nx, ridge.ex, hn::Mul(at.ny, ridge.ey)));
    const VF most = hn::Div(hn::Abs(hn::Sub(ridge.offset, along)), hn::Max(up, Const(1e-3f)));
    return ColorOf(zone, hn::Mul(left, part), most, MovedBy(at, ridge.ex, ridge.ey, along),
                   Fused(ridge.ex, along, x), Fused(ridge.ey, along, y));
  };
  const LitColor near = color_at(here, back, hn::Sub(one, share)),
                 far = color_at(ridge.beyond, way, share);
  const auto mix = [&](VF& c, VF a, VF b) HWY_ATTR {
    c = hn::IfThenElse(touched, Mixed(share, a, b), c);
    jump = hn::Max(jump, hn::IfThenElseZero(touched, hn::Abs(hn::Sub(b, a))));
  };
  mix(color.r, near.r, far.r), mix(color.g, near.g, far.g), mix(color.b, near.b, far.b);
}

/// Of the cell at k, whose centroid is (x, y) from the tile's.
Ridge NearestRidge(const LitCells& cells, size_t k, const Spot& here, VF x, VF y) {
  const F f;
  Ridge ridge = NoRidge();
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      if (i == 0 && j == 0) continue;
      const size_t at = size_t(std::ptrdiff_t(k) + j * cells.row + i);
      const VF from_x = hn::Sub(x, hn::LoadU(f, &cells.foot_x[at])),
               from_y = hn::Sub(y, hn::LoadU(f, &cells.foot_y[at]));
      Consider(here,
               SeenFrom(hn::LoadU(f, &cells.d[at]), hn::LoadU(f, &cells.nx[at]),
                        hn::LoadU(f, &cells.ny[at]), hn::LoadU(f, &cells.bend[at]), from_x, from_y),
               kSameBranch, ridge);
    }
  return ridge;
}

/// Sums over cells, and their colours by place.
struct Sums {
  VF area, x, y, xx, xy, yy, r, g, b;
  VF rx, ry, gx, gy, bx, by;
  VF jump, unsure, turn;
  VF least[3], most[3];  ///< of LitColor::bounds
};

/// Colours of a vector of cells, with what ridges do.
HWY_INLINE LitColor ColorAt(const Zone& zone, const LitCells& cells, size_t k, VF area,
                            Sums& sums) {
  const F f;
  const float cell = 1.0f / float(cells.side);
  const VF x = hn::LoadU(f, &cells.at_x[k]), y = hn::LoadU(f, &cells.at_y[k]);
  const VF px = hn::Add(x, Const(cells.x)), py = hn::Add(y, Const(cells.y));
  const VF share = hn::Mul(area, Const(float(cells.side * cells.side)));
  if (!cells.ringed) {
    const FootAt& foot = cells.foot;
    const Spot here =
        SeenFrom(Const(foot.d), Const(foot.nx), Const(foot.ny), Const(foot.bend), x, y);
    return ColorOf(zone, share, Const(1.0f), here, px, py);
  }
  const VF bend = hn::LoadU(f, &cells.bend[k]);
  const Spot here{hn::LoadU(f, &cells.d[k]), hn::LoadU(f, &cells.nx[k]),
                  hn::LoadU(f, &cells.ny[k])};
  LitColor color = ColorOf(zone, share, Const(1.0f), here, px, py);
  const auto there = hn::Gt(area, hn::Zero(f));
  sums.turn = hn::Max(sums.turn, hn::IfThenElseZero(there, hn::Mul(hn::Abs(bend), Const(cell))));
  const Ridge ridge = NearestRidge(cells, k, here, px, py);
  if (hn::AllFalse(f, hn::And(there, hn::Lt(ridge.offset, Const(0.75f * cell))))) return color;
  const VF side = hn::Mul(hn::Sqrt(share), Const(cell));
  VF jump = hn::Zero(f);
  MixRidge(zone, side, share, here, ridge, px, py, color, jump);
  jump = hn::IfThenElseZero(there, jump);
  sums.jump = hn::Max(sums.jump, jump);
  const auto twice = hn::Or(hn::Lt(ridge.next, Const(0.75f * cell)), hn::Lt(share, Const(0.999f)));
  sums.unsure = hn::Add(sums.unsure, hn::IfThenElseZero(twice, hn::Mul(jump, area)));
  return color;
}

/// How far colours are from the nearest plane: from their sums, minus what the plane explains.
struct Plane {
  float mean, x, y;
};

HWY_INLINE float Sum(VF v) {
  return hn::GetLane(hn::SumOfLanes(F(), v));
}
HWY_INLINE float Most(VF v) {
  return hn::GetLane(hn::MaxOfLanes(F(), v));
}

struct Moments {
  float area, x, y, xx, xy, yy;
};

Plane PlaneOf(const Moments& m, float c, float cx, float cy) {
  const float mean = c / m.area, ux = cx / m.area - mean * m.x, uy = cy / m.area - mean * m.y;
  const float whole = m.xx * m.yy - m.xy * m.xy;
  return {mean, (m.yy * ux - m.xy * uy) / whole, (m.xx * uy - m.xy * ux) / whole};
}

/// How much the law would vary over the cells without its clamps, if one of them begins within the cells or so
/// close beside their middles that it may; else 0. In the blending space, around `dark`.
float KinkOf(const LampLanes& lamp, const Sums& s, float dark) {
  constexpr float kBeyond = 0.35f;  // of the range at the middles
  const float light = HWY_MAX(lamp.light[0], HWY_MAX(lamp.light[1], lamp.light[2]));
  const float weight[] = {lamp.diffuse * (lamp.ramp.kind == LampRamp::Kind::none ? light : 1.0f),
                          lamp.shine, 1.0f};
  float kink = 0.0f;
  for (int i = 0; i < 3; ++i) {
    const float least = hn::GetLane(hn::MinOfLanes(F(), s.least[i])), most = Most(s.most[i]),
                range = most - least, beyond = kBeyond * range;
    const bool begins = most + beyond > 0.0f && (i == 2 || least - beyond < 0.0f);
    if (begins) kink = HWY_MAX(kink, weight[i] * range);
  }
  if (lamp.linear || kink == 0.0f) return kink;
  return kink * float(encoding_slope(linear_from_srgb(double(dark))));
}

/// The cells without the rows above and below of a ring around them.
struct Span {
  size_t begin, end;
};

Span CellsOf(const LitCells& cells) {
  if (!cells.ringed) return {0, size_t(cells.row * cells.row)};
  return {size_t(cells.row + 1), size_t(cells.row * (cells.row - 1) - 1)};
}

/// Keeps the cells' colours.
Sums SumOver(const LampLanes& lamp, LitCells& cells) {
  const F f;
  const VF zero = hn::Zero(f);
  const float cell = 1.0f / float(cells.side);
  const Zone zone{lamp, Const(cells.shallow), Const(cells.deep), Const(cell * cell / 12)};
  Sums s{zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
         zero, zero, zero, zero, zero, zero, zero, zero, {},   {}};
  std::fill_n(s.least, 3, Const(1e9f)), std::fill_n(s.most, 3, Const(-1e9f));
  const Span span = CellsOf(cells);
  for (size_t k = span.begin; k < span.end; k += hn::Lanes(f)) {
    const VF area = hn::LoadU(f, &cells.area[k]);
    if (hn::AllTrue(f, hn::Eq(area, zero))) continue;
    const LitColor c = ColorAt(zone, cells, k, area, s);
    hn::StoreU(c.r, f, &cells.r[k]), hn::StoreU(c.g, f, &cells.g[k]);
    hn::StoreU(c.b, f, &cells.b[k]);
    const auto there = hn::Gt(area, zero);
    for (int i = 0; i < 3; ++i) {
      s.least[i] = hn::Min(s.least[i], hn::IfThenElse(there, c.bounds[i], Const(1e9f)));
      s.most[i] = hn::Max(s.most[i], hn::IfThenElse(there, c.bounds[i], Const(-1e9f)));
    }
    const VF x = hn::LoadU(f, &cells.at_x[k]), y = hn::LoadU(f, &cells.at_y[k]);
    const VF ax = hn::Mul(area, x), ay = hn::Mul(area, y);
    s.area = hn::Add(s.area, area), s.x = hn::Add(s.x, ax), s.y = hn::Add(s.y, ay);
    s.xx = Fused(ax, x, s.xx), s.xy = Fused(ax, y, s.xy), s.yy = Fused(ay, y, s.yy);
    s.r = Fused(area, c.r, s.r), s.g = Fused(area, c.g, s.g), s.b = Fused(area, c.b, s.b);
    s.rx = Fused(ax, c.r, s.rx), s.gx = Fused(ax, c.g, s.gx), s.bx = Fused(ax, c.b, s.bx);
    s.ry = Fused(ay, c.r, s.ry), s.gy = Fused(ay, c.g, s.gy), s.by = Fused(ay, c.b, s.by);
  }
  return s;
}

/// How far from a plane the cells' colours are, and how far that plane's from the mean.
void JudgePlane(const LitCells& cells, const Sums& s, float all, LitMean& mean) {
  const F f;
  const float over = 1.0f / all;
  Moments m{all, Sum(s.x) * over, Sum(s.y) * over, 0, 0, 0};
  constexpr float kWide = 1e-5f;  // [px²] keeps what has no width solvable
  m.xx = Sum(s.xx) * over - m.x * m.x + kWide, m.yy = Sum(s.yy) * over - m.y * m.y + kWide;
  m.xy = Sum(s.xy) * over - m.x * m.y;
  const Plane planes[] = {PlaneOf(m, Sum(s.r), Sum(s.rx), Sum(s.ry)),
                          PlaneOf(m, Sum(s.g), Sum(s.gx), Sum(s.gy)),
                          PlaneOf(m, Sum(s.b), Sum(s.bx), Sum(s.by))};
  const float* const channels[] = {cells.r.data(), cells.g.data(), cells.b.data()};
  VF off[] = {hn::Zero(f), hn::Zero(f), hn::Zero(f)};
  const Span span = CellsOf(cells);
  for (size_t k = span.begin; k < span.end; k += hn::Lanes(f)) {
    const VF area = hn::LoadU(f, &cells.area[k]);
    if (hn::AllTrue(f, hn::Eq(area, hn::Zero(f)))) continue;
    const VF x = hn::Sub(hn::LoadU(f, &cells.at_x[k]), Const(m.x));
    const VF y = hn::Sub(hn::LoadU(f, &cells.at_y[k]), Const(m.y));
    for (int i = 0; i < 3; ++i) {
      const Plane& p = planes[i];
      const VF plane = Fused(x, Const(p.x), Fused(y, Const(p.y), Const(p.mean)));
      const VF by = hn::Sub(hn::LoadU(f, channels[i] + k), plane);
      off[i] = hn::Add(off[i], hn::Mul(area, hn::Mul(by, by)));
    }
  }
  float lean = 0.0f;
  for (const Plane& p : planes)
    lean = HWY_MAX(lean, p.x * p.x * m.xx + 2 * p.x * p.y * m.xy + p.y * p.y * m.yy);
  const float worst = HWY_MAX(Sum(off[0]), HWY_MAX(Sum(off[1]), Sum(off[2])));
  mean.lean = std::sqrt(lean), mean.rough = std::sqrt(HWY_MAX(worst * over, 0.0f));
}

LitMean MeanOfCells(const LampLanes& lamp, LitCells& cells) {
  const Sums s = SumOver(lamp, cells);
  const float all = Sum(s.area), over = all > 0.0f ? 1.0f / all : 0.0f;
  LitMean mean{.r = Sum(s.r) * over,
               .g = Sum(s.g) * over,
               .b = Sum(s.b) * over,
               .area = HWY_MAX(all, 0.1f),
               .jump = Most(s.jump),
               .unsure = Sum(s.unsure),
               .turn = Most(s.turn)};
  mean.kink = KinkOf(lamp, s, HWY_MIN(mean.r, HWY_MIN(mean.g, mean.b)));
  if (cells.side < PartCells::kMostSide && all > 0.0f) JudgePlane(cells, s, all, mean);
  return mean;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <algorithm>

namespace mien {
namespace batch {
HWY_EXPORT(MeanOfCells);
}  // namespace batch

void LitCells::take(const PartCells& cells, bool ring) {
  side = cells.side, ringed = ring;
  row = ring ? side + 2 : side;
  if (!ring) {
    std::copy_n(cells.area.data(), cells.count(), area.data());
    std::copy_n(cells.x.data(), cells.count(), at_x.data());
    std::copy_n(cells.y.data(), cells.count(), at_y.data());
    return;
  }
  const std::size_t padded = std::size_t(places()) + 32;
  std::fill_n(area.data(), padded, 0.0f);
  std::fill_n(at_x.data(), padded, 0.0f), std::fill_n(at_y.data(), padded, 0.0f);
  for (int j = 0; j < side; ++j) {
    const std::size_t from = std::size_t(j * side), to = std::size_t((j + 1) * row + 1);
    std::copy_n(&cells.area[from], side, &area[to]);
    std::copy_n(&cells.x[from], side, &at_x[to]), std::copy_n(&cells.y[from], side, &at_y[to]);
  }
  const float cell = cells.cell(), first = 0.5f * cell - 0.5f - cell;
  int column = 0, line = 0;
  for (std::size_t k = 0; k < padded; ++k) {
    const bool empty = area[k] == 0.0f;
    foot_x[k] = x + (empty ? first + cell * float(column) : at_x[k]);
    foot_y[k] = y + (empty ? first + cell * float(std::min(line, row - 1)) : at_y[k]);
    if (++column == row) column = 0, ++line;
  }
}

LitMean mean_of_cells(const LampLanes& lamp, LitCells& cells) {
  return MIEN_DISPATCH(MeanOfCells)(lamp, cells);
}

}  // namespace mien
#endif
