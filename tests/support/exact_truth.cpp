#include "tests/support/exact_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::test {
namespace {

double encoded(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

glm::dvec4 laid_over(glm::dvec4 top, glm::dvec4 below) {
  return top + (1 - top.a) * below;
}

double largest(const glm::dvec4& v) {
  return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b), std::abs(v.a)});
}

constexpr double kGaussPlace[3] = {0.5 - 0.38729833462074170, 0.5, 0.5 + 0.38729833462074170};
constexpr double kGaussWeight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/// The one change of sign between a and b: the secant of the ends, of which one that stays twice counts half.
double root_between(const std::function<double(double)>& f, double a, double fa, double b,
                    double fb) {
  constexpr double kNear = 1e-13;  // [px]
  double weight_a = fa, weight_b = fb;
  for (int i = 0; i < 60 && b - a > kNear; ++i) {
    const double secant = a + (b - a) * (weight_a / (weight_a - weight_b));
    const double m = i % 8 == 7 || !(secant > a && secant < b)  // a jump or a flat: halves
                         ? 0.5 * (a + b)
                         : std::clamp(secant, a + 0.4 * kNear, b - 0.4 * kNear);
    const double fm = f(m);
    if ((fm <= 0) == (fa <= 0)) {
      a = m, weight_a = fm, weight_b *= 0.5;
    } else {
      b = m, weight_b = fm, weight_a *= 0.5;
    }
  }
  return 0.5 * (a + b);
}

void find_between(const std::function<double(double)>& f, double lipschitz, double a, double fa,
                  double b, double fb, double shortest, std::vector<double>& out) {
  if (b - a < shortest) {
    if ((fa <= 0) != (fb <= 0)) out.push_back(root_between(f, a, fa, b, fb));
    return;
  }
  const double m = 0.5 * (a + b), fm = f(m);
  if (std::abs(fm) > 0.5 * (b - a) * lipschitz) return;
  find_between(f, lipschitz, a, fa, m, fm, shortest, out);
  find_between(f, lipschitz, m, fm, b, fb, shortest, out);
}

}  // namespace

void find_roots(const std::function<double(double)>& f, double lipschitz, double a, double b,
                double shortest, std::vector<double>& out) {
  find_between(f, lipschitz, a, f(a), b, f(b), shortest, out);
}

ExactTruth::ExactTruth(const Scene& scene, const View& view, double tolerance)
    : scene_(scene), view_(view), tolerance_(tolerance) {
  const glm::dvec2 size = scene.canvas().box.size();
  const double sx = view.width / size.x, sy = view.height / size.y;
  unit_ = 1 / (view.fit == Fit::meet ? std::min(sx, sy) : std::max(sx, sy));
}

glm::dvec2 ExactTruth::face(double x, double y) const {
  const glm::dvec2 p{unit_ * (x - 0.5 * view_.width), unit_ * (y - 0.5 * view_.height)};
  return scene_.canvas().box.center() + glm::dvec2{p.x, scene_.canvas().y_up ? -p.y : p.y};
}

glm::dvec4 ExactTruth::blended(const Color& c, double opacity) const {
  const double a = c.a * opacity;
  if (view_.blend == Blend::linear) return {a * c.r, a * c.g, a * c.b, a};
  return {a * encoded(c.r), a * encoded(c.g), a * encoded(c.b), a};
}

double ExactTruth::place(const Gradient& gradient, glm::dvec2 p) const {
  if (const auto* g = std::get_if<LinearGradient>(&gradient.along))
    return glm::dot(p - g->from, g->to - g->from) / glm::dot(g->to - g->from, g->to - g->from);
  if (const auto* g = std::get_if<RadialGradient>(&gradient.along)) {
    const glm::dvec2 m = p - g->center;
    return std::hypot(glm::dot(m, g->axis) / g->radii.x,
                      (g->axis.x * m.y - g->axis.y * m.x) / g->radii.y);
  }
  const auto& g = std::get<DistanceGradient>(gradient.along);
  return (scene_.distance(g.area, p) - g.from) / (g.to - g.from);
}

