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
