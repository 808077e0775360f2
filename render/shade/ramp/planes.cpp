#include "render/shade/ramp/planes.h"
#include "lib/base/watch.h"
#include "render/shade/color_row.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

/// Cells in each of which t is a plane, as few as keep what level lines bend below the tolerance (ramps.md).
const RampCells& RampPlanes::of(const VariedPaint& varied, const LitPaint* lit, int x, int y,
                                int side, LitPaint::Scratch& scratch) {
  const PaintField& field = varied.paint.field;
  const glm::dvec2 middle{x + 0.5, y + 0.5};
  const double allowed = varied.tolerance / varied.integral->range();
  if (field.kind == PaintField::Kind::distance)
    return distance_cells(varied, {*lit, scratch, x, y}, side, allowed);
  const double bend = 0.1 * field.bend(middle);
  while (side < PartCells::kMostSide && bend > allowed * side * side) side *= 2;
  const PartCells& whole = whole_cells(side);
  cells_.side = side, cells_.planes.clear();
  for (std::size_t k = 0; k < std::size_t(whole.count()); ++k)
    cells_.planes.push_back(varied.integral->scaled(
        field.plane(middle + glm::dvec2{whole.x[k], whole.y[k]}, 1.0 / (12.0 * side * side))));
  return cells_;
}

/// The same along a distance: by the quadratic through 4 × 4 places, those of the border among them. It leaves none of
/// them by more than the tolerance where there is no ridge.
bool RampPlanes::smooth_distance(const VariedPaint& varied, const Distances& distances, int side,
                                 double allowed) {
  constexpr int kPlaces = 4;
  constexpr double kSquare = 5.0 / 36,
                   kSpread = 1.0 / 81;  // means of x² and of (x² − kSquare)² over them
  tried_.side = kPlaces;
  for (std::size_t k = 0; k < kPlaces * kPlaces; ++k)
    tried_.x[k] = float(k % kPlaces) / 3 - 0.5f, tried_.y[k] = float(k / kPlaces) / 3 - 0.5f;
  std::array<float, kPlaces * kPlaces + kColorSpare> d;
  distances.at(tried_, d.data());
  using Terms = std::array<double, 6>;
  const auto terms = [&](double u, double v) {
    return Terms{1.0, u, v, u * u - kSquare, v * v - kSquare, u * v};
  };
  constexpr Terms kNorms{1.0, kSquare, kSquare, kSpread, kSpread, kSquare * kSquare};
  const auto at = [&](std::size_t k) { return terms(double(tried_.x[k]), double(tried_.y[k])); };
  Terms c{};
  for (std::size_t k = 0; k < kPlaces * kPlaces; ++k)
    for (std::size_t i = 0; i < c.size(); ++i)
      c[i] += at(k)[i] * double(d[k]) / (kNorms[i] * kPlaces * kPlaces);
  double off = 0.0;
  for (std::size_t k = 0; k < kPlaces * kPlaces; ++k) {
    double fit = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) fit += c[i] * at(k)[i];
    off = std::max(off, std::abs(fit - double(d[k])));
  }
  const double steep = c[1] * c[1] + c[2] * c[2];
  const double bend =
      (2.0 * c[3] * c[2] * c[2] + 2.0 * c[4] * c[1] * c[1] - 2.0 * c[5] * c[1] * c[2]) /
      (steep * std::sqrt(steep));
  if (!(off <= 0.3 * allowed && steep > 0.5)) return false;
  while (0.1 * std::abs(bend) > allowed * side * side) side *= 2;
  if (side > 4) return false;
  const PaintField& f = varied.paint.field;
  const PartCells& whole = whole_cells(side);
  cells_.side = side, cells_.planes.clear();
  for (std::size_t k = 0; k < std::size_t(side * side); ++k) {
    const auto u = double(whole.x[k]), v = double(whole.y[k]), own = 1.0 / (12 * side * side);
    const Terms t = terms(u, v);
    double mean = own * (c[3] + c[4]);
    for (std::size_t i = 0; i < c.size(); ++i) mean += c[i] * t[i];
    cells_.planes.push_back(
        varied.integral->scaled({f.at({}, mean), f.scale * (c[1] + 2.0 * c[3] * u + c[5] * v),
                                 f.scale * (c[2] + 2.0 * c[4] * v + c[5] * u)}));
  }
  return true;
}

/// By cells whose slopes and bends are differences between them.
const RampCells& RampPlanes::distance_cells(const VariedPaint& varied, const Distances& distances,
                                            int side, double allowed) {
  if (smooth_distance(varied, distances, side, allowed)) return cells_;
  const PaintField& f = varied.paint.field;
  std::array<float, PartCells::kMost + kColorSpare> d;
  for (side = std::max(side, 8);; side *= 2) {
    worked(100 * side * side);
    distances.at(whole_cells(side), d.data());
    double bends = 0.0;
    cells_.side = side, cells_.planes.clear();
    const auto difference = [&](int k, int i, int step) {
      const auto at = [&](int n) { return double(d[std::size_t(k + n * step)]); };
      const int from = std::clamp(i, 1, side - 2) - i;
      const double bend = at(from - 1) - 2.0 * at(from) + at(from + 1);
      bends = std::max(bends, std::abs(bend));
      return glm::dvec2{0.5 * (at(from + 1) - at(from - 1)) - from * bend, bend};
    };
    for (int k = 0; k < side * side; ++k) {
      const glm::dvec2 by_x = difference(k, k % side, 1), by_y = difference(k, k / side, side);
      const double mean = double(d[std::size_t(k)]) + (by_x.y + by_y.y) / 24;
      cells_.planes.push_back(varied.integral->scaled(
          {f.at({}, mean), side * by_x.x * f.scale, side * by_y.x * f.scale}));
    }
    if (side == PartCells::kMostSide || 0.1 * bends <= allowed) return cells_;
  }
}

}  // namespace mien
