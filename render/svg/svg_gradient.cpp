#include "render/svg/svg_gradient.h"
#include "render/shade/ramp/integral.h"
#include "render/svg/path_data.h"
#include "render/svg/svg_color.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace mien {
namespace {

constexpr int kMostHalvings = 6;
constexpr double kEvenPeriod = 1e-4;  // [px] what repeats so densely is its mean, as in pictures
constexpr double kShortest = 1e-3;    // [px] viewers take less for no length

/// A stop of the ramp itself.
struct PlacedMix {
  double at;
  Mix mix;
};

Mix straight_of(const Mix& mix, const Mix& if_transparent) {
  const Mix& from = mix.a > 0.0 ? mix : if_transparent;
  if (!(from.a > 0.0)) return Mix{0.0};
  return {from.r / from.a, from.g / from.a, from.b / from.a, mix.a};
}

/// Stops between two, such that mixing straight colours comes close to mixing premultiplied ones.
void add_between(const PlacedMix& a, const PlacedMix& b, int halvings, std::vector<SvgStop>& to) {
  const Mix s = straight_of(a.mix, b.mix), t = straight_of(b.mix, a.mix);
  const PlacedMix middle{0.5 * (a.at + b.at), 0.5 * (a.mix + b.mix)};
  Mix mixed = 0.5 * (s + t);
  mixed = Mix{mixed.a * mixed.r, mixed.a * mixed.g, mixed.a * mixed.b, mixed.a};
  if (halvings == 0 || largest(mixed - middle.mix) <= kStraightError) return;
  add_between(a, middle, halvings - 1, to);
  to.push_back({middle.at, straight_of(middle.mix, b.mix)});
  add_between(middle, b, halvings - 1, to);
}

std::vector<SvgStop> straight_stops(const std::vector<PlacedMix>& ramp) {
  std::vector<SvgStop> stops;
  const auto add = [&](const SvgStop& stop) {
    if (stops.empty() || stops.back().at != stop.at || stops.back().straight != stop.straight)
      stops.push_back(stop);
  };
  for (std::size_t i = 1; i < ramp.size(); ++i) {
    const PlacedMix &a = ramp[i - 1], &b = ramp[i];
    if (a.at == b.at && a.mix == b.mix) continue;
    add({a.at, straight_of(a.mix, b.mix)});
    if (b.at > a.at) add_between(a, b, kMostHalvings, stops);
    add({b.at, straight_of(b.mix, a.mix)});
  }
  return stops;
}

std::vector<PlacedMix> own_stops(const Ramp& ramp) {
  std::vector<PlacedMix> stops;
  for (std::size_t i = 0; i < ramp.at().size(); ++i)
    stops.push_back({ramp.at()[i], ramp.mixes()[i]});
  return stops;
}

/// The stops of all runs of a ramp that repeats or reflects, as far as they show between 0 and `to`.
std::vector<PlacedMix> run_stops(const Ramp& ramp, double to) {
  const std::vector<PlacedMix> own = own_stops(ramp);
  const double first = own.front().at, length = own.back().at - first;
  std::vector<PlacedMix> stops;
  for (double k = std::floor(-first / length); first + k * length < to; k += 1.0) {
    const bool backward = ramp.extend() == Extend::reflect && std::fmod(k, 2.0) != 0.0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const PlacedMix& stop = backward ? own[own.size() - 1 - i] : own[i];
      const double in = stop.at - first;
      stops.push_back({first + k * length + (backward ? length - in : in), stop.mix});
    }
  }
  return stops;
}

Mix mix_between(const PlacedMix& a, const PlacedMix& b, double t) {
  return b.at > a.at ? a.mix + (t - a.at) / (b.at - a.at) * (b.mix - a.mix) : b.mix;
}

/// Cut to what lies between two places; beyond its ends it stays as it is there.
std::vector<PlacedMix> cut_stops(const std::vector<PlacedMix>& all, double from, double to) {
  const auto at = [](const PlacedMix& a, double t) { return a.at < t; };
  const auto begin = std::upper_bound(all.begin(), all.end(), from,
                                      [](double t, const PlacedMix& a) { return t < a.at; });
  const auto end = std::lower_bound(begin, all.end(), to, at);
  std::vector<PlacedMix> stops;
  const auto add = [&](double t, std::vector<PlacedMix>::const_iterator next) {
    stops.push_back({t, next == all.begin() ? all.front().mix
                        : next == all.end() ? all.back().mix
                                            : mix_between(*(next - 1), *next, t)});
  };
  add(from, begin);
  stops.insert(stops.end(), begin, end);
  add(to, end);
  return stops;
}

std::string stops_text(const SvgRamp& ramp) {
  constexpr int kDecimals = 7;
  std::string text;
  for (const SvgStop& stop : ramp.stops) {
    const Mix& s = stop.straight;
    text += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"{}/>",
                        short_decimal((stop.at - ramp.from) / (ramp.to - ramp.from), kDecimals),
                        svg_color({s.r, s.g, s.b, 1.0}), svg_opacity("stop-opacity", s.a));
  }
  return text;
}

