// The pixels of a tile in lanes. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/shade/lit_tile_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/shade/lit_piece-inl.h>
#include <mien/render/shade/lit_tile.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kRow = LitTile::kRow, kSide = LitTile::kSide;

void ShadePlaces(LitTile& tile) {
  const F f;
  HWY_ALIGN float x[LitTile::kPadded], y[LitTile::kPadded];
  for (int i = 0; i < LitTile::kPadded; ++i)
    x[i] = float(i % kRow) - 8.5f, y[i] = float(i / kRow) - 8.5f;
  for (size_t k = 0; k < size_t(LitTile::kPadded); k += hn::Lanes(f)) {
    const VF depth = tile.rises ? hn::Neg(hn::LoadU(f, &tile.d[k])) : hn::Zero(f);
    const VF nx = tile.rises ? hn::LoadU(f, &tile.nx[k]) : hn::Zero(f);
    const VF ny = tile.rises ? hn::LoadU(f, &tile.ny[k]) : hn::Zero(f);
    const LitColor c = LitAt(tile.lamp, depth, nx, ny, hn::Load(f, x + k), hn::Load(f, y + k));
    hn::StoreU(c.r, f, &tile.r[k]), hn::StoreU(c.g, f, &tile.g[k]), hn::StoreU(c.b, f, &tile.b[k]);
  }
}

/// How much more the gradient turns from one place to the next than its bends tell, times what a
/// slope of that is worth in levels: large where a ridge lies between.
void FindRidges(const LitTile& tile, float* right, float* below) {
  const F f;
  for (size_t k = 0; k + size_t(kRow) < size_t(LitTile::kPadded); k += hn::Lanes(f)) {
    const auto off = [&](size_t next, bool down) HWY_ATTR {
      const VF ax = hn::LoadU(f, &tile.nx[k]), ay = hn::LoadU(f, &tile.ny[k]);
      const VF bx = hn::LoadU(f, &tile.nx[next]), by = hn::LoadU(f, &tile.ny[next]);
      const VF ka = hn::LoadU(f, &tile.bend[k]), kb = hn::LoadU(f, &tile.bend[next]);
      const VF half = Const(0.5f);
      // Along (1, 0) the gradient turns by −ny times bend, along (0, 1) by nx.
      const VF ta = hn::Mul(ka, down ? ax : hn::Neg(ay)), tb = hn::Mul(kb, down ? bx : hn::Neg(by));
      const VF mx =
          hn::Sub(hn::Sub(bx, ax), hn::Mul(half, hn::Neg(Fused(ta, ay, hn::Mul(tb, by)))));
      const VF my = hn::Sub(hn::Sub(by, ay), hn::Mul(half, Fused(ta, ax, hn::Mul(tb, bx))));
      const VF rise = hn::Max(hn::Abs(RiseAt(tile.lamp, hn::Neg(hn::LoadU(f, &tile.d[k])))),
                              hn::Abs(RiseAt(tile.lamp, hn::Neg(hn::LoadU(f, &tile.d[next])))));
      const VF steep = hn::Min(rise, Const(1.0f));  // steeper ones turn light no more
      return hn::Mul(hn::Sqrt(Fused(mx, mx, hn::Mul(my, my))), steep);
    };
    hn::StoreU(off(k + 1, false), f, right + k);
    hn::StoreU(off(k + size_t(kRow), true), f, below + k);
  }
}

/// Means of one channel: the middle's colour and a 24th of its second differences. What third
/// differences leave to be feared goes to `rough`, as the largest so far.
void MeansOf(const float* c, float levels, float* mean, float* rough) {
  const F f;
  HWY_ALIGN float sx[LitTile::kPixels + 32], sy[LitTile::kPixels + 32];
  for (int j = 0; j < kSide; ++j)
    for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
      const float* at = c + size_t((j + 1) * kRow + 1) + i;
      const VF mid = hn::LoadU(f, at), two = hn::Add(mid, mid);
      const VF x = hn::Sub(hn::Add(hn::LoadU(f, at - 1), hn::LoadU(f, at + 1)), two);
      const VF y = hn::Sub(hn::Add(hn::LoadU(f, at - kRow), hn::LoadU(f, at + kRow)), two);
      const size_t to = size_t(j * kSide) + i;
      hn::Store(x, f, sx + to), hn::Store(y, f, sy + to);
      hn::StoreU(Fused(hn::Add(x, y), Const(1.0f / 24), mid), f, mean + to);
    }
  for (int j = 0; j < kSide; ++j) {
    const int up = (j > 0 ? j - 1 : 0) * kSide, down = (j + 1 < kSide ? j + 1 : j) * kSide;
    for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
      const size_t to = size_t(j * kSide) + i;
      const VF x = hn::Load(f, sx + to), y = hn::Load(f, sy + to);
      const VF y0 = hn::Load(f, sy + size_t(up) + i), y1 = hn::Load(f, sy + size_t(down) + i);
      HWY_ALIGN float row[kSide + 2];
      row[0] = sx[j * kSide], row[kSide + 1] = sx[j * kSide + kSide - 1];
      for (int k = 0; k < kSide; ++k) row[k + 1] = sx[j * kSide + k];
      const VF x0 = hn::LoadU(f, row + i), x1 = hn::LoadU(f, row + i + 2);
      const VF third = hn::Max(hn::Max(hn::Abs(hn::Sub(x, x0)), hn::Abs(hn::Sub(x1, x))),
                               hn::Max(hn::Abs(hn::Sub(y, y0)), hn::Abs(hn::Sub(y1, y))));
      const VF fear = hn::Mul(third, Const(255.0f / levels));
      hn::Store(hn::Max(hn::Load(f, rough + to), fear), f, rough + to);
    }
  }
}

