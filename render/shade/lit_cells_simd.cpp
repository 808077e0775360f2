// Cells of a square in lanes: four at a time, a row of them. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/shade/lit_cells_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/shade/lit_cells.h>
#include <mien/render/shade/lit_piece-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A branch of the distance seen from (x, y) away, to second order in that: level lines as parabolas. Off by
/// |bend|² |(x, y)|³ / 2; cells are so small that this is below a hundredth of their side while bend · side < 1/8.
HWY_INLINE Spot SeenFrom(VF d, VF nx, VF ny, VF bend, float x, float y) {
  const VF dx = Const(x), dy = Const(y);
  const VF out = Fused(nx, dx, hn::Mul(ny, dy)), aside = FusedFrom(ny, dx, hn::Mul(nx, dy));
  const VF turn = hn::Mul(hn::Mul(bend, aside), FusedFrom(bend, out, Const(1.0f)));
  const VF half = hn::Mul(Const(0.5f), turn), back = FusedFrom(half, turn, Const(1.0f));
  return {hn::Add(d, Fused(half, aside, out)), FusedFrom(turn, ny, hn::Mul(nx, back)),
          Fused(turn, nx, hn::Mul(ny, back))};
}

struct Ridge {
  VF offset;    ///< from the cell's middle, 1e9 if there is none
  VF ex, ey;    ///< towards it, unit
  VF next;      ///< the offset of another one
  Spot beyond;  ///< the branch there, as it would be at the middle
};

/// Gradients nearer to each other than this are one branch. Of what is left a slope of 1 makes a level.
constexpr float kSameBranch = 0.02f;
constexpr float kMostTurn = 0.25f;  ///< of the gradient within a cell; more is divided

HWY_INLINE Ridge NoRidge() {
  const VF zero = hn::Zero(F()), far = Const(1e9f);
  return {far, zero, zero, far, {zero, zero, zero}};
}

HWY_INLINE void Consider(const Spot& here, const Spot& other, Ridge& ridge) {
  const VF mx = hn::Sub(other.nx, here.nx), my = hn::Sub(other.ny, here.ny);
  const VF m2 = Fused(mx, mx, hn::Mul(my, my));
  const auto another = hn::Gt(m2, Const(kSameBranch * kSameBranch));
  if (hn::AllFalse(F(), another)) return;
  const VF by = hn::Div(Const(1.0f), hn::Sqrt(hn::Max(m2, Const(1e-20f))));
  const VF apart = hn::Sub(other.d, here.d);
  const VF offset = hn::Mul(hn::Abs(apart), by);
  const auto nearer = hn::And(another, hn::Lt(offset, ridge.offset));
  // The one passed over is another ridge if it has another gradient beyond.
  const VF qx = hn::Sub(other.nx, ridge.beyond.nx), qy = hn::Sub(other.ny, ridge.beyond.ny);
  const auto differs = hn::And(another, hn::Gt(Fused(qx, qx, hn::Mul(qy, qy)), Const(0.01f)));
  const VF passed = hn::Max(offset, ridge.offset);
  ridge.next = hn::IfThenElse(differs, hn::Min(ridge.next, passed), ridge.next);
  const VF way = hn::CopySign(by, hn::Neg(apart));
  ridge.offset = hn::IfThenElse(nearer, offset, ridge.offset);
  ridge.ex = hn::IfThenElse(nearer, hn::Mul(mx, way), ridge.ex);
  ridge.ey = hn::IfThenElse(nearer, hn::Mul(my, way), ridge.ey);
  ridge.beyond.d = hn::IfThenElse(nearer, other.d, ridge.beyond.d);
  ridge.beyond.nx = hn::IfThenElse(nearer, other.nx, ridge.beyond.nx);
  ridge.beyond.ny = hn::IfThenElse(nearer, other.ny, ridge.beyond.ny);
}

/// As PieceOf at another place of the branch, `way` along (ex, ey); one place is enough.
HWY_INLINE LitColor ColorBeside(const LampLanes& lamp, const ZoneCell& cells, const Spot& at, VF x,
                                VF y, VF ex, VF ey, VF way) {
  const VF d = Fused(Fused(at.nx, ex, hn::Mul(at.ny, ey)), way, at.d);
  const VF depth = hn::Min(hn::Max(hn::Neg(d), Const(cells.shallow)), Const(cells.deep));
  return LitAt(lamp, depth, at.nx, at.ny, Fused(ex, way, x), Fused(ey, way, y));
}

HWY_INLINE VF Mixed(VF share, VF a, VF b) {
  return Fused(share, hn::Sub(b, a), a);
}

