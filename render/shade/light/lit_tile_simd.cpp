// The pixels of a tile in lanes. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/light/lit_tile_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/blend/transfer.h"
#include "render/shade/light/lit_tile.h"
#include "render/shade/light/ridge-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>
#include <cmath>

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

constexpr int kBlocks = LitTile::kBlocks, kWide = 32;  // a row of kRow and what lanes read beyond

/// A row of places as predicted by one of the three columns of blocks around each of them.
struct Seen {
  float d[kWide], nx[kWide], ny[kWide], bend[kWide], x[kWide];
};

void SeeRow(const LitTile& tile, int block_row, int shift, Seen& to) {
  for (int i = 0; i < kWide; ++i) {
    const int column = HWY_MIN(HWY_MAX(HWY_MIN(i, kRow - 1) / 2 + shift, 0), kBlocks - 1);
    const size_t from = size_t(block_row * kBlocks + column);
    to.d[i] = tile.block_d[from], to.nx[i] = tile.block_nx[from];
    to.ny[i] = tile.block_ny[from], to.bend[i] = tile.block_bend[from];
    to.x[i] = float(HWY_MIN(i, kRow - 1)) - 0.5f - float(2 * column);
  }
}

HWY_INLINE Spot SpotAt(const Seen& seen, size_t i, float y) {
  const F f;
  return SeenFrom(hn::LoadU(f, seen.d + i), hn::LoadU(f, seen.nx + i), hn::LoadU(f, seen.ny + i),
                  hn::LoadU(f, seen.bend + i), hn::LoadU(f, seen.x + i), Const(y));
}

constexpr float kFarRidge = 1e9f;

/// Apart by more than second order neglects: two branches of the same gradient, with ridges between.
HWY_INLINE VF TooFarApart(VF a, VF b, VF bend) {
  const VF neglected = Fused(hn::Mul(Const(8.0f), bend), bend, Const(0.02f));
  return hn::Sub(hn::Abs(hn::Sub(a, b)), neglected);
}

/// Whether some block's foot is of another branch than the one right of it or below it.
bool HasRidges(const LitTile& tile) {
  const F f;
  constexpr size_t kRowOf = size_t(kBlocks), kCount = kRowOf * kRowOf;
  VF most = hn::Zero(f);
  const auto look = [&](size_t k, size_t next, float x, float y, VF use) HWY_ATTR {
    const auto seen = [&](size_t from, float dx, float dy) HWY_ATTR {
      return SeenFrom(hn::LoadU(f, &tile.block_d[from]), hn::LoadU(f, &tile.block_nx[from]),
                      hn::LoadU(f, &tile.block_ny[from]), hn::LoadU(f, &tile.block_bend[from]),
                      Const(dx), Const(dy));
    };
    const Spot a = seen(k, x, y), b = seen(next, -x, -y);
    const VF mx = hn::Sub(b.nx, a.nx), my = hn::Sub(b.ny, a.ny);
    const VF bend = hn::Max(hn::Abs(hn::LoadU(f, &tile.block_bend[k])),
                            hn::Abs(hn::LoadU(f, &tile.block_bend[next])));
    const VF apart = hn::Max(Fused(mx, mx, hn::Mul(my, my)), TooFarApart(a.d, b.d, bend));
    most = hn::Max(most, hn::Mul(use, apart));
  };
  HWY_ALIGN float use[hn::MaxLanes(F())];
  for (size_t k = 0; k < kCount; k += hn::Lanes(f)) {
    for (size_t i = 0; i < hn::Lanes(f); ++i)
      use[i] = (k + i) % kRowOf + 1 < kRowOf && k + i < kCount ? 1.0f : 0.0f;
    look(k, k + 1, 1.0f, 0.0f, hn::Load(f, use));
    for (size_t i = 0; i < hn::Lanes(f); ++i) use[i] = k + i + kRowOf < kCount ? 1.0f : 0.0f;
    look(k, k + kRowOf, 0.0f, 1.0f, hn::Load(f, use));
  }
  return !hn::AllFalse(f, hn::Gt(most, Const(tile.same * tile.same)));
}

/// More than 0 where a pixel's foot, predicted from the middle of its block (ox, oy) away, may be of another branch
/// than the pixel: another block's foot differs in its gradient and the ridge lies on the way, or it has the same
/// gradient at another distance, with ridges between.
HWY_INLINE VF Mistaken(const Spot& here, const Spot& other, VF ox, VF oy, float same, VF bend) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f);
  const VF mx = hn::Sub(other.nx, here.nx), my = hn::Sub(other.ny, here.ny);
  const VF m2 = Fused(mx, mx, hn::Mul(my, my));
  const VF apart = hn::Sub(other.d, here.d);
  const VF before = hn::Sub(apart, Fused(mx, ox, hn::Mul(my, oy)));
  const auto on_the_way =
      hn::And(hn::Gt(m2, Const(same * same)), hn::Lt(hn::Mul(apart, before), zero));
  constexpr float kAlike = 0.02f;  // of m²: an eighth of a radian
  // Seen from three times as far as blocks lie apart.
  const auto another =
      hn::And(hn::Lt(m2, Const(kAlike)),
              hn::Gt(TooFarApart(here.d, other.d, hn::Mul(Const(3.0f), bend)), zero));
  return hn::IfThenElseZero(hn::Or(on_the_way, another), one);
}

