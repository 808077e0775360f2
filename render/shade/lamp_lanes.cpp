#include <mien/render/blend/transfer.h>
#include <mien/render/shade/lamp_lanes.h>

#include <glm/geometric.hpp>

namespace mien {
namespace {

/// y is up where the lamp stands, down in the picture.
std::array<float, 3> flipped(const glm::dvec3& v) {
  return {float(v.x), float(-v.y), float(v.z)};
}

}  // namespace

void set_lamp(const LitSurface& surface, int zone, glm::dvec2 middle, double radius,
              LampLanes& to) {
  const TapeRelief& r = surface.relief();
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
  to.alpha = float(c.a);
  to.to_lamp = flipped(r.lamp.to_lamp()), to.halfway = flipped(r.lamp.halfway());
  to.ambient = float(r.lamp.ambient());
  to.diffuse = float((1.0 - r.lamp.ambient()) / r.lamp.to_lamp().z);
  to.level_shine = float(r.lamp.level_shine()), to.shininess = float(r.lamp.shininess());
  to.shine = float(r.lamp.specular() / (1.0 - r.lamp.level_shine()));
  if (!(r.lamp.specular() > 0.0)) to.shine = 0.0f;
  to.domes.clear();
  for (const TapeRelief::TapeDome& dome : r.domes) {
    const glm::dvec2 at = surface.center() + dome.center - middle;
    if (glm::length(at) > dome.max_radius + radius) continue;
    const glm::dmat2& u = dome.unit;
    to.domes.push_back({float(at.x), float(at.y), float(u[0][0]), float(u[1][0]), float(u[0][1]),
                        float(u[1][1]), float(-4.0 * dome.height)});
  }
}

}  // namespace mien
