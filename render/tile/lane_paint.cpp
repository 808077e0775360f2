#include <mien/render/tile/lane_paint.h>

#include <mien/render/blend/transfer.h>

#include <cmath>

namespace mien {
namespace {

std::array<float, 3> floats(const glm::dvec3& v) {
  return {float(v.x), float(v.y), float(v.z)};
}

void set_ramp(const Ramp& ramp, LanePaint& to) {
  to.stops = int(ramp.at().size());
  to.extend = ramp.extend();
  for (std::size_t i = 0; i < ramp.at().size(); ++i) {
    to.at[i] = float(ramp.at()[i]);
    for (std::size_t c = 0; c < 4; ++c) to.mix[i][c] = float(ramp.mixes()[i][int(c)]);
  }
}

void set_place(const PaintField& field, glm::dvec2 center, LanePaint& to) {
  to.kind = field.kind;
  switch (field.kind) {
    case PaintField::Kind::linear:
      to.place_x = float(field.across.x), to.place_y = float(field.across.y);
      to.shift = float(field.at(center, 0.0));
      break;
    case PaintField::Kind::radial:
      to.cx = float(field.center.x - center.x), to.cy = float(field.center.y - center.y);
      to.u00 = float(field.unit[0][0]), to.u01 = float(field.unit[0][1]);
      to.u10 = float(field.unit[1][0]), to.u11 = float(field.unit[1][1]);
      break;
    case PaintField::Kind::distance:
      to.place_x = float(field.scale), to.shift = float(-field.from * field.scale);
      break;
  }
}

void set_relief(const TapeRelief& relief, glm::dvec2 center, LanePaint& to) {
  to.lit = true;
  to.profile = relief.distance < 0 ? Profile::flat : relief.profile;
  to.width = float(relief.width), to.per_pixel = float(relief.height / relief.width);
  if (to.profile == Profile::custom) {
    to.steps = int(relief.table.size()) - 1;
    for (std::size_t i = 0; i + 1 < relief.table.size(); ++i)
      to.rises[i] =
          float(relief.height / relief.width * to.steps * (relief.table[i + 1] - relief.table[i]));
  }
  for (const auto& dome : relief.domes) {
    const glm::dmat2& u = dome.unit;
    to.domes[std::size_t(to.dome_count++)] = {float(dome.center.x - center.x),
                                              float(dome.center.y - center.y),
                                              float(u[0][0]),
                                              float(u[0][1]),
                                              float(u[1][0]),
                                              float(u[1][1]),
                                              float(dome.height)};
  }
  to.to_lamp = floats(relief.lamp.to_lamp()), to.halfway = floats(relief.lamp.halfway());
  to.ambient = float(relief.lamp.ambient()), to.specular = float(relief.lamp.specular());
  to.shininess = float(relief.lamp.shininess());
  to.level_shine = float(relief.lamp.level_shine());
}

}  // namespace

bool fits_lanes(const TapePaint& paint) {
  if (paint.ramp && paint.ramp->at().size() > std::size_t(LanePaint::kMostStops)) return false;
  if (!paint.relief) return true;
  return paint.relief->domes.size() <= std::tuple_size_v<decltype(LanePaint::domes)> &&
         paint.relief->table.size() <= std::size_t(LanePaint::kMostSteps);
}

std::optional<LanePaint> lane_paint(const TapePaint& paint, Blend blend, glm::dvec2 center) {
  LanePaint made;
  const Mix& c = paint.color;
  for (std::size_t i = 0; i < 4; ++i) made.color[i] = float(c[int(i)]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = c.a > 0.0 ? c[int(i)] / c.a : 0.0;
    made.light[i] = float(blend == Blend::linear ? v : linear_from_srgb(v));
  }
  if (paint.ramp) {
    set_ramp(*paint.ramp, made);
    set_place(paint.field, center, made);
    if (!(std::abs(made.shift) <= LanePaint::kFarthest)) return {};
    for (int i = 0; i < made.stops; ++i)
      if (!(std::abs(made.at[std::size_t(i)]) <= LanePaint::kFarthest)) return {};
  }
  if (paint.relief) set_relief(*paint.relief, center, made);
  return made;
}

}  // namespace mien