/// A ridge farther beside a pixel than kReach does not touch it; beyond `kClear` it touches none of the middles
/// around, nor their blocks.
constexpr float kReach = 0.25f, kClear = 1.7f;

/// How far beside each pixel of a row the nearest ridge is, from the nine blocks around it.
void FindRidges(LitTile& tile, int row, const Seen (&around)[3][3], const float (&y)[3]) {
  const F f;
  for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
    const Spot here = SpotAt(around[1][1], i + 1, y[1]);
    Ridge ridge = NoRidge();
    const VF bend = hn::Abs(hn::LoadU(f, around[1][1].bend + i + 1));
    const VF ox = hn::LoadU(f, around[1][1].x + i + 1), oy = Const(y[1]);
    VF wrong = hn::Zero(f);  // where it is positive, the foot says nothing
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        if (j == 1 && k == 1) continue;
        const Spot other = SpotAt(around[j][k], i + 1, y[j]);
        Consider(here, other, tile.same, ridge);
        const VF most = hn::Max(bend, hn::Abs(hn::LoadU(f, around[j][k].bend + i + 1)));
        wrong = hn::Max(wrong, Mistaken(here, other, ox, oy, tile.same, most));
      }
    const VF corner = hn::Mul(Const(0.5f), hn::Add(hn::Abs(ridge.ex), hn::Abs(ridge.ey)));
    const VF beside = hn::Sub(ridge.offset, corner);
    hn::StoreU(hn::IfThenElse(hn::Gt(wrong, hn::Zero(f)), hn::Zero(f), beside), f,
               &tile.ridge[size_t(row * kSide) + i]);
  }
}

void SpreadFeet(LitTile& tile) {
  const F f;
  const bool ridges = HasRidges(tile);
  if (!ridges) tile.ridge.fill(kFarRidge);
  HWY_ALIGN Seen around[3][3];
  for (int row = 0; row < kRow; ++row) {
    float y[3];
    for (int j = 0; j < 3; ++j) {
      const int block = HWY_MIN(HWY_MAX(row / 2 + j - 1, 0), kBlocks - 1);
      y[j] = float(row) - 0.5f - float(2 * block);
      if (row % 2 == 0 && (ridges || j == 1))
        for (int k = ridges ? 0 : 1; k < (ridges ? 3 : 2); ++k)
          SeeRow(tile, block, k - 1, around[j][k]);
    }
    for (size_t i = 0; i < size_t(kRow); i += hn::Lanes(f)) {
      const Spot at = SpotAt(around[1][1], i, y[1]);
      const size_t to = size_t(row * kRow) + i;  // the next row writes over what is beyond this one
      hn::StoreU(at.d, f, &tile.d[to]), hn::StoreU(at.nx, f, &tile.nx[to]);
      hn::StoreU(at.ny, f, &tile.ny[to]);
      hn::StoreU(hn::LoadU(f, around[1][1].bend + i), f, &tile.bend[to]);
    }
    if (ridges && row > 0 && row <= kSide) FindRidges(tile, row - 1, around, y);
  }
}

/// Second differences beyond the tile, as a share of those at its border. Two pixels beside a kink may have the
/// same ones, which leaves up to a fifteenth of them; the third difference shows that, but not if it lies beyond
/// the border.
constexpr float kBeyondBorder = 1.0f - 1.0f / 8;

/// Means of one channel: the middle's colour and a 24th of its second differences. The error to be feared from
/// third differences goes to `rough`, as the largest so far.
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
    const int up = (j - 1) * kSide, down = (j + 1) * kSide;
    for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
      const size_t to = size_t(j * kSide) + i;
      const VF x = hn::Load(f, sx + to), y = hn::Load(f, sy + to);
      const VF beyond = hn::Mul(y, Const(kBeyondBorder));
      const VF y0 = j > 0 ? hn::Load(f, sy + size_t(up) + i) : beyond;
      const VF y1 = j + 1 < kSide ? hn::Load(f, sy + size_t(down) + i) : beyond;
      HWY_ALIGN float row[kSide + 2];
      row[0] = kBeyondBorder * sx[j * kSide];
      row[kSide + 1] = kBeyondBorder * sx[j * kSide + kSide - 1];
      for (int k = 0; k < kSide; ++k) row[k + 1] = sx[j * kSide + k];
      const VF x0 = hn::LoadU(f, row + i), x1 = hn::LoadU(f, row + i + 2);
      const VF third = hn::Max(hn::Max(hn::Abs(hn::Sub(x, x0)), hn::Abs(hn::Sub(x1, x))),
                               hn::Max(hn::Abs(hn::Sub(y, y0)), hn::Abs(hn::Sub(y1, y))));
      const VF fear = hn::Mul(third, Const(255.0f / levels));
      hn::Store(hn::Max(hn::Load(f, rough + to), fear), f, rough + to);
    }
  }
}

