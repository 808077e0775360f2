// distances_on_grid of sdf/distance/distance.h, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/grid/grid_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/grid/grid_certificate-inl.h"
#include "sdf/distance/grid/grid_tile-inl.h"
#include "sdf/distance/grid/grid_work.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A tile of which nothing is proven: its points are computed like any other batch.
HWY_NOINLINE void UncertainTile(const QuadBezier& curve, const TileAxis& x, const TileAxis& y,
                                size_t columns, size_t rows, float* out, size_t stride) {
  float px[kTile * kTile], py[kTile * kTile], distance[kTile * kTile];
  for (size_t j = 0; j < rows; ++j) {
    for (size_t i = 0; i < columns; ++i) {
      px[j * columns + i] = x.point[i], py[j * columns + i] = y.point[j];
    }
  }
  const size_t count = columns * rows;
  distances(curve, {px, count}, {py, count}, std::span<float>(distance, count));
  for (size_t j = 0; j < rows; ++j) {
    std::copy_n(distance + j * columns, columns, out + j * stride);
  }
}

HWY_NOINLINE void CertifiedTile(const QuadBezierFrame<float>& f, const GridTile& tile,
                                const TileAxis& x, const TileAxis& y, float* out, size_t stride) {
  const hn::ScalableTag<float> d;
  using How = GridTile::How;
  switch (tile.how) {
    case How::multiplied:
      return TileDistances<How::multiplied>(d, f, tile, x, y, out, stride);
    case How::one_step:
      return TileDistances<How::one_step>(d, f, tile, x, y, out, stride);
    case How::two_steps:
      return TileDistances<How::two_steps>(d, f, tile, x, y, out, stride);
    default:
      return TileDistances<How::end>(d, f, tile, x, y, out, stride);
  }
}

/// The float frame that certified tiles need: the double one's numbers, rounded.
QuadBezierFrame<float> InFloat(const QuadBezierFrame<double>& fine) {
  QuadBezierFrame<float> f{};
  f.scale = float(fine.scale), f.unscale = float(fine.unscale);
  f.x0 = float(fine.x0), f.x0_low = float(fine.x0 - double(f.x0));
  f.y0 = float(fine.y0), f.y0_low = float(fine.y0 - double(f.y0));
  f.ax2 = float(fine.ax2), f.ay2 = float(fine.ay2), f.bx = float(fine.bx), f.by = float(fine.by);
  f.bx2 = 2 * f.bx, f.by2 = 2 * f.by;
  return f;
}

/// What the tiles of a grid share.
struct GridWork {
  const QuadBezier& curve;
  const Grid& grid;
  const QuadBezierFrame<double>& fine;
  const QuadBezierFrame<float>& frame;
  TileCertifier& certifier;
  float* out;

  void PlaceColumns(TileAxis& x, size_t first) const {
    const size_t count = std::min(kTile, grid.columns - first);
    PlaceAxis(x, grid.origin.x, grid.step, first, count, frame, frame.x0, frame.x0_low);
  }
  void PlaceRows(TileAxis& y, size_t first) const {
    const size_t count = std::min(kTile, grid.rows - first);
    PlaceAxis(y, grid.origin.y, grid.step, first, count, frame, frame.y0, frame.y0_low);
  }
};

double ReachOf(const TileAxis& x, const TileAxis& y) {
  return std::sqrt(x.half * x.half + y.half * y.half) * (1 + 0x1p-40);
}

/// The tile that begins at (i, j), cut off where the grid ends; true if it is certified.
bool DoTile(const GridWork& work, const TileAxis& x, const TileAxis& y, const GridTile& tile,
            size_t i, size_t j) {
  const size_t columns = std::min(kTile, work.grid.columns - i);
  const size_t rows = std::min(kTile, work.grid.rows - j), stride = work.grid.columns;
  float* to = work.out + j * stride + i;
  if (tile.how == GridTile::How::uncertain) {
    UncertainTile(work.curve, x, y, columns, rows, to, stride);
    return false;
  }
  if (columns == kTile && rows == kTile) {
    CertifiedTile(work.frame, tile, x, y, to, stride);
    return true;
  }
  HWY_ALIGN float part[kTile * kTile];
  CertifiedTile(work.frame, tile, x, y, part, kTile);
  for (size_t k = 0; k < rows; ++k) std::copy_n(part + k * kTile, columns, to + k * stride);
  return true;
}

/// So many tiles are certified at once.
inline constexpr size_t kTiles = hn::MaxLanes(hn::ScalableTag<double>());