std::string spread_text(Extend extend) {
  switch (extend) {
    case Extend::pad:
      break;
    case Extend::repeat:
      return " spreadMethod=\"repeat\"";
    case Extend::reflect:
      return " spreadMethod=\"reflect\"";
  }
  return {};
}

/// An attribute of a place or length.
std::string placed(const char* name, double value) {
  return fmt::format(" {}=\"{:.8g}\"", name, value + 0.0);
}

SvgPaint made(const char* element, const std::string& id, const std::string& geometry,
              const SvgRamp& ramp) {
  return {fmt::format("<{0} id=\"{1}\" gradientUnits=\"userSpaceOnUse\"{2}{3}>{4}</{0}>\n", element,
                      id, geometry, spread_text(ramp.extend), stops_text(ramp)),
          fmt::format(" fill=\"url(#{})\"", id)};
}

/// Of periods that no pixel resolves.
std::optional<SvgPaint> even_paint(const Ramp& ramp, double pixels) {
  if (ramp.extend() == Extend::pad) return {};
  if (!((ramp.at().back() - ramp.at().front()) * pixels < kEvenPeriod)) return {};
  RampIntegral integral;
  integral.make(ramp);
  return svg_paint(integral.mean());
}

bool finite(glm::dvec2 p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}
bool finite(const Ramp& ramp) {
  return finite(glm::dvec2{ramp.at().front(), ramp.at().back()});
}

}  // namespace

SvgRamp ramp_along_line(const Ramp& ramp) {
  std::vector<PlacedMix> stops = own_stops(ramp);
  const double from = stops.front().at, to = stops.back().at;
  if (to > from) return {from, to, ramp.extend(), straight_stops(stops)};
  return {from - 1.0, to + 1.0, Extend::pad,
          straight_stops(cut_stops(stops, from - 1.0, to + 1.0))};
}

SvgRamp ramp_from_center(const Ramp& ramp) {
  const double first = ramp.at().front(), last = ramp.at().back();
  if (ramp.extend() == Extend::pad) {
    const double to = last > 0.0 ? last : 1.0;
    std::vector<PlacedMix> stops = cut_stops(own_stops(ramp), 0.0, to);
    if (last > 0.0) stops.push_back({to, ramp.mixes().back()});  // it may jump there
    return {0.0, to, Extend::pad, straight_stops(stops)};
  }
  const bool turns = ramp.extend() == Extend::reflect && first != 0.0;
  const double to = (turns ? 2.0 : 1.0) * (last - first);
  const auto stops = straight_stops(cut_stops(run_stops(ramp, to), 0.0, to));
  return {0.0, to, turns ? Extend::repeat : ramp.extend(), stops};
}

SvgPaint svg_paint(const Mix& mix) {
  return {{}, fmt::format(" fill=\"{}\"{}", svg_color(mix), svg_opacity("fill-opacity", mix.a))};
}

SvgPaint svg_paint(const LinearGradient& along, const Ramp& ramp,
                   const Map<GridSpace, FaceSpace>& map, const std::string& id) {
  if (along.from == along.to || !finite(along.from) || !finite(along.to) || !finite(ramp))
    return svg_paint(ramp.mixes().back());
  glm::dvec2 way = along.to - along.from;
  const double length = map.scale() * std::hypot(way.x, way.y);
  if (const auto even = even_paint(ramp, length)) return *even;
  const SvgRamp stops = ramp_along_line(ramp);
  if (length * (stops.to - stops.from) < kShortest)
    way *= kShortest / (length * (stops.to - stops.from));
  const glm::dvec2 a = map(along.from + stops.from * way), b = map(along.from + stops.to * way);
  return made("linearGradient", id,
              placed("x1", a.x) + placed("y1", a.y) + placed("x2", b.x) + placed("y2", b.y), stops);
}

SvgPaint svg_paint(const RadialGradient& along, const Ramp& ramp,
                   const Map<GridSpace, FaceSpace>& map, const std::string& id) {
  if (!(along.radii.x > 0.0 && along.radii.y > 0.0) || !finite(along.radii) ||
      !finite(along.center) || !finite(along.axis) || !finite(ramp))
    return svg_paint(ramp.mixes().back());
  if (const auto even = even_paint(ramp, map.scale() * std::max(along.radii.x, along.radii.y)))
    return *even;
  const SvgRamp stops = ramp_from_center(ramp);
  const glm::dvec2 c = map(along.center);
  if (along.radii.x == along.radii.y)
    return made(
        "radialGradient", id,
        placed("cx", c.x) + placed("cy", c.y) + placed("r", stops.to * along.radii.x * map.scale()),
        stops);
  const glm::dvec2 u = map.direction(glm::normalize(along.axis));
  const glm::dvec2 x = along.radii.x * u, y = along.radii.y * glm::dvec2{-u.y, u.x};
  const std::string matrix =
      fmt::format(" gradientTransform=\"matrix({:.8g} {:.8g} {:.8g} {:.8g} {:.8g} {:.8g})\"",
                  x.x + 0.0, x.y + 0.0, y.x + 0.0, y.y + 0.0, c.x + 0.0, c.y + 0.0);
  return made("radialGradient", id,
              placed("cx", 0.0) + placed("cy", 0.0) + placed("r", stops.to) + matrix, stops);
}

}  // namespace mien