/// Where level lines bend more than this, the foot at a pixel's middle does not serve for its corners.
constexpr float kMostBend = 0.12f;  // [1/px]

/// How much level lines bend in or beside each pixel of a row, and by how much their bends differ. Where a side
/// goes over into another one or into a tip, the gradient goes on but the bend jumps. The sector beyond spreads, so
/// a pixel beside is in it.
struct Bends {
  HWY_ALIGN float most[kSide + hn::MaxLanes(F())] = {}, swing[kSide + hn::MaxLanes(F())] = {};
};

void BendsOf(const LitTile& tile, int row, Bends& to) {
  const F f;
  for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
    VF least = Const(1e9f), most = Const(-1e9f);
    for (int j = 0; j < 3; ++j)
      for (size_t k = 0; k < 3; ++k) {
        const VF bend = hn::LoadU(f, &tile.bend[size_t((row + j) * kRow) + i + k]);
        least = hn::Min(least, bend), most = hn::Max(most, bend);
      }
    hn::StoreU(hn::Max(most, hn::Neg(least)), f, to.most + i);
    hn::StoreU(hn::Sub(most, least), f, to.swing + i);
  }
}

/// Whether nothing can lie between middles or Gauss's places.
bool IsWide(const LitTile& tile) {
  constexpr float kNarrow = 1.5f;  // [px]
  return tile.lamp.finest > kNarrow;
}

/// `levels`: the permitted error of a mean. A foot with the wrong bend puts the normal off by the difference times
/// its distance along the level line, half a pixel; light changes by up to 100 levels per radian.
void JudgeRow(const LitTile& tile, int row, const float* rough, float levels,
              LitTile::Trust* trust) {
  const float most_swing = 0.05f * levels;  // [1/px]
  const bool wide = IsWide(tile);
  if (tile.rises && tile.tangled) {
    std::fill_n(trust, kSide, LitTile::Trust::none);
    return;
  }
  Bends bends;
  if (tile.rises) BendsOf(tile, row, bends);
  for (int i = 0; i < kSide; ++i) {
    const float ridge = tile.rises ? tile.ridge[size_t(row * kSide + i)] : kFarRidge;
    const bool calm = ridge > kReach && bends.most[i] <= kMostBend && bends.swing[i] <= most_swing;
    trust[i] = calm && ridge > kClear && rough[i] <= 1.0f && wide ? LitTile::Trust::around
               : calm                                             ? LitTile::Trust::calm
                                                                  : LitTile::Trust::none;
  }
}

struct MeanColor {
  VF r, g, b;
};

/// Means of pixels by Gauss's 2 × 2 places: `at` of the tile's places with their rim; x, y: the pixels' middles.
HWY_INLINE MeanColor MeanOfFour(const LitTile& tile, size_t at, VF x, float y) {
  const F f;
  constexpr float kGauss = 0.28867513f;
  VF r = hn::Zero(f), g = r, b = r;
  for (const float dy : {-kGauss, kGauss})
    for (const float dx : {-kGauss, kGauss}) {
      Spot spot{hn::Zero(f), hn::Zero(f), hn::Zero(f)};
      if (tile.rises)
        spot = SeenFrom(hn::LoadU(f, &tile.d[at]), hn::LoadU(f, &tile.nx[at]),
                        hn::LoadU(f, &tile.ny[at]), hn::LoadU(f, &tile.bend[at]), Const(dx),
                        Const(dy));
      const LitColor c =
          LitAt(tile.lamp, hn::Neg(spot.d), spot.nx, spot.ny, hn::Add(x, Const(dx)), Const(y + dy));
      r = hn::Add(r, c.r), g = hn::Add(g, c.g), b = hn::Add(b, c.b);
    }
  const VF quarter = Const(0.25f);
  return {hn::Mul(r, quarter), hn::Mul(g, quarter), hn::Mul(b, quarter)};
}