/// Up to kTiles tiles one above the other, from (i, j) on: the middles' feet from the fast kernel,
/// certificates in lanes, and one by one where those prove nothing.
HWY_NOINLINE size_t DoTiles(const GridWork& work, const TileAxis& x, size_t i, size_t j,
                            size_t count) {
  const hn::ScalableTag<float> df;
  constexpr size_t kPoints = kParts * hn::MaxLanes(decltype(df)());
  const glm::dvec2 p0{work.fine.x0 + work.fine.x0_low, work.fine.y0 + work.fine.y0_low};
  TileAxis y[kTiles];
  TileLanes<kTiles> tiles;
  HWY_ALIGN float offset[kPoints], t[kPoints];
  for (size_t k = 0; k < kTiles; ++k) {
    const size_t n = std::min(k, count - 1);
    if (k == n) work.PlaceRows(y[k], j + k * kTile);
    tiles.dx[k] = p0.x - x.middle, tiles.dy[k] = p0.y - y[n].middle;
    tiles.reach[k] = ReachOf(x, y[n]);
  }
  for (size_t k = 0; k < kPoints; ++k) offset[k] = float(tiles.dy[std::min(k, kTiles - 1)]);
  const Offset<Pack<hn::Vec<decltype(df)>>> o{SetPack(df, float(tiles.dx[0])),
                                              LoadPack(df, offset)};
  StorePack(NearestOn(df, work.frame, o).t, df, t);
  for (size_t k = 0; k < kTiles; ++k) tiles.t[k] = double(t[k]);
  CertifyLanes(hn::ScalableTag<double>(), work.fine, work.certifier.facts(), tiles);
  size_t certified = 0;
  for (size_t k = 0; k < count; ++k) {
    GridTile tile = tiles.Tile(k);
    if (tile.how == GridTile::How::uncertain) {
      tile = work.certifier.certify({x.middle, y[k].middle}, tiles.reach[k]);
    }
    certified += DoTile(work, x, y[k], tile, i, j + k * kTile);
  }
  return certified;
}

size_t DistancesOnGrid(const QuadBezier& curve, int exponent, const Grid& grid, float* out) {
  const auto fine = quad_bezier_frame<double>(curve, exponent);
  const bool is_small = grid.rows <= 2 * kTile;  // then lanes would mostly be idle
  const auto frame = is_small ? InFloat(fine) : quad_bezier_frame<float>(curve, exponent);
  TileCertifier certifier(fine);
  const GridWork work{curve, grid, fine, frame, certifier, out};
  TileAxis x, y;
  size_t certified = 0;
  for (size_t i = 0; i < grid.columns; i += kTile) {
    work.PlaceColumns(x, i);
    for (size_t j = 0; j < grid.rows;) {
      if (!is_small) {
        const size_t left = (grid.rows - j + kTile - 1) / kTile, count = std::min(kTiles, left);
        certified += DoTiles(work, x, i, j, count);
        j += count * kTile;
        continue;
      }
      work.PlaceRows(y, j);
      const GridTile tile = certifier.certify({x.middle, y.middle}, ReachOf(x, y));
      certified += DoTile(work, x, y, tile, i, j);
      j += kTile;
    }
  }
  return certified;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/spans.h"

#include <cassert>
#include <cmath>

namespace mien {
namespace batch {
HWY_EXPORT(DistancesOnGrid);

size_t distances_on_grid(const QuadBezier& curve, const Grid& grid, std::span<float> d) {
  const size_t size = grid.columns * grid.rows;
  assert(d.size() == size && "d has columns * rows numbers");
  if (d.size() != size || d.empty()) return 0;
  const auto exponent = scale_exponent(curve);
  const bool finite = std::isfinite(grid.origin.x) && std::isfinite(grid.origin.y) &&
                      std::isfinite(grid.step) && std::isfinite(float(grid.step));
  if (exponent && finite) {
    return MIEN_DISPATCH(DistancesOnGrid)(curve, *exponent, grid, d.data());
  }
  for (size_t k = 0; k < size; ++k) {
    const float x = float(grid.origin.x + double(k % grid.columns) * grid.step);
    const float y = float(grid.origin.y + double(k / grid.columns) * grid.step);
    d[k] = float(distance(curve, {x, y}));
  }
  return 0;
}
}  // namespace batch

void distances_on_grid(const QuadBezier& curve, glm::dvec2 origin, double step, size_t columns,
                       size_t rows, std::span<float> d) {
  batch::distances_on_grid(curve, {origin, step, columns, rows}, d);
}

}  // namespace mien
#endif
