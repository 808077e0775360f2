#include "render/shade/light/lit_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

void LitSurface::make(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
                      glm::dvec2 center) {
  paint_ = &paint, blend_ = blend, center_ = center;
  area_ = gradient_area_ = nullptr;
  levels_.clear(), rises_.clear();
  if (paint.ramp && paint.field.kind == PaintField::Kind::distance)
    gradient_area_ = &distances[std::size_t(paint.field.distance)];
  const GridRelief& r = relief();
  if (r.distance < 0 || r.profile == Profile::flat || r.height == 0.0) return;
  area_ = &distances[std::size_t(r.distance)];
  levels_.push_back(0.0);
  if (r.profile == Profile::custom) {
    const std::size_t steps = r.table.size() - 1;
    for (std::size_t i = 0; i < steps; ++i) {
      if (i > 0) levels_.push_back(-r.width * double(i) / double(steps));
      rises_.push_back(r.height / r.width * double(steps) * (r.table[i + 1] - r.table[i]));
    }
  }
  levels_.push_back(-r.width);
}

int LitSurface::zone_of(double d) const {
  return int(
      std::count_if(levels_.begin(), levels_.end(), [&](double level) { return d <= level; }));
}

int LitSurface::zone_inside(double d) const {
  const double outline = relief().own ? 1e-2 : 1e-4;
  return zone_of(d > 0.0 && d < outline ? 0.0 : d);
}

bool LitSurface::flat(int zone) const {
  if (zone <= 0 || zone >= zones() - 1) return true;
  return !rises_.empty() && rises_[std::size_t(zone) - 1] == 0.0;
}

double LitSurface::rise(int zone, double depth) const {
  if (flat(zone)) return 0.0;
  const GridRelief& r = relief();
  if (r.profile == Profile::bevel) return r.height / r.width;
  if (r.profile == Profile::custom) return rises_[std::size_t(zone) - 1];
  constexpr double kSteepest = 1e-9;  // of the width: upright at the outline itself, but finite
  const double out = 1.0 - std::clamp(depth / r.width, kSteepest, 1.5);
  return r.height / r.width * out / std::sqrt(1.0 - out * out);
}

/// By how much the normal turns [rad] within `reach` of a place, by domes and along the relief's own: no more than their
/// slopes change. A dome's 4 h (1 − q²) Uᵀ q changes by 4 h |U|² (1 − q²) across, and by 1 − 3 q² of that along.
double LitSurface::turns_by(int zone, glm::dvec2 p, const Outward& at, double reach) const {
  double turns = 0.0;
  for (const GridRelief::GridDome& dome : relief().domes) {
    const glm::dvec2 x = dome.unit[0], y = dome.unit[1];
    const double square = glm::dot(x, x) + glm::dot(y, y), wide = std::sqrt(square) * reach;
    const double out = glm::length(dome.unit * (p - center_ - dome.center));
    const double near = std::max(out - wide, 0.0), far = std::min(out + wide, 1.0);
    if (near < 1.0)
      turns += 4.0 * std::abs(dome.height) * square * reach *
               std::max(1.0 - near * near, 3.0 * far * far - 1.0);
  }
  if (flat(zone) || relief().profile != Profile::round) return turns;
  const double width = relief().width, here = std::atan(rise(zone, -at.d));
  return turns + std::max(std::abs(std::atan(rise(zone, std::max(-at.d - reach, 0.0))) - here),
                          std::abs(std::atan(rise(zone, std::min(reach - at.d, width))) - here));
}

bool LitSurface::highlight_hides(int zone, glm::dvec2 p, const Outward& at, double reach) const {
  constexpr double kSeen = 1e-3;  // of white
  constexpr double kBell = 0.8;   // of its width: four places see a bell of a peak and its flanks
  const Lamp& lamp = relief().lamp;
  if (!(lamp.specular() > 0.0)) return false;
  const glm::dvec3& h = lamp.halfway();
  // A highlight ends where it is as bright as on a level surface.
  const double wide = std::min(1.0 / std::sqrt(lamp.shininess()), std::hypot(h.x, h.y));
  const double turns = turns_by(zone, p, at, reach);
  if (turns <= kBell * wide) return false;
  const glm::dvec2 s = slope(zone, p, at);
  const glm::dvec3 n = glm::normalize(glm::dvec3{-s.x, -s.y, 1.0});
  const double angle = std::max(std::acos(std::clamp(glm::dot(h, n), -1.0, 1.0)) - turns, 0.0);
  const double most = std::pow(std::max(std::cos(angle), 0.0), lamp.shininess());
  return lamp.specular() * (most - lamp.level_shine()) > kSeen * (1.0 - lamp.level_shine());
}

Outward LitSurface::outward(glm::dvec2 p) const {
  return area_ ? area_->outward(p - center_) : Outward{};
}

Outward LitSurface::outward(glm::dvec2 p, std::span<const Node> nodes) const {
  return area_ ? area_->outward(p - center_, nodes) : Outward{};
}

Mix LitSurface::base(const LitPiece& piece, glm::dvec2 p, double d) const {
  if (!paint_->ramp) return paint_->color;
  if (gradient_area_ && gradient_area_ != area_) d = gradient_area_->at(p - center_);
  const double t = paint_->field.at(p - center_, d);
  if (!piece.segment) return paint_->ramp->color(t);
  const RampSegment& s = *piece.segment;
  return s.at + std::clamp(t, s.from, s.to) * s.slope;
}

glm::dvec2 LitSurface::slope(int zone, glm::dvec2 p, const Outward& outward) const {
  glm::dvec2 rises = -rise(zone, -outward.d) * outward.normal;
  for (const GridRelief::GridDome& dome : relief().domes) {
    const glm::dvec2 q = dome.unit * (p - center_ - dome.center);
    const double in = 1.0 - glm::dot(q, q);
    if (in > 0.0) rises += -4.0 * dome.height * in * (glm::transpose(dome.unit) * q);
  }
  return {rises.x, -rises.y};
}

Mix LitSurface::color(const LitPiece& piece, glm::dvec2 p, const Outward& outward) const {
  return relief().lamp.lit(base(piece, p, outward.d), slope(piece.zone, p, outward), blend_);
}

}  // namespace mien