glm::dvec4 ExactTruth::paint(const Layer& layer, glm::dvec2 p) const {
  if (!layer.paint.gradient) return blended(layer.paint.color, 1);
  const Gradient& g = *layer.paint.gradient;
  const double first = g.stops.front().at, length = g.stops.back().at - first,
               opacity = layer.paint.color.a;
  double t = place(g, p);
  if (g.extend == Extend::repeat) t -= length * std::floor((t - first) / length);
  if (g.extend == Extend::reflect) {
    t = std::fmod(std::abs(t - first), 2 * length);
    t = first + (t > length ? 2 * length - t : t);
  }
  if (t < first) return blended(g.stops.front().color, opacity);
  for (std::size_t i = 1; i < g.stops.size(); ++i)
    if (t < g.stops[i].at) {
      const double u = (t - g.stops[i - 1].at) / (g.stops[i].at - g.stops[i - 1].at);
      return (1 - u) * blended(g.stops[i - 1].color, opacity) +
             u * blended(g.stops[i].color, opacity);
    }
  return blended(g.stops.back().color, opacity);
}

/// Layers bottom to top; a group is collected by itself and then laid over what was there.
glm::dvec4 ExactTruth::color(const Square& square, glm::dvec2 p) const {
  std::vector<glm::dvec4> mixes{blended(view_.background.value_or(scene_.background()), 1)};
  std::vector<int> open;
  const auto chain = [&](int group) {
    std::vector<int> groups;
    for (; group >= 0; group = scene_.groups()[std::size_t(group)].parent)
      groups.insert(groups.begin(), group);
    return groups;
  };
  const auto close_to = [&](std::size_t depth) {
    while (open.size() > depth) {
      const glm::dvec4 mix = scene_.groups()[std::size_t(open.back())].opacity * mixes.back();
      mixes.pop_back();
      open.pop_back();
      mixes.back() = laid_over(mix, mixes.back());
    }
  };
  for (const Seen& seen : square.seen) {
    const Layer& layer = scene_.layers()[std::size_t(seen.layer)];
    if (!seen.whole && !(scene_.distance(layer.area, p) <= 0)) continue;
    const std::vector<int> wanted = chain(layer.group);
    std::size_t same = 0;
    while (same < open.size() && same < wanted.size() && open[same] == wanted[same]) ++same;
    close_to(same);
    for (std::size_t i = same; i < wanted.size(); ++i)
      open.push_back(wanted[i]), mixes.emplace_back(0.0);
    mixes.back() = laid_over(paint(layer, p), mixes.back());
  }
  close_to(0);
  return mixes.back();
}

ExactTruth::Square ExactTruth::square(int x, int y) const {
  Square square{{}, double(x), double(y), {}};
  const glm::dvec2 center = face(x + 0.5, y + 0.5);
  const double radius = 0.70711 * unit_;
  for (int i = 0; i < int(scene_.layers().size()); ++i) {
    const Layer& layer = scene_.layers()[std::size_t(i)];
    const double d = scene_.distance(layer.area, center);
    if (d > radius) continue;
    const bool whole = d < -radius;
    if (whole && layer.group < 0 && !layer.paint.gradient && layer.paint.color.a == 1)
      square.seen.clear();
    square.seen.push_back({i, whole});
  }
  return square;
}

/// Where the place crosses a stop, along the line.
void ExactTruth::find_kinks(const Gradient& g, const Square& square, double y,
                            std::vector<double>& out) const {
  double lipschitz = 0;
  if (const auto* l = std::get_if<LinearGradient>(&g.along))
    lipschitz = 1 / glm::distance(l->from, l->to);
  else if (const auto* r = std::get_if<RadialGradient>(&g.along))
    lipschitz = 1 / std::min(r->radii.x, r->radii.y);
  else
    lipschitz = 1 / std::abs(std::get<DistanceGradient>(g.along).to -
                             std::get<DistanceGradient>(g.along).from);
  lipschitz *= 1.0001 * unit_;
  const double middle = place(g, face(square.x + 0.5, y)), reach = 0.51 * lipschitz;
  const double first = g.stops.front().at, length = g.stops.back().at - first;
  const bool pad = g.extend == Extend::pad || length == 0;
  const int from = pad ? 0 : int(std::floor((middle - reach - first) / length));
  const int to = pad ? 0 : int(std::floor((middle + reach - first) / length));
  for (int turn = from; turn <= to; ++turn)
    for (const Stop& stop : g.stops) {
      const bool back = g.extend == Extend::reflect && turn % 2 != 0;
      const double at =
          first + turn * length + (back ? length - (stop.at - first) : stop.at - first);
      if (std::abs(at - middle) > reach) continue;
      find_roots([&](double x) { return place(g, face(x, y)) - at; }, lipschitz, square.x,
                 square.x + 1, kShortest, out);
    }
}

