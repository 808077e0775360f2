#include "render/shade/light/lamp_lanes.h"
#include "render/blend/transfer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// y is up where the lamp stands, down in the picture.
std::array<float, 3> flipped(const glm::dvec3& v) {
  return {float(v.x), float(-v.y), float(v.z)};
}

void set_ramp(const GridPaint& paint, const RampSegment* segment, glm::dvec2 middle, LampRamp& to) {
  to.kind = LampRamp::Kind::none;
  if (!paint.ramp || !segment) return;
  const PaintField& f = paint.field;
  if (f.kind == PaintField::Kind::linear) {
    to.kind = LampRamp::Kind::linear;
    to.x = float(f.at(middle, 0.0)), to.xx = float(f.across.x), to.xy = float(f.across.y);
  } else if (f.kind == PaintField::Kind::radial) {
    to.kind = LampRamp::Kind::radial;
    to.x = float(f.center.x - middle.x), to.y = float(f.center.y - middle.y);
    to.xx = float(f.unit[0][0]), to.xy = float(f.unit[1][0]);
    to.yx = float(f.unit[0][1]), to.yy = float(f.unit[1][1]);
  } else {
    to.kind = LampRamp::Kind::distance;
    to.x = float(f.at({}, 0.0)), to.xx = float(f.scale);
  }
  for (int c = 0; c < 4; ++c) {
    to.at[std::size_t(c)] = float(segment->at[c]);
    to.slope[std::size_t(c)] = float(segment->slope[c]);
  }
}

}  // namespace

void set_lamp(const LitSurface& surface, const LitPiece& piece, glm::dvec2 middle, double radius,
              LampLanes& to) {
  const int zone = piece.zone;
  const GridRelief& r = surface.relief();
  const bool flat = surface.flat(zone), round = r.profile == Profile::round;
  to.rise_kind = flat    ? LampLanes::Rise::none
                 : round ? LampLanes::Rise::round
                         : LampLanes::Rise::constant;
  to.rise = float(flat ? 0.0 : round ? r.height / r.width : surface.rise(zone, 0.0));
  to.width = float(r.width), to.one_over_width = float(1.0 / r.width);
  to.linear = surface.blend() == Blend::linear;
  const Mix& c = surface.paint().color;
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = c.a > 0.0 ? c[int(i)] / c.a : 0.0;
    to.light[i] = float(to.linear ? v : linear_from_srgb(v));
  }
  to.alpha = float(c.a), to.bend = 0.0f;
  set_ramp(surface.paint(), piece.segment, middle - surface.center(), to.ramp);
  // Where the picture is not in linear light a ramp is decoded, lit and encoded: it bends by up to the square of its
  // slope and half of that.
  if (to.ramp.kind != LampRamp::Kind::none && !to.linear) {
    const Mix& along = piece.segment->slope;
    const double slope = surface.paint().field.per_pixel *
                         std::max({std::abs(along.r), std::abs(along.g), std::abs(along.b)});
    to.bend += float(1.5 * slope * slope);
  }
  to.to_lamp = flipped(r.lamp.to_lamp()), to.halfway = flipped(r.lamp.halfway());
  to.ambient = float(r.lamp.ambient());
  to.diffuse = float((1.0 - r.lamp.ambient()) / r.lamp.to_lamp().z);
  to.level_shine = float(r.lamp.level_shine()), to.shininess = float(r.lamp.shininess());
  to.level_power = std::max(std::log2(to.level_shine), -126.0f);
  to.shine = float(r.lamp.specular() / (1.0 - r.lamp.level_shine()));
  if (!(r.lamp.specular() > 0.0)) to.shine = 0.0f;
  // Over a round profile's width colours make all their change, some 100 levels with a bend of 4 / width²; or a
  // highlight its own, of which as much counts as on domes.
  constexpr float kDiffuse = 1.6f;
  if (!flat && round)
    to.bend += std::max(kDiffuse, LampLanes::kUsualBend * to.shine * to.shininess) /
               float(r.width * r.width);
  to.domes.clear(), to.finest = 1e9f;
  const float leans = std::hypot(to.halfway[0], to.halfway[1]);
  to.by_slope = 100.0f + 255.0f * to.shine * to.shininess * to.level_shine * leans;
  for (const GridRelief::GridDome& dome : r.domes) {
    const glm::dvec2 at = surface.center() + dome.center - middle;
    if (glm::length(at) > dome.max_radius + radius) continue;
    const glm::dmat2& u = dome.unit;
    const double steepest =
        std::max(u[0][0] * u[0][0] + u[1][0] * u[1][0], u[0][1] * u[0][1] + u[1][1] * u[1][1]);
    // The slope's own slope jumps by 8 height / radius² there.
    constexpr double kSeen = 3.0;  // [levels/px²]
    const bool shows = 8.0 * double(to.by_slope) * std::abs(dome.height) * steepest > kSeen;
    to.domes.push_back({float(at.x), float(at.y), float(u[0][0]), float(u[1][0]), float(u[0][1]),
                        float(u[1][1]), float(-4.0 * dome.height),
                        shows ? float(0.5 / std::sqrt(steepest)) : 0.0f});
    // The slope changes by 4 height / radius² per pixel at the top; a highlight is a bell of 1 / √shininess in slope.
    const double r2 = 1.0 / steepest;
    const double bell = r2 / (4.0 * std::abs(dome.height) * std::sqrt(r.lamp.shininess()));
    to.finest = float(std::min({double(to.finest), std::sqrt(r2), to.shine > 0.0f ? bell : 1e9}));
  }
}

}  // namespace mien