/// Means of a row's calm pixels by Gauss's 2 × 2 places. These differ from the means by middles around by more than
/// from the truth: a fourth derivative f leaves f/1920 and more in the one, f/4320 in the other. Where the two
/// differ by as much as may be seen, cells are used.
void MeansWithin(LitTile& tile, int row, const float* rough, float levels, float most_fear) {
  const F f;
  LitTile::Trust* const trust = &tile.trust[size_t(row * kSide)];
  HWY_ALIGN float steps[kSide];
  for (int i = 0; i < kSide; ++i) steps[i] = float(i) - 7.5f;
  for (size_t i = 0; i < size_t(kSide); i += hn::Lanes(f)) {
    const auto is_calm = [&](LitTile::Trust t) { return t == LitTile::Trust::calm; };
    if (std::none_of(trust + i, trust + i + hn::Lanes(f), is_calm)) continue;
    const size_t at = size_t((row + 1) * kRow + 1) + i, to = size_t(row * kSide) + i;
    const auto [r, g, b] = MeanOfFour(tile, at, hn::Load(f, steps + i), float(row) - 7.5f);
    HWY_ALIGN float apart[hn::MaxLanes(F())], mean[3][hn::MaxLanes(F())];
    const auto off = [&](VF v, const float* by_middles)
                         HWY_ATTR { return hn::Abs(hn::Sub(v, hn::LoadU(f, by_middles + to))); };
    hn::Store(hn::Max(off(r, tile.mean_r.data()),
                      hn::Max(off(g, tile.mean_g.data()), off(b, tile.mean_b.data()))),
              f, apart);
    hn::Store(r, f, mean[0]), hn::Store(g, f, mean[1]), hn::Store(b, f, mean[2]);
    for (size_t k = 0; k < hn::Lanes(f); ++k) {
      if (!is_calm(trust[i + k]) || !(apart[k] <= levels / 255.0f) || rough[i + k] > most_fear)
        continue;
      trust[i + k] = LitTile::Trust::within;
      tile.mean_r[to + k] = mean[0][k], tile.mean_g[to + k] = mean[1][k];
      tile.mean_b[to + k] = mean[2][k];
    }
  }
}

/// How steeply the darkest channel of a tile in linear light is encoded.
float Steepest(const LitTile& tile) {
  const F f;
  VF dark = Const(1.0f);
  for (size_t k = 0; k < size_t(LitTile::kPlaces); k += hn::Lanes(f))
    dark = hn::Min(dark, hn::Min(hn::LoadU(f, &tile.r[k]),
                                 hn::Min(hn::LoadU(f, &tile.g[k]), hn::LoadU(f, &tile.b[k]))));
  return HWY_MAX(float(encoding_slope(hn::GetLane(hn::MinOfLanes(f, dark)))), 1.0f);
}

void ShadeTile(LitTile& tile, float levels) {
  // Third differences of more levels than this, as encoded, are a kink's: there two means agree by chance.
  constexpr float kMostThird = 2.0f;
  ShadePlaces(tile);
  const float steep = tile.lamp.linear ? Steepest(tile) : 1.0f;
  // At 8 bits what is neglected is far less than what is permitted.
  levels /= levels < LitTile::kFine ? steep : HWY_MAX(0.5f * steep, 1.0f);
  HWY_ALIGN float rough[LitTile::kPixels] = {};
  MeansOf(tile.r.data(), levels, tile.mean_r.data(), rough);
  MeansOf(tile.g.data(), levels, tile.mean_g.data(), rough);
  MeansOf(tile.b.data(), levels, tile.mean_b.data(), rough);
  for (int j = 0; j < kSide; ++j) {
    JudgeRow(tile, j, rough + j * kSide, levels, &tile.trust[size_t(j * kSide)]);
    if (IsWide(tile))
      MeansWithin(tile, j, rough + j * kSide, levels, kMostThird / (steep * levels));
  }
}

/// A distance's Laplacian is its bend. Its normal does not count.
void JudgeDistances(LitTile& tile) {
  const F f;
  HWY_ALIGN const float rough[kSide] = {};
  constexpr float kAnySwing = 1e9f;
  for (int j = 0; j < kSide; ++j) {
    JudgeRow(tile, j, rough, kAnySwing, &tile.trust[size_t(j * kSide)]);
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
HWY_EXPORT(SpreadFeet);
HWY_EXPORT(ShadeTile);
HWY_EXPORT(JudgeDistances);
}  // namespace batch

void spread_feet(LitTile& tile) {
  MIEN_DISPATCH(SpreadFeet)(tile);
}

void shade_tile(LitTile& tile, float levels) {
  MIEN_DISPATCH(ShadeTile)(tile, levels);
}

void judge_distances(LitTile& tile) {
  MIEN_DISPATCH(JudgeDistances)(tile);
}

}  // namespace mien
#endif
