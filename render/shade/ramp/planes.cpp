#include "render/shade/ramp/planes.h"
#include "render/shade/color_row.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// What level lines bend by too much in the darkest colour there is.
float RampPlanes::excess_of(const VariedPaint& varied, const RampIntegral& ramp) {
  const Mix& least = ramp.least();
  finer_.room_for(1);
  finer_.r[0] = float(least.r), finer_.g[0] = float(least.g), finer_.b[0] = float(least.b);
  finer_.a[0] = float(ramp.most().a);
  bend_excesses({ramp, varied.tolerance, varied.linear}, bends_, finer_, excesses_);
  return excesses_[0];
}

const RampSoftness& RampPlanes::softness(const VariedPaint& varied, const RampIntegral& ramp) {
  if (std::exchange(softness_of_, &ramp) == &ramp) return softness_;
  bends_.assign(1, 1.0f);
  softness_.make(varied.paint.field, ramp,
                 BendRule::kLeft / std::sqrt(double(excess_of(varied, ramp))),
                 varied.by_integral ? &*varied.paint.ramp : nullptr);
  return softness_;
}

/// By as few cells as keep what level lines bend below the tolerance, whatever colour there is.
int RampPlanes::add(const VariedPaint& varied, const RampIntegral& ramp, const LitPaint* lit, int x,
                    int y, int side, LitPaint::Scratch& scratch, std::vector<RampPlane>& to,
                    bool part) {
  const PaintField& field = varied.paint.field;
  if (field.kind == PaintField::Kind::distance) {
    const std::size_t before = to.size();
    const int made =
        distances_.of(lit->gradient_area(), x, y, side, part, softness(varied, ramp), to);
    if (made == 0)
      scratch.doubts().push_back({x, 1.0f}), to.resize(before + std::size_t(side * side));
    for (std::size_t k = before; k < to.size(); ++k)
      to[k] = ramp.scaled({field.at({}, to[k].t), field.scale * to[k].gx, field.scale * to[k].gy});
    return std::max(made, side);
  }
  if (field.kind == PaintField::Kind::radial) {
    add_cells(x, y, 1, places_);
    cells_.clear();
    add_radial_planes(field, ramp, places_, cells_, bends_);
    add_cells(x, y, side = side_for(excess_of(varied, ramp), side), places_);
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
  const RampIntegral& ramp = varied.integral;
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

}  // namespace mien
