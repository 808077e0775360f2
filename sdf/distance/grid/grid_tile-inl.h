// Distances from the points of a certified tile to a quadratic Bézier: no root is looked for. Included
// once per instruction set. Derivation: docs/derivations/grid_tiles.md.
#if defined(MIEN_SDF_BATCH_GRID_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_BATCH_GRID_TILE_INL_H_
#undef MIEN_SDF_BATCH_GRID_TILE_INL_H_
#else
#define MIEN_SDF_BATCH_GRID_TILE_INL_H_
#endif

#include "sdf/distance/grid/grid_tile.h"
#include "sdf/distance/quad_bezier/quad_bezier-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A tile is so many points wide and high.
inline constexpr size_t kTile = 16;

/// One coordinate of a tile's points.
struct TileAxis {
  HWY_ALIGN float point[kTile];   ///< as the caller knows them
  HWY_ALIGN float offset[kTile];  ///< p0 − p, scaled
  double middle, half;            ///< scaled
  HWY_ALIGN float from_middle[kTile];
};

/// The points first, first + 1, … of the grid; beyond `count` the last one again.
HWY_INLINE void PlaceAxis(TileAxis& axis, double origin, double step, size_t first, size_t count,
                          const QuadBezierFrame<float>& f, float p0, float p0_low) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> df;
  const auto at = [&](double index) {
    return double(float(origin + (double(first) + index) * step)) * double(f.scale);
  };
  const double low = at(0), high = at(double(count - 1)), middle = 0.5 * (low + high);
  axis.middle = middle, axis.half = 0.5 * (high < low ? low - high : high - low);
  const auto scale = hn::Set(d, double(f.scale)), last = hn::Set(d, double(count - 1));
  for (size_t k = 0; k < kTile; k += hn::Lanes(d)) {
    const auto index = hn::Add(hn::Min(hn::Iota(d, double(k)), last), hn::Set(d, double(first)));
    const auto point =
        hn::DemoteTo(df, hn::Add(hn::Set(d, origin), hn::Mul(index, hn::Set(d, step))));
    const auto p = hn::Mul(hn::PromoteTo(d, point), scale);
    const auto offset = hn::DemoteTo(df, hn::Sub(hn::Set(d, double(p0)), p));
    hn::StoreU(point, df, axis.point + k);
    hn::StoreU(hn::Add(offset, hn::Set(df, p0_low)), df, axis.offset + k);
    hn::StoreU(hn::DemoteTo(df, hn::Sub(p, hn::Set(d, middle))), df, axis.from_middle + k);
  }
}

/// Four rows of values, the same in every lane.
template <class D>
HWY_INLINE Pack<hn::Vec<D>> Rows(D d, const float* row) {
  return {hn::Set(d, row[0]), hn::Set(d, row[1]), hn::Set(d, row[2]), hn::Set(d, row[3])};
}

/// One row after the other at the same columns.
template <class D, class V>
HWY_INLINE void StoreRows(D d, Pack<V> v, float* to, size_t stride) {
  hn::StoreU(v.a, d, to), hn::StoreU(v.b, d, to + stride);
  hn::StoreU(v.c, d, to + 2 * stride), hn::StoreU(v.d, d, to + 3 * stride);
}

/// |B(t) − p|² after so many Newton steps from t. With a division each step is clamped to [0, 1]; by the
/// series 1/(1 − e) ≈ 1 + e + e², e the slope's deviation from the middle's, it stays inside anyway.
template <GridTile::How kHow, class D, class W>
HWY_INLINE W TileSquare(D d, const QuadBezierFrame<float>& f, Offset<W> o, W t, float inverse) {
  using How = GridTile::How;
  constexpr int kSteps = kHow == How::end ? 0 : kHow == How::two_steps ? 2 : 1;
  const W ax2 = SetPack(d, f.ax2), ay2 = SetPack(d, f.ay2), one = SetPack(d, 1);
  const W bx = SetPack(d, f.bx), by = SetPack(d, f.by);
  W vx = MulAdd(t, bx, ax2), vy = MulAdd(t, by, ay2);  // 2a + t b
  W qx = MulAdd(t, vx, o.x), qy = MulAdd(t, vy, o.y);  // B − p
  for (int i = 0; i < kSteps; ++i) {
    const W gx = MulAdd(t, bx, vx), gy = MulAdd(t, by, vy);  // B'
    const W slope = MulAdd(qx, gx, Mul(qy, gy));
    const W turn = MulAdd(qx, SetPack(d, f.bx2), Mul(qy, SetPack(d, f.by2)));
    const W rise = MulAdd(gx, gx, MulAdd(gy, gy, turn));
    if constexpr (kHow == How::multiplied) {
      const W at_middle = SetPack(d, inverse), e = NegMulAdd(rise, at_middle, one);
      const W by_series = MulAdd(MulAdd(e, e, e), at_middle, at_middle);
      t = NegMulAdd(slope, by_series, t);
    } else {
      t = ClampToUnit(d, Sub(t, Div(slope, rise)));
    }
    vx = MulAdd(t, bx, ax2), vy = MulAdd(t, by, ay2);
    qx = MulAdd(t, vx, o.x), qy = MulAdd(t, vy, o.y);
  }
  return MulAdd(qx, qx, Mul(qy, qy));
}

template <GridTile::How kHow, class D>
HWY_INLINE void TileDistances(D d, const QuadBezierFrame<float>& f, const GridTile& tile,
                              const TileAxis& x, const TileAxis& y, float* out, size_t stride) {
  using W = Pack<hn::Vec<D>>;
  const float middle = float(tile.t), inverse = float(tile.inverse);
  const float wx1 = float(tile.wx), wy1 = float(tile.wy), zx1 = float(tile.zx),
              zy1 = float(tile.zy);
  const auto same = [](auto v) MIEN_LANES { return W{v, v, v, v}; };
  for (size_t column = 0; column < kTile; column += hn::Lanes(d)) {
    const auto ex = hn::Load(d, x.from_middle + column);
    const W wx = same(hn::Mul(ex, hn::Set(d, wx1))), zx = same(hn::Mul(ex, hn::Set(d, zx1)));
    const W ox = same(hn::Load(d, x.offset + column));
    for (size_t row = 0; row < kTile; row += kParts) {
      const Offset<W> o{ox, Rows(d, y.offset + row)};
      W t = SetPack(d, middle);
      if constexpr (kHow != GridTile::How::end) {
        const W ey = Rows(d, y.from_middle + row);
        const W w = MulAdd(ey, SetPack(d, wy1), wx), z = MulAdd(ey, SetPack(d, zy1), zx);
        t = MulAdd(w, z, Add(w, t));
      }
      const W square = TileSquare<kHow>(d, f, o, t, inverse);
      StoreRows(d, Mul(Sqrt(square), SetPack(d, f.unscale)), out + row * stride + column, stride);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