/// Where along the line y [px] of a pixel anything begins or ends, in order, the pixel's sides among
/// them.
std::vector<double> ExactTruth::ends_of(const Square& square, double y) const {
  std::vector<double> ends{square.x, square.x + 1};
  for (const Seen& seen : square.seen) {
    const Layer& layer = scene_.layers()[std::size_t(seen.layer)];
    if (!seen.whole)
      find_roots([&](double x) { return scene_.distance(layer.area, face(x, y)) / unit_; }, 1.0001,
                 square.x, square.x + 1, kShortest, ends);
    if (layer.paint.gradient) find_kinks(*layer.paint.gradient, square, y, ends);
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// The integral of the colour along that line.
glm::dvec4 ExactTruth::line(const Square& square, double y, std::size_t& order) const {
  const std::vector<double> ends = ends_of(square, y);
  order = order_along(square, ends, y);
  glm::dvec4 sum{0.0};
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i] - ends[i - 1] > 1e-13) {
      const glm::dvec4 whole = span(square, ends[i - 1], ends[i], y);
      sum += plain(square) ? whole : refined_span(square, ends[i - 1], ends[i], y, whole, 16);
    }
  return sum;
}

/// The integral between two ends, where the colour is smooth, and that refined.
glm::dvec4 ExactTruth::span(const Square& square, double a, double b, double y) const {
  glm::dvec4 sum{0.0};
  for (int k = 0; k < 3; ++k)
    sum += kGaussWeight[k] * (b - a) * color(square, face(a + kGaussPlace[k] * (b - a), y));
  return sum;
}

glm::dvec4 ExactTruth::refined_span(const Square& square, double a, double b, double y,
                                    glm::dvec4 coarse, int depth) const {
  const double m = 0.5 * (a + b);
  const glm::dvec4 left = span(square, a, m, y), right = span(square, m, b, y);
  if (depth == 0 || largest(left + right - coarse) <= tolerance_ / 4) return left + right;
  return refined_span(square, a, m, y, left, depth - 1) +
         refined_span(square, m, b, y, right, depth - 1);
}

bool ExactTruth::plain(const Square& square) const {
  return std::none_of(square.seen.begin(), square.seen.end(), [&](const Seen& seen) {
    return scene_.layers()[std::size_t(seen.layer)].paint.gradient != nullptr;
  });
}

/// Whether a colour in the pixel jumps, along a line that may cut a corner off and be missed by few lines.
bool ExactTruth::jumps(const Square& square) const {
  return std::any_of(square.seen.begin(), square.seen.end(), [&](const Seen& seen) {
    const auto& g = scene_.layers()[std::size_t(seen.layer)].paint.gradient;
    if (!g) return false;
    const auto same = [](const Stop& a, const Stop& b) { return a.at == b.at; };
    return g->extend == Extend::repeat ||
           std::adjacent_find(g->stops.begin(), g->stops.end(), same) != g->stops.end();
  });
}

/// Which layers are where along the line, as a number: a line on which they are otherwise has most
/// probably another one.
std::size_t ExactTruth::order_along(const Square& square, const std::vector<double>& ends,
                                    double y) const {
  constexpr double kNothing = 1e-7;  // shorter spans are where two ends meet
  std::size_t order = 1;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] - ends[i - 1] < kNothing) continue;
    for (const Seen& seen : square.seen) {
      const Area area = scene_.layers()[std::size_t(seen.layer)].area;
      const glm::dvec2 p = face(0.5 * (ends[i - 1] + ends[i]), y);
      order = order * 31 + (seen.whole || scene_.distance(area, p) <= 0 ? 2u : 1u);
    }
  }
  return order;
}

