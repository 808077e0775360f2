#include "tests/support/exact/exact_truth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/exact/exact_light.h"

namespace mien::test {
namespace {

constexpr double kLineGaussPlace[3] = {0.5 - 0.38729833462074170, 0.5, 0.5 + 0.38729833462074170};
constexpr double kLineGaussWeight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

double unit_of(const Scene& scene, const View& view) {
  const glm::dvec2 size = scene.canvas().box.size();
  const double sx = view.width / size.x, sy = view.height / size.y;
  return 1 / (view.fit == Fit::meet ? std::min(sx, sy) : std::max(sx, sy));
}

/// By how much encoding magnifies a small change of v.
double magnified(double v) {
  return v <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(std::min(v, 1.0), 1 / 2.4 - 1);
}

}  // namespace

ExactTruth::ExactTruth(const Scene& scene, const View& view, double tolerance)
    : scene_(scene),
      distance_(scene),
      view_(view),
      tolerance_(tolerance),
      unit_(unit_of(scene, view)),
      paint_(scene, distance_, view, unit_) {
  for (int i = 0; i < int(scene.layers().size()); ++i) all_.push_back({i, false, true});
}

glm::dvec2 ExactTruth::face(double x, double y) const {
  const glm::dvec2 p{unit_ * (x - 0.5 * view_.width), unit_ * (y - 0.5 * view_.height)};
  return scene_.canvas().box.center() + glm::dvec2{p.x, scene_.canvas().y_up ? -p.y : p.y};
}

/// v: how far from the pixel's upper or left edge [px].
FaceLine ExactTruth::line_at(const Square& square, double v) const {
  const double x = square.corner.x, y = square.corner.y;
  const glm::dvec2 from = square.upright ? face(x + v, y) : face(x, y + v);
  const glm::dvec2 to = square.upright ? face(x + v, y + 1) : face(x + 1, y + v);
  return {from, to - from};
}

/// What of `among` is seen in a rectangle.
std::vector<ExactTruth::Seen> ExactTruth::seen_in(const PixelRect& r,
                                                  const std::vector<Seen>& among) const {
  const glm::dvec2 center = face(r.x + 0.5 * r.width, r.y + 0.5 * r.height);
  const double radius = 0.50001 * std::hypot(r.width, r.height) * unit_;
  std::vector<Seen> list;
  for (Seen seen : among) {
    const Area area = scene_.layers()[std::size_t(seen.layer)].area;
    const double d = seen.whole ? -2 * radius : distance_(area, center);
    if (d > radius) continue;
    seen.whole = d < -radius;
    if (seen.whole && paint_.hides(seen.layer)) list.clear();
    seen.varies = seen.varies && paint_.varies(seen.layer, center, radius);
    list.push_back(seen);
  }
  return list;
}

/// Blocks remember what is seen in them: most layers are far from most pixels.
ExactTruth::Square ExactTruth::square(const PixelRect& r) const {
  const int x = r.x / kBlock, y = r.y / kBlock;
  Square square{.seen = {}, .corner = {r.x, r.y}, .orders = {}};
  if (x != (r.x + r.width - 1) / kBlock || y != (r.y + r.height - 1) / kBlock) {
    square.seen = seen_in(r, all_);
    return square;
  }
  const auto [block, is_new] = blocks_.try_emplace({x, y});
  if (is_new) block->second = seen_in({kBlock * x, kBlock * y, kBlock, kBlock}, all_);
  square.seen = seen_in(r, block->second);
  return square;
}

/// Whether outlines in the pixel and edges of profiles, the nearer ones more, run rather from left to right.
bool ExactTruth::crosses_upright(const Square& square) const {
  const glm::dvec2 center = face(square.corner.x + 0.5, square.corner.y + 0.5);
  glm::dvec2 sum{0.0};
  const auto add = [&](Area area, double depth) {
    const double d = (distance_(area, center) + depth) / unit_;
    if (std::abs(d) > 0.70711) return;
    const glm::dvec2 slope = distance_slope(distance_, area, center, kSlopeStep * unit_);
    sum += (1 - std::abs(d)) * slope * slope;
  };
  for (const Seen& seen : square.seen) {
    const Layer& layer = scene_.layers()[std::size_t(seen.layer)];
    if (!seen.whole) add(layer.area, 0.0);
    if (!seen.varies || !layer.paint.relief || layer.paint.relief->area.node < 0) continue;
    for (const double depth : edges_of(*layer.paint.relief)) add(layer.paint.relief->area, depth);
  }
  return sum.y > sum.x;
}

/// What an error in linear light counts, by the darkest channel of sixteen samples.
void ExactTruth::weigh(Square& square) const {
  Mixes sum;
  for (int i = 0; i < 16; ++i) {
    const glm::dvec2 at = square.corner + glm::dvec2{(i % 4 + 0.5) / 4, (i / 4 + 0.5) / 4};
    const glm::dvec2 p = face(at.x, at.y);
    sum = sum + color(stack_at(square, p), p);
  }
  const glm::dvec4 c = sum.linear;
  if (!(c.a > 0)) return;
  constexpr double kSpare = 0.7;  // samples may see too little of what is dark
  square.weight = magnified(kSpare * std::min({c.r, c.g, c.b}) / c.a);
}

double ExactTruth::off(const Square& square, const Mixes& difference) const {
  return std::max(square.weight * largest(difference.linear), largest(difference.srgb));
}

ExactTruth::Rows ExactTruth::rows(const Square& square, double top, double bottom) const {
  Rows rows;
  for (int k = 0; k < 3; ++k) {
    const FaceLine line = line_at(square, top + kLineGaussPlace[k] * (bottom - top));
    const Spans found = spans(square, line);
    rows.sum = rows.sum + kLineGaussWeight[k] * (bottom - top) * along(square, line, found);
    rows.alike &= k == 0 || found.order == rows.order;
    rows.order = found.order;
  }
  for (const double v : {top, bottom}) {
    if (!rows.alike) break;
    const auto [known, is_new] = square.orders.try_emplace(v);
    if (is_new) known->second = spans(square, line_at(square, v)).order;
    rows.alike = known->second == rows.order;
  }
  return rows;
}

/// Halves agree by chance where things come and go between the lines: there halving goes on, in
/// quick truths until lines are so close that what comes shows on some of them.
Mixes ExactTruth::refined(const Square& square, double top, double bottom, const Rows& coarse,
                          int depth) const {
  const double middle = 0.5 * (top + bottom);
  const Rows upper = rows(square, top, middle), lower = rows(square, middle, bottom);
  const bool alike = upper.alike && lower.alike && upper.order == lower.order;
  const double change = off(square, upper.sum + lower.sum - coarse.sum);
  const bool thin = square.weight * (bottom - top) <= tolerance_;
  const bool told = alike || bottom - top < (tolerance_ > kFine ? kThinnest / 8 : 0);
  if (depth == 0 || thin || (told && change <= tolerance_ / 4)) return upper.sum + lower.sum;
  return refined(square, top, middle, upper, depth - 1) +
         refined(square, middle, bottom, lower, depth - 1);
}

Mixes ExactTruth::at(double x, double y) const {
  const Square around = square({int(std::floor(x)), int(std::floor(y)), 1, 1});
  return color(stack_at(around, face(x, y)), face(x, y));
}

bool ExactTruth::flat(const Square& square) {
  return std::ranges::all_of(square.seen, [](const Seen& s) { return s.whole && !s.varies; });
}

bool ExactTruth::flat(const PixelRect& pixels) const {
  return flat(square(pixels));
}

bool ExactTruth::lit(int x, int y) const {
  return std::ranges::any_of(square({x, y, 1, 1}).seen, [&](const Seen& seen) {
    return seen.varies && scene_.layers()[std::size_t(seen.layer)].paint.relief;
  });
}

Mixes ExactTruth::means(int x, int y) const {
  constexpr int kDepth = 16;
  Square s = square({x, y, 1, 1});
  const glm::dvec2 center = face(x + 0.5, y + 0.5);
  if (flat(s)) return color(stack_at(s, center), center);
  const bool smooth = std::ranges::all_of(s.seen, [&](const Seen& seen) {
    return seen.whole && !(seen.varies && paint_.jumps(seen.layer));
  });
  s.upright = crosses_upright(s);
  weigh(s);
  const int strips = smooth ? 2 : tolerance_ > kFine ? 8 : 24;
  Mixes sum;
  for (int i = 0; i < strips; ++i) {
    const double top = double(i) / strips, bottom = double(i + 1) / strips;
    sum = sum + refined(s, top, bottom, rows(s, top, bottom), kDepth);
  }
  return sum;
}

glm::dvec4 ExactTruth::levels(int x, int y, int top) const {
  return levels_of(means(x, y), view_.blend, top);
}

glm::dvec4 levels_of(const Mixes& mixes, Blend blend, int top) {
  const glm::dvec4& mix = mixes.in(blend);
  glm::dvec4 out{0, 0, 0, top * mix.a};
  for (int i = 0; i < 3 && mix.a > 0; ++i)
    out[i] = top * (blend == Blend::linear ? encoded(mix[i] / mix.a) : mix[i] / mix.a);
  return out;
}

}  // namespace mien::test
