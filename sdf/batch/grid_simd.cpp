// distances_on_grid of sdf/distance.h, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/sdf/batch/grid_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/sdf/batch/grid_tile-inl.h>
#include <mien/sdf/batch/grid_work.h>
#include <mien/sdf/distance.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A tile of which nothing is proven: its points are a batch like any other.
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

/// What certified tiles need of the float frame: the double one's numbers, rounded.
QuadBezierFrame<float> InFloat(const QuadBezierFrame<double>& fine) {
  QuadBezierFrame<float> f{};
  f.scale = float(fine.scale), f.unscale = float(fine.unscale);
  f.x0 = float(fine.x0), f.x0_low = float(fine.x0 - double(f.x0));
  f.y0 = float(fine.y0), f.y0_low = float(fine.y0 - double(f.y0));
  f.ax2 = float(fine.ax2), f.ay2 = float(fine.ay2), f.bx = float(fine.bx), f.by = float(fine.by);
  f.bx2 = 2 * f.bx, f.by2 = 2 * f.by;
  return f;
}

size_t DistancesOnGrid(const QuadBezier& curve, int exponent, const Grid& grid, float* out) {
  const auto fine = quad_bezier_frame<double>(curve, exponent);
  const auto frame = InFloat(fine);
  TileCertifier certifier(fine);
  TileAxis x, y;
  HWY_ALIGN float part[kTile * kTile];
  size_t certified = 0;
  for (size_t i = 0; i < grid.columns; i += kTile) {
    const size_t columns = std::min(kTile, grid.columns - i);
    PlaceAxis(x, grid.origin.x, grid.step, i, columns, frame, frame.x0, frame.x0_low);
    for (size_t j = 0; j < grid.rows; j += kTile) {
      const size_t rows = std::min(kTile, grid.rows - j);
      PlaceAxis(y, grid.origin.y, grid.step, j, rows, frame, frame.y0, frame.y0_low);
      const double reach = std::sqrt(x.half * x.half + y.half * y.half) * (1 + 0x1p-40);
      const GridTile tile = certifier.certify({x.middle, y.middle}, reach);
      float* to = out + j * grid.columns + i;
      if (tile.how == GridTile::How::uncertain) {
        UncertainTile(curve, x, y, columns, rows, to, grid.columns);
        continue;
      }
      ++certified;
      if (columns == kTile && rows == kTile) {
        CertifiedTile(frame, tile, x, y, to, grid.columns);
        continue;
      }
      CertifiedTile(frame, tile, x, y, part, kTile);
      for (size_t k = 0; k < rows; ++k) {
        std::copy_n(part + k * kTile, columns, to + k * grid.columns);
      }
    }
  }
  return certified;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <mien/sdf/batch/spans.h>

#include <cmath>

namespace mien {
namespace batch {
HWY_EXPORT(DistancesOnGrid);

size_t distances_on_grid(const QuadBezier& curve, const Grid& grid, std::span<float> d) {
  const size_t size = grid.columns * grid.rows;
  require_spans("distances_on_grid", {d.data(), size, sizeof(float)},
                {d.data(), size, sizeof(float)}, {d.data(), d.size(), sizeof(float)});
  if (d.empty()) return 0;
  const auto exponent = scale_exponent(curve);
  const bool finite = std::isfinite(grid.origin.x) && std::isfinite(grid.origin.y) &&
                      std::isfinite(grid.step) && std::isfinite(float(grid.step));
  if (exponent && finite) {
    return HWY_DYNAMIC_DISPATCH(DistancesOnGrid)(curve, *exponent, grid, d.data());
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
