#include "render/shade/ramp/planes.h"
#include "lib/base/watch.h"
#include "render/shade/color_row.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

/// Of cells in which level lines bend by no more than they may: a multiple of `side`.
int side_for(float excess, int side) {
  const int most = PartCells::kMostSide / side;
  const float times = std::ceil(std::sqrt(std::sqrt(excess)) / float(side));
  return side * (times < float(most) ? std::max(int(times), 1) : most);
}

void add_cells(int x, int y, int side, RadialPlaces& to) {
  const double cell = 1.0 / side;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      to.add(x + (column + 0.5) * cell, y + (row + 0.5) * cell, cell * cell / 12.0);
}

}  // namespace

/// By as few cells as keep what level lines bend below the tolerance, whatever colour there is.
int RampPlanes::add(const VariedPaint& varied, const LitPaint* lit, int x, int y, int side,
                    LitPaint::Scratch& scratch, std::vector<RampPlane>& to) {
  const PaintField& field = varied.paint.field;
  const RampIntegral& ramp = *varied.integral;
  const BendRule rule(ramp, varied.tolerance, varied.linear);
  const Mix& least = ramp.least();
  finer_.room_for(1);
  finer_.r[0] = float(least.r), finer_.g[0] = float(least.g), finer_.b[0] = float(least.b);
  finer_.a[0] = float(ramp.most().a);
  const auto excess_of = [&] {
    bend_excesses(rule, bends_, finer_, excesses_);
    return excesses_[0];
  };
  if (field.kind == PaintField::Kind::distance) {
    bends_.assign(1, 1.0f);
    return distance_cells(varied, {*lit, scratch, x, y}, side,
                          BendRule::kLeft / std::sqrt(double(excess_of())), to);
  }
  if (field.kind == PaintField::Kind::radial) {
    add_cells(x, y, 1, places_);
    cells_.clear();
    add_radial_planes(field, ramp, places_, cells_, bends_);
    add_cells(x, y, side = side_for(excess_of(), side), places_);
    add_radial_planes(field, ramp, places_, to, bends_);
    return side;
  }
  const double cell = 1.0 / side;
  for (int k = 0; k < side * side; ++k)
    to.push_back(
        ramp.scaled(field.plane({x + (k % side + 0.5) * cell, y + (k / side + 0.5) * cell})));
  return side;
}

/// First as if level lines were straight: the lighter a pixel is the less shows what they bend.
void RampPlanes::radial_row(const VariedPaint& varied, int x, int y, int count, ColorRow& to) {
  const PaintField& field = varied.paint.field;
  const RampIntegral& ramp = *varied.integral;
  boxes_.clear(), bent_.clear();
  for (int i = 0; i < count; ++i) {
    places_.add(x + i + 0.5, y + 0.5, 1.0 / 12.0);
    boxes_.groups.push_back({std::size_t(i + 1), 1.0});
  }
  add_radial_planes(field, ramp, places_, boxes_.planes, bends_);
  ramp_means(ramp, boxes_, to, 0);
  bend_excesses({ramp, varied.tolerance, varied.linear}, bends_, to, excesses_);
  boxes_.clear();
  for (int i = 0; i < count; ++i) {
    const int side = side_for(excesses_[std::size_t(i)], 1);
    if (side == 1) continue;
    add_cells(x + i, y, side, places_);
    boxes_.groups.push_back({places_.x.size(), 1.0 / side}), bent_.push_back(i);
  }
  if (bent_.empty()) return;
  add_radial_planes(field, ramp, places_, boxes_.planes, bends_);
  ramp_means(ramp, boxes_, finer_, 0);
  for (std::size_t n = 0; n < bent_.size(); ++n) {
    const auto k = std::size_t(bent_[n]);
    to.r[k] = finer_.r[n], to.g[k] = finer_.g[n], to.b[k] = finer_.b[n], to.a[k] = finer_.a[n];
  }
}

/// The same along a distance: by the quadratic through 4 × 4 places, those of the border among them. It leaves none of
/// them by more than the tolerance where there is no ridge; else 0.
int RampPlanes::smooth_distance(const VariedPaint& varied, const Distances& distances, int side,
                                double allowed, std::vector<RampPlane>& to) {
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
  if (!(off <= 0.3 * allowed && steep > 0.5)) return 0;
  while (0.1 * std::abs(bend) > allowed * side * side) side *= 2;
  if (side > 4) return 0;
  const PaintField& f = varied.paint.field;
  const PartCells& whole = whole_cells(side);
  for (std::size_t k = 0; k < std::size_t(side * side); ++k) {
    const auto u = double(whole.x[k]), v = double(whole.y[k]), own = 1.0 / (12 * side * side);
    const Terms t = terms(u, v);
    double mean = own * (c[3] + c[4]);
    for (std::size_t i = 0; i < c.size(); ++i) mean += c[i] * t[i];
    to.push_back(
        varied.integral->scaled({f.at({}, mean), f.scale * (c[1] + 2.0 * c[3] * u + c[5] * v),
                                 f.scale * (c[2] + 2.0 * c[4] * v + c[5] * u)}));
  }
  return side;
}

/// By cells whose slopes and bends are differences between them.
int RampPlanes::distance_cells(const VariedPaint& varied, const Distances& distances, int side,
                               double allowed, std::vector<RampPlane>& to) {
  if (const int smooth = smooth_distance(varied, distances, side, allowed, to)) return smooth;
  const std::size_t before = to.size();
  const PaintField& f = varied.paint.field;
  std::array<float, PartCells::kMost + kColorSpare> d;
  for (side = std::max(side, 8);; side *= 2) {
    worked(100 * side * side);
    distances.at(whole_cells(side), d.data());
    double bends = 0.0;
    to.resize(before);
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
      to.push_back(varied.integral->scaled(
          {f.at({}, mean), side * by_x.x * f.scale, side * by_y.x * f.scale}));
    }
    if (side == PartCells::kMostSide || 0.1 * bends <= allowed) return side;
  }
}

}  // namespace mien