/// Of places in a row, what is to be feared of ridges around them.
HWY_INLINE VF RidgeFear(const float* right, const float* below, int row, size_t column) {
  const F f;
  VF most = hn::Zero(f);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 2; ++i)
      most = hn::Max(most, hn::LoadU(f, right + size_t((row + j) * kRow + i) + column));
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i)
      most = hn::Max(most, hn::LoadU(f, below + size_t((row + j) * kRow + i) + column));
  return most;
}

/// Means by three places along the gradient, where seconds differences will not do or the zone ends: `wanted` of 1.
/// Returns where these will not do either.
HWY_INLINE VF MeansAlong(LitTile& tile, int row, size_t column, VF wanted, float levels) {
  const F f;
  const size_t at = size_t((row + 1) * kRow + 1) + column, to = size_t(row * kSide) + column;
  HWY_ALIGN float steps[hn::MaxLanes(F())];
  for (size_t i = 0; i < hn::Lanes(f); ++i) steps[i] = float(column + i) - 7.5f;
  const ZoneCell zone{tile.shallow, tile.deep, 1.0f};
  const Spot spot{hn::LoadU(f, &tile.d[at]), hn::LoadU(f, &tile.nx[at]),
                  hn::LoadU(f, &tile.ny[at])};
  const Piece piece = PieceOf(tile.lamp, zone, spot, hn::Load(f, steps), Const(float(row) - 7.5f));
  const auto use = hn::Gt(wanted, hn::Zero(f));
  const auto put = [&](VF v, float* plane) HWY_ATTR {
    hn::StoreU(hn::IfThenElse(use, v, hn::LoadU(f, plane + to)), f, plane + to);
  };
  put(piece.area, tile.area.data()), put(piece.depth, tile.depth.data());
  put(piece.color.r, tile.mean_r.data()), put(piece.color.g, tile.mean_g.data());
  put(piece.color.b, tile.mean_b.data());
  constexpr float kMostBend = 0.12f;  // [1/px]: light along the level line is taken for straight
  const VF bend = hn::Mul(hn::Abs(hn::LoadU(f, &tile.bend[at])), Const(1.0f / kMostBend));
  const VF fear = hn::Max(bend, hn::Mul(piece.bends, Const(0.1f * 255.0f / levels)));
  return hn::IfThenElseZero(hn::And(use, hn::Gt(piece.area, hn::Zero(f))), fear);
}

void ShadeTile(LitTile& tile, float levels) {
  const F f;
  ShadePlaces(tile);
  HWY_ALIGN float rough[LitTile::kPixels] = {}, along[LitTile::kPixels] = {};
  MeansOf(tile.r.data(), levels, tile.mean_r.data(), rough);
  MeansOf(tile.g.data(), levels, tile.mean_g.data(), rough);
  MeansOf(tile.b.data(), levels, tile.mean_b.data(), rough);
  HWY_ALIGN float right[LitTile::kPadded + 16] = {}, below[LitTile::kPadded + 16] = {};
  constexpr float kLevelsOfSlope = 200.0f;
  if (tile.rises) FindRidges(tile, right, below);
  const VF one = Const(1.0f), zero = hn::Zero(f), reach = Const(0.70710678f);
  for (int j = 0; j < kSide; ++j)
    for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
      const size_t to = size_t(j * kSide) + i, at = size_t((j + 1) * kRow + 1) + i;
      VF fear = hn::LoadU(f, rough + to);
      if (tile.rises) {
        const VF depth = hn::Neg(hn::LoadU(f, &tile.d[at]));
        const VF in =
            hn::Min(hn::Sub(depth, Const(tile.shallow)), hn::Sub(Const(tile.deep), depth));
        hn::StoreU(hn::IfThenElseZero(hn::Gt(in, hn::Neg(reach)), one), f, &tile.area[to]);
        hn::StoreU(depth, f, &tile.depth[to]);
        const auto cut = hn::And(hn::Lt(in, reach), hn::Gt(in, hn::Neg(reach)));
        const auto inside = hn::Gt(in, hn::Neg(reach));
        const auto wanted = hn::And(inside, hn::Or(cut, hn::Gt(fear, one)));
        if (!hn::AllFalse(f, wanted)) {
          const VF want = hn::IfThenElseZero(wanted, one);
          hn::StoreU(want, f, along + to);
          fear = hn::IfThenElse(wanted, MeansAlong(tile, j, i, want, levels), fear);
        }
        const VF ridge = hn::Mul(RidgeFear(right, below, j, i), Const(kLevelsOfSlope / levels));
        fear = hn::IfThenElseZero(inside, hn::Max(fear, ridge));
      } else {
        hn::StoreU(one, f, &tile.area[to]), hn::StoreU(zero, f, &tile.depth[to]);
      }
      hn::StoreU(fear, f, rough + to);
    }
  for (int k = 0; k < LitTile::kPixels; ++k)
    tile.trust[size_t(k)] = !(rough[k] <= 1.0f) ? LitTile::Trust::none
                            : along[k] != 0.0f  ? LitTile::Trust::along
                                                : LitTile::Trust::around;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(ShadeTile);
}  // namespace batch

void shade_tile(LitTile& tile, float levels) {
  HWY_DYNAMIC_DISPATCH(batch::ShadeTile)(tile, levels);
}

}  // namespace mien
#endif