ExactTruth::Rows ExactTruth::rows(const Square& square, double top, double bottom) const {
  Rows rows{.sum = glm::dvec4{0.0}, .order = 0, .alike = true};
  for (int k = 0; k < 3; ++k) {
    std::size_t order = 0;
    rows.sum += kGaussWeight[k] * (bottom - top) *
                line(square, top + kGaussPlace[k] * (bottom - top), order);
    rows.alike &= k == 0 || order == rows.order;
    rows.order = order;
  }
  for (const double y : {top, bottom}) {
    if (!rows.alike) break;
    const auto [known, is_new] = square.orders.try_emplace(y);
    if (is_new) known->second = order_along(square, ends_of(square, y), y);
    rows.alike = known->second == rows.order;
  }
  return rows;
}

/// Halves agree by chance where layers come and go between the lines: there halving goes on.
glm::dvec4 ExactTruth::refined(const Square& square, double top, double bottom, const Rows& coarse,
                               int depth) const {
  const double middle = 0.5 * (top + bottom);
  const Rows upper = rows(square, top, middle), lower = rows(square, middle, bottom);
  const bool alike = upper.alike && lower.alike && upper.order == lower.order;
  if (depth == 0 || (alike && largest(upper.sum + lower.sum - coarse.sum) <= tolerance_ / 8))
    return upper.sum + lower.sum;
  return refined(square, top, middle, upper, depth - 1) +
         refined(square, middle, bottom, lower, depth - 1);
}

glm::dvec4 ExactTruth::pixel(int x, int y) const {
  const Square s = square(x, y);
  const bool whole =
      std::all_of(s.seen.begin(), s.seen.end(), [](const Seen& seen) { return seen.whole; });
  if (whole && plain(s)) return color(s, face(x + 0.5, y + 0.5));
  constexpr int kDepth = 16;
  const int strips = whole && !jumps(s) ? 2 : 24;
  glm::dvec4 sum{0.0};
  for (int i = 0; i < strips; ++i) {
    const double top = y + double(i) / strips, bottom = y + double(i + 1) / strips;
    sum += refined(s, top, bottom, rows(s, top, bottom), kDepth);
  }
  return sum;
}

glm::dvec4 ExactTruth::levels(int x, int y, int top) const {
  const glm::dvec4 mix = pixel(x, y);
  glm::dvec4 out{0, 0, 0, top * mix.a};
  for (int i = 0; i < 3 && mix.a > 0; ++i)
    out[i] = top * (view_.blend == Blend::linear ? encoded(mix[i] / mix.a) : mix[i] / mix.a);
  return out;
}

ExactError compare_exactly(std::span<const Image> images, const ExactTruth& truth,
                           std::span<const double> allowed, int every) {
  ExactError error;
  for (int y = 0; y < images[0].height; ++y)
    for (int x = y % every; x < images[0].width; x += every) {
      const glm::dvec4 exact = truth.levels(x, y, 1);
      for (std::size_t i = 0; i < images.size(); ++i) {
        const Image& image = images[i];
        const bool wide = image.depth == Depth::u16;
        const double top = wide ? 65535 : 255;
        glm::dvec4 drawn;
        for (int k = 0; k < 4; ++k)
          drawn[k] = wide ? reinterpret_cast<const std::uint16_t*>(image.row(y))[4 * x + k]
                          : image.row(y)[4 * x + k];
        const double most = largest(drawn - top * exact);
        if (!(most > allowed[i])) continue;
        ++error.over;
        const glm::dvec4 t = top * exact;
        error.where = fmt::format("({}, {}) of {}: truth {} {} {} {}, drawn {} {} {} {}", x, y, top,
                                  t.r, t.g, t.b, t.a, drawn.r, drawn.g, drawn.b, drawn.a);
      }
    }
  return error;
}

}  // namespace mien::test