/// A cell that a ridge cuts: two branches, each at the middle of its part.
HWY_INLINE void MixRidge(const LampLanes& lamp, const ZoneCell& cells, const Spot& here,
                         const Ridge& ridge, VF x, VF y, Piece& piece) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f);
  const auto cut = CutCell(f, hn::Neg(ridge.offset), ridge.ex, ridge.ey, cells.side);
  const auto touched = hn::And(hn::Lt(ridge.offset, Const(cells.side)), hn::Gt(cut.area, zero));
  if (hn::AllFalse(f, touched)) return;
  const VF share = hn::IfThenElse(touched, cut.area, zero), way = hn::Add(ridge.offset, cut.t);
  const VF back = hn::Neg(hn::Div(hn::Mul(share, way), hn::Max(hn::Sub(one, share), Const(0.1f))));
  const LitColor near = ColorBeside(lamp, cells, here, x, y, ridge.ex, ridge.ey, back);
  const LitColor far = ColorBeside(lamp, cells, ridge.beyond, x, y, ridge.ex, ridge.ey, way);
  piece.color.r = hn::IfThenElse(touched, Mixed(share, near.r, far.r), piece.color.r);
  piece.color.g = hn::IfThenElse(touched, Mixed(share, near.g, far.g), piece.color.g);
  piece.color.b = hn::IfThenElse(touched, Mixed(share, near.b, far.b), piece.color.b);
  const auto area_of = [&](const Spot& at) HWY_ATTR {
    const VF depth = hn::Neg(at.d);
    const VF low = CutCell(f, hn::Sub(depth, Const(cells.shallow)), at.nx, at.ny, cells.side).area;
    const VF high = CutCell(f, hn::Sub(Const(cells.deep), depth), at.nx, at.ny, cells.side).area;
    return hn::Max(hn::Sub(hn::Add(low, high), one), zero);
  };
  piece.area = hn::IfThenElse(touched, Mixed(share, piece.area, area_of(ridge.beyond)), piece.area);
}

void ColorCells(const LampLanes& lamp, LitCells& cells) {
  constexpr int kRow = LitCells::kRow, kSide = LitCells::kSide, kCells = LitCells::kCells;
  HWY_ALIGN float planes[9][4][kCells];  // of the nine neighbours: d, nx, ny, bend
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < kSide; ++j) {
      const size_t from = size_t((j + k / 3) * kRow + k % 3), to = size_t(j * kSide);
      hwy::CopyBytes<4 * sizeof(float)>(&cells.d[from], &planes[k][0][to]);
      hwy::CopyBytes<4 * sizeof(float)>(&cells.nx[from], &planes[k][1][to]);
      hwy::CopyBytes<4 * sizeof(float)>(&cells.ny[from], &planes[k][2][to]);
      hwy::CopyBytes<4 * sizeof(float)>(&cells.bend[from], &planes[k][3][to]);
    }
  HWY_ALIGN float cx[kCells], cy[kCells];
  for (int i = 0; i < kCells; ++i)
    cx[i] = cells.side * (float(i % kSide) - 1.5f), cy[i] = cells.side * (float(i / kSide) - 1.5f);
  const F f;
  const ZoneCell zone{cells.shallow, cells.deep, cells.side};
  for (size_t c = 0; c < size_t(kCells); c += hn::Lanes(f)) {
    const auto load = [&](int k, int plane) HWY_ATTR { return hn::Load(f, &planes[k][plane][c]); };
    const Spot here{load(4, 0), load(4, 1), load(4, 2)};
    Ridge ridge = NoRidge();
    for (int k = 0; k < 9; ++k) {
      if (k == 4) continue;
      const float dx = float(k % 3 - 1) * cells.side, dy = float(k / 3 - 1) * cells.side;
      Consider(here, SeenFrom(load(k, 0), load(k, 1), load(k, 2), load(k, 3), -dx, -dy), ridge);
    }
    const VF x = hn::Load(f, cx + c), y = hn::Load(f, cy + c);
    const VF px = hn::Add(x, Const(cells.x)), py = hn::Add(y, Const(cells.y));
    Piece piece = PieceOf(lamp, zone, here, px, py);
    const VF reach =
        hn::Mul(Const(0.5f * cells.side), hn::Add(hn::Abs(ridge.ex), hn::Abs(ridge.ey)));
    const auto ridged = hn::Lt(ridge.offset, reach);
    // Where the gradient turns much within the cell there is a peak.
    const VF turns = hn::Mul(hn::Abs(load(4, 3)), Const(cells.side / kMostTurn));
    VF divide = hn::IfThenElseZero(hn::Gt(turns, Const(1.0f)), Const(1.0f));
    if (!hn::AllFalse(f, ridged)) {
      MixRidge(lamp, zone, here, ridge, px, py, piece);
      const auto partly = hn::And(hn::Gt(piece.area, hn::Zero(f)), hn::Lt(piece.area, Const(1.0f)));
      const auto twice = hn::Lt(ridge.next, Const(0.75f * cells.side));
      divide = hn::IfThenElse(hn::And(ridged, hn::Or(partly, twice)), Const(1.0f), divide);
    }
    hn::StoreU(divide, f, &cells.divide[c]);
    // The centroid of what counts lies as far along the gradient as its mean depth says.
    const VF back = hn::Sub(hn::Neg(here.d), piece.depth);
    hn::StoreU(piece.area, f, &cells.area[c]);
    hn::StoreU(piece.color.r, f, &cells.r[c]), hn::StoreU(piece.color.g, f, &cells.g[c]);
    hn::StoreU(piece.color.b, f, &cells.b[c]);
    hn::StoreU(Fused(here.nx, back, x), f, &cells.cx[c]);
    hn::StoreU(Fused(here.ny, back, y), f, &cells.cy[c]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(ColorCells);
}  // namespace batch

void color_cells(const LampLanes& lamp, LitCells& cells) {
  HWY_DYNAMIC_DISPATCH(batch::ColorCells)(lamp, cells);
}

}  // namespace mien
#endif
