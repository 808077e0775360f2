#include "tests/support/exact/exact_paint.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/exact/exact_light.h"
#include "tests/support/exact/exact_roots.h"

namespace mien::test {
namespace {

bool rises(const Relief& relief) {
  return relief.area.node >= 0 && relief.profile != Profile::flat && relief.height != 0;
}

/// A number for each thing that may begin or end.
std::size_t number(std::size_t what, std::size_t k) {
  return 64 * what + k + 1;
}

double most_per_unit(const Gradient& gradient) {
  if (const auto* l = std::get_if<LinearGradient>(&gradient.along))
    return 1 / glm::distance(l->from, l->to);
  if (const auto* r = std::get_if<RadialGradient>(&gradient.along))
    return 1 / std::min(r->radii.x, r->radii.y);
  const auto& d = std::get<DistanceGradient>(gradient.along);
  return 1 / std::abs(d.to - d.from);
}

}  // namespace

ExactPaint::ExactPaint(const Scene& scene, const ExactDistance& distance, const View& view,
                       double unit)
    : scene_(scene), distance_(distance), light_(scene.light()), unit_(unit) {
  if (view.light) light_.direction = *view.light;
  background_ = mixes(view.background.value_or(scene.background()), 1);
  for (const Layer& layer : scene.layers()) {
    bool hides = opaque(layer);
    for (int g = layer.group; g >= 0; g = scene.groups()[std::size_t(g)].parent)
      hides &= scene.groups()[std::size_t(g)].opacity == 1 &&
               scene.groups()[std::size_t(g)].mix == MixMode::normal;
    hides_.push_back(hides);
    flat_.push_back(mixes(layer.paint.color, 1));
  }
}

bool ExactPaint::opaque(const Layer& layer) const {
  if (layer.paint.color.a != 1) return false;
  const auto full = [](const Stop& stop) { return stop.color.a == 1; };
  return !layer.paint.gradient || std::ranges::all_of(layer.paint.gradient->stops, full);
}

bool ExactPaint::varies(int i, glm::dvec2 center, double radius) const {
  const Paint& paint = layer(i).paint;
  if (paint.gradient) return true;
  if (!paint.relief) return false;
  for (const Dome& dome : paint.relief->domes)
    if (glm::distance(center, dome.center) < radius + std::max(dome.radii.x, dome.radii.y))
      return true;
  if (!rises(*paint.relief)) return false;
  const double d = distance_(paint.relief->area, center);
  return d < radius && d > -paint.relief->width - radius;
}

bool ExactPaint::jumps(int i) const {
  if (is_lit(i)) return true;
  const auto& g = layer(i).paint.gradient;
  if (!g) return false;
  const auto same = [](const Stop& a, const Stop& b) { return a.at == b.at; };
  return g->extend == Extend::repeat ||
         std::adjacent_find(g->stops.begin(), g->stops.end(), same) != g->stops.end();
}

bool ExactPaint::upright(int i, glm::dvec2 p) const {
  constexpr double kAtTheOutline = 1e-6;  // [px]
  const auto& relief = layer(i).paint.relief;
  return relief && relief->profile == Profile::round && rises(*relief) &&
         std::abs(distance_(relief->area, p)) < kAtTheOutline * unit_;
}

Mixes ExactPaint::mixes(const Color& c, double opacity) const {
  const double a = c.a * opacity;
  return {{a * c.r, a * c.g, a * c.b, a},
          {a * encoded(c.r), a * encoded(c.g), a * encoded(c.b), a}};
}

double ExactPaint::place(const Gradient& gradient, glm::dvec2 p) const {
  constexpr double kBeyond = 1e300;  // all stops, where there is no extent
  if (const auto* g = std::get_if<LinearGradient>(&gradient.along))
    return g->from == g->to ? kBeyond
                            : glm::dot(p - g->from, g->to - g->from) /
                                  glm::dot(g->to - g->from, g->to - g->from);
  if (const auto* g = std::get_if<RadialGradient>(&gradient.along)) {
    if (!(g->radii.x > 0 && g->radii.y > 0)) return kBeyond;
    const glm::dvec2 m = p - g->center;
    return std::hypot(glm::dot(m, g->axis) / g->radii.x,
                      (g->axis.x * m.y - g->axis.y * m.x) / g->radii.y);
  }
  const auto& g = std::get<DistanceGradient>(gradient.along);
  const double beyond = distance_(g.area, p) - g.from;
  return g.to != g.from ? beyond / (g.to - g.from) : beyond < 0 ? -kBeyond : kBeyond;
}

Mixes ExactPaint::unlit(int i, glm::dvec2 p) const {
  if (!layer(i).paint.gradient) return flat_[std::size_t(i)];
  const Gradient& g = *layer(i).paint.gradient;
  const double first = g.stops.front().at, length = g.stops.back().at - first,
               opacity = layer(i).paint.color.a;
  double t = place(g, p);
  if (std::abs(t) >= 1e300) return mixes((t < 0 ? g.stops.front() : g.stops.back()).color, opacity);
  if (g.extend == Extend::repeat) t -= length * std::floor((t - first) / length);
  if (g.extend == Extend::reflect) {
    t = std::fmod(std::abs(t - first), 2 * length);
    t = first + (t > length ? 2 * length - t : t);
  }
  if (t < first) return mixes(g.stops.front().color, opacity);
  for (std::size_t k = 1; k < g.stops.size(); ++k)
    if (t < g.stops[k].at) {
      const double u = (t - g.stops[k - 1].at) / (g.stops[k].at - g.stops[k - 1].at);
      return (1 - u) * mixes(g.stops[k - 1].color, opacity) + u * mixes(g.stops[k].color, opacity);
    }
  return mixes(g.stops.back().color, opacity);
}

glm::dvec2 ExactPaint::slope_at(int i, glm::dvec2 p) const {
  const glm::dvec2 slope = surface_slope(distance_, *layer(i).paint.relief, p, kSlopeStep * unit_);
  return scene_.canvas().y_up ? slope : glm::dvec2{slope.x, -slope.y};
}

unsigned ExactPaint::clamps_at(int i, glm::dvec2 p) const {
  if (!is_lit(i)) return 0;
  const glm::dvec4 color = unlit(i, p).linear;
  if (!(color.a > 0)) return 0;
  return clamps(glm::dvec3(color) / color.a, slope_at(i, p), light_, *layer(i).paint.relief);
}

Mixes ExactPaint::at(int i, glm::dvec2 p) const {
  const Mixes color = unlit(i, p);
  const double a = color.linear.a;
  if (!is_lit(i) || !(a > 0)) return color;
  const Relief& relief = *layer(i).paint.relief;
  const glm::dvec2 slope = slope_at(i, p);
  if (slope == glm::dvec2{0.0}) return color;
  const glm::dvec3 light = lit(glm::dvec3(color.linear) / a, slope, light_, relief);
  const glm::dvec3 straight = glm::dvec3(color.srgb) / a;
  const glm::dvec3 code = layer(i).paint.gradient
                              ? lit({decoded(straight.r), decoded(straight.g), decoded(straight.b)},
                                    slope, light_, relief)
                              : light;
  return {{a * light, a}, {a * encoded(code.r), a * encoded(code.g), a * encoded(code.b), a}};
}

void ExactPaint::find_kinks(int i, const FaceLine& line, double a, double b,
                            std::vector<LineEnd>& out) const {
  const std::size_t what = 2 * std::size_t(i);
  if (layer(i).paint.gradient)
    gradient_kinks(*layer(i).paint.gradient, line, a, b, number(what, 0), out);
  if (layer(i).paint.relief) relief_kinks(*layer(i).paint.relief, line, a, b, number(what, 1), out);
}

/// Where the place crosses a stop, along the line.
void ExactPaint::gradient_kinks(const Gradient& g, const FaceLine& line, double a, double b,
                                std::size_t what, std::vector<LineEnd>& out) const {
  const double lipschitz = 1.0001 * unit_ * most_per_unit(g);
  const double middle = place(g, line(0.5 * (a + b))), reach = 0.51 * (b - a) * lipschitz;
  const double first = g.stops.front().at, length = g.stops.back().at - first;
  const bool pad = g.extend == Extend::pad || length == 0;
  const int from = pad ? 0 : int(std::floor((middle - reach - first) / length));
  const int to = pad ? 0 : int(std::floor((middle + reach - first) / length));
  std::vector<double> roots;
  for (int turn = from; turn <= to; ++turn)
    for (std::size_t k = 0; k < g.stops.size(); ++k) {
      const bool back = g.extend == Extend::reflect && turn % 2 != 0;
      const double from_first = g.stops[k].at - first;
      const double at = first + turn * length + (back ? length - from_first : from_first);
      if (std::abs(at - middle) > reach) continue;
      roots.clear();
      find_roots([&](double u) { return place(g, line(u)) - at; }, lipschitz, a, b, kShortest,
                 roots);
      for (const double root : roots) out.push_back({root, number(what, k)});
    }
}

std::vector<double> edges_of(const Relief& relief) {
  const std::size_t steps = relief.profile == Profile::custom ? relief.table.size() - 1 : 1;
  std::vector<double> depths;
  for (std::size_t k = 0; k <= steps; ++k)
    depths.push_back(relief.width * double(k) / double(steps));
  return depths;
}

/// Where the profile has an edge, and where domes end.
void ExactPaint::relief_kinks(const Relief& relief, const FaceLine& line, double a, double b,
                              std::size_t what, std::vector<LineEnd>& out) const {
  const double middle = 0.5 * (a + b);
  std::vector<double> roots;
  const auto add = [&](const auto& f, double lipschitz, std::size_t k) {
    if (std::abs(f(middle)) > 0.51 * (b - a) * lipschitz) return;
    roots.clear();
    find_roots(f, lipschitz, a, b, kShortest, roots);
    for (const double root : roots) out.push_back({root, number(what, k)});
  };
  if (rises(relief)) {
    const std::vector<double> depths = edges_of(relief);
    for (std::size_t k = 0; k < depths.size(); ++k)
      add([&](double u) { return (distance_(relief.area, line(u)) + depths[k]) / unit_; }, 1.0001,
          k);
  }
  for (std::size_t k = 0; k < relief.domes.size(); ++k) {
    const Dome& dome = relief.domes[k];
    const Gradient foot{.along = RadialGradient{dome.center, dome.radii, dome.axis}, .stops = {}};
    add([&](double u) { return place(foot, line(u)) - 1; }, 1.0001 * unit_ * most_per_unit(foot),
        32 + k);
  }
}

/// Whether the distance changes from a to b as the slopes at both ends foretell: not where two ridges between them turn
/// the slope there and back.
bool ExactPaint::goes_evenly(const ReliefLine& line, double a, const glm::dvec2& at_a, double b,
                             const glm::dvec2& at_b) const {
  constexpr double kBends =
      0.02;  // what slopes less than a tenth apart may bend by is half of that
  const double from = line.distance(a), way_a = glm::dot(at_a, line.way),
               way_b = glm::dot(at_b, line.way);
  const double middle = line.distance(0.5 * (a + b)) - from, all = line.distance(b) - from;
  return std::abs(all - (b - a) * (way_a + way_b) / 2) < kBends * (b - a) &&
         std::abs(middle - (b - a) * (3 * way_a + way_b) / 8) < kBends * (b - a);
}

/// Halves that end where the slope jumps, if it jumps and does not bend; then both sides of that.
void ExactPaint::ridges(const ReliefLine& line, double a, const glm::dvec2& at_a, double b,
                        const glm::dvec2& at_b, std::size_t what, std::vector<LineEnd>& out) const {
  constexpr double kSuspicious = 0.1, kJump = 0.01;  // of the slope of a distance, which is 1
  constexpr double kNear = 2e-5;                     // [px]
  if (b - a < 0.01) return;
  if (glm::distance(at_a, at_b) < kSuspicious) {
    if (goes_evenly(line, a, at_a, b, at_b)) return;
    const double m = 0.5 * (a + b);
    const glm::dvec2 at_m = line.slope(m);
    ridges(line, a, at_a, m, at_m, what, out), ridges(line, m, at_m, b, at_b, what, out);
    return;
  }
  double from = a, to = b;
  glm::dvec2 at_from = at_a, at_to = at_b;
  while (to - from > kNear && glm::distance(at_from, at_to) > kJump) {
    const double m = 0.5 * (from + to);
    const glm::dvec2 at_m = line.slope(m);
    if (glm::distance(at_from, at_m) > glm::distance(at_m, at_to))
      to = m, at_to = at_m;
    else
      from = m, at_from = at_m;
  }
  if (to - from > kNear) return;
  const bool strong = glm::distance(at_from, at_to) > kSuspicious;
  out.push_back({0.5 * (from + to), strong ? what : 0});
  from -= kNear, to += kNear;  // there differences are of one side
  if (from > a) ridges(line, a, at_a, from, line.slope(from), what, out);
  if (to < b) ridges(line, to, line.slope(to), b, at_b, what, out);
}

void ExactPaint::find_ridges(int i, const FaceLine& line, double a, double b,
                             std::vector<LineEnd>& out) const {
  const auto& relief = layer(i).paint.relief;
  if (!relief || !rises(*relief) || b - a < 10 * kSlopeStep) return;
  const ReliefLine along{[&](double u) {
                           return distance_slope(distance_, relief->area, line(u),
                                                 kSlopeStep * unit_);
                         },
                         [&](double u) { return distance_(relief->area, line(u)) / unit_; },
                         line.way / glm::length(line.way)};
  const double from = a + 2 * kSlopeStep, to = b - 2 * kSlopeStep;
  ridges(along, from, along.slope(from), to, along.slope(to), number(2 * std::size_t(i) + 1, 63),
         out);
}

}  // namespace mien::test
