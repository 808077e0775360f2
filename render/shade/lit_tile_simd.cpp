// The pixels of a tile in lanes. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/shade/lit_tile_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/shade/lamp_lanes-inl.h>
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

/// Where level lines are bent more than this, the foot at a pixel's middle does not tell its corners'.
constexpr float kMostBend = 0.12f;  // [1/px]

void JudgeRow(const LitTile& tile, const float* right, const float* below, float levels, int row,
              const float* rough, LitTile::Trust* trust) {
  const F f;
  constexpr float kLevelsOfSlope = 200.0f;
  for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
    HWY_ALIGN float around[hn::MaxLanes(F())], calm[hn::MaxLanes(F())];
    VF wild = hn::Zero(f);
    if (tile.rises) {
      const size_t at = size_t((row + 1) * kRow + 1) + i;
      const VF bend = hn::Mul(hn::Abs(hn::LoadU(f, &tile.bend[at])), Const(1.0f / kMostBend));
      wild =
          hn::Max(bend, hn::Mul(RidgeFear(right, below, row, i), Const(kLevelsOfSlope / levels)));
    }
    hn::Store(wild, f, calm);
    hn::Store(hn::Max(wild, hn::LoadU(f, rough + i)), f, around);
    for (size_t k = 0; k < hn::Lanes(f); ++k)
      trust[i + k] = around[k] <= 1.0f ? LitTile::Trust::around
                     : calm[k] <= 1.0f ? LitTile::Trust::calm
                                       : LitTile::Trust::none;
  }
}

void ShadeTile(LitTile& tile, float levels) {
  ShadePlaces(tile);
  HWY_ALIGN float rough[LitTile::kPixels] = {};
  MeansOf(tile.r.data(), levels, tile.mean_r.data(), rough);
  MeansOf(tile.g.data(), levels, tile.mean_g.data(), rough);
  MeansOf(tile.b.data(), levels, tile.mean_b.data(), rough);
  HWY_ALIGN float right[LitTile::kPadded + 16] = {}, below[LitTile::kPadded + 16] = {};
  if (tile.rises) FindRidges(tile, right, below);
  for (int j = 0; j < kSide; ++j)
    JudgeRow(tile, right, below, levels, j, rough + j * kSide, &tile.trust[size_t(j * kSide)]);
}

/// A distance's Laplacian is its bend. A ridge costs a level's fifth at most where the gradient falls by
/// one level per hundredth of a pixel.
void JudgeDistances(LitTile& tile) {
  const F f;
  HWY_ALIGN float right[LitTile::kPadded + 16] = {}, below[LitTile::kPadded + 16] = {};
  tile.lamp.rise_kind = LampLanes::Rise::constant, tile.lamp.rise = 1.0f;
  FindRidges(tile, right, below);
  HWY_ALIGN float rough[kSide] = {};
  for (int j = 0; j < kSide; ++j) {
    JudgeRow(tile, right, below, 1.0f, j, rough, &tile.trust[size_t(j * kSide)]);
    for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
      const size_t at = size_t((j + 1) * kRow + 1) + i;
      const VF d = Fused(hn::LoadU(f, &tile.bend[at]), Const(1.0f / 24), hn::LoadU(f, &tile.d[at]));
      hn::StoreU(d, f, &tile.mean_r[size_t(j * kSide) + i]);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(ShadeTile);
HWY_EXPORT(JudgeDistances);
}  // namespace batch

void shade_tile(LitTile& tile, float levels) {
  HWY_DYNAMIC_DISPATCH(batch::ShadeTile)(tile, levels);
}

void judge_distances(LitTile& tile) {
  HWY_DYNAMIC_DISPATCH(batch::JudgeDistances)(tile);
}

}  // namespace mien
#endif
