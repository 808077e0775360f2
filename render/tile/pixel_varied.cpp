// The part of PixelResolver for squares where colours vary: gradients, light, groups.
//
// A square is cut by its outlines and by the lines along which a paint has a kink or jump; in each
// piece the colour is smooth, so a rule that is exact for quadratics gives its mean. Where a paint
// is not described well enough by what it is at the square's corners and centre, the square is
// divided like one whose outlines aren't.

#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/pixel.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {

/// Whether the scope's paints are known well enough in the square; collects their cuts.
bool PixelResolver::describe_paints(const Scope& scope, glm::dvec2 center, double side, int depth) {
  paints_.clear();
  paint_of_layer_.clear();
  paint_cuts_.clear();
  paint_error_ = 0.0;
  bool good = true;
  for (const ScopeStack::Layer& layer : scopes_.layers(scope)) {
    paint_of_layer_.push_back(int(paints_.size()));
    if (layer.paint < 0) continue;
    const LocalPaint& local = paints_.emplace_back(sampler_.local(layer.paint, center, side));
    const double error = sampler_.error(local, scope.outline_count == 0, paint_cuts_);
    paint_error_ += error;
    // A smaller square counts for less.
    good &= error * side <= fine_.paint || depth == fine_.depth;
    good &= depth >= kCreaseDepth || !sampler_.creased(local);
  }
  return good;
}

std::optional<Mix> PixelResolver::gradient(const Scope& scope, glm::dvec2 center) {
  Mix mix{0.0};
  Mix change{0.0}, error{0.0};
  for (const ScopeStack::Layer& layer : scopes_.layers(scope)) {
    if (layer.group >= 0 || layer.count > 0) return {};
    if (layer.paint < 0) {
      mix = over(mix, layer.mix);
    } else {
      const auto mean = sampler_.mean(layer.paint, center, 1.0);
      if (!mean) return {};
      // A translucent gradient over another: the mean of a product is off by a twelfth of both changes.
      error += mean->error + change * mean->change / 12.0;
      change += mean->change;
      mix = over(mix, mean->mix);
    }
    if (mix.a >= 1.0) break;
  }
  if (!(std::max({error.r, error.g, error.b, error.a}) <= fine_.paint)) return {};
  ++stats_.varied_pixels;
  return mix.a < 1.0 ? over(mix, scope.base) : mix;
}

Mix PixelResolver::color_at(const Scope& scope, glm::dvec2 u) {
  return scopes_.color(scope, [&](int layer) {
    return paints_[std::size_t(paint_of_layer_[std::size_t(layer)])].color(u);
  });
}

/// The sum over a convex polygon: each triangle of its fan by three inner points, exact for
/// quadratics. Inner, so that a colour that jumps along a side is taken on this side of it.
Mix PixelResolver::mean_over(const Scope& scope, std::span<const glm::dvec2> p) {
  constexpr double kNear = 2.0 / 3.0, kFar = 1.0 / 6.0;
  Mix sum{0.0};
  for (std::size_t i = 2; i < p.size(); ++i) {
    const glm::dvec2 a = p[i - 1] - p[0], b = p[i] - p[0];
    const double area = 0.5 * (a.x * b.y - a.y * b.x);
    if (!(area > 0.0)) continue;
    const Mix mix = color_at(scope, kNear * p[0] + kFar * (p[i - 1] + p[i])) +
                    color_at(scope, kNear * p[i - 1] + kFar * (p[0] + p[i])) +
                    color_at(scope, kNear * p[i] + kFar * (p[0] + p[i - 1]));
    sum += (area / 3.0) * mix;
  }
  return sum;
}

Mix PixelResolver::resolve_varied(const Scope& scope, double side) {
  cuts_.clear();
  for (const Edge& e : edges_)
    cuts_.push_back({straightened(e.d / side, e.normal, e.bend * side), e.normal});
  if (cuts_.size() + paint_cuts_.size() <= Arrangement::kMaxCuts)
    cuts_.insert(cuts_.end(), paint_cuts_.begin(), paint_cuts_.end());
  if (cuts_.empty()) {  // Gauss's two points each way: exact for cubics
    set_sides(scope, 0);
    constexpr double k = 0.28867513459481287;
    Mix mix{0.0};
    for (const double y : {-k, k}) mix += color_at(scope, {-k, y}) + color_at(scope, {k, y});
    return 0.25 * mix;
  }
  Mix mix{0.0};
  const auto pieces = arrangement_.cut(cuts_);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    set_sides(scope, pieces[i].inside);
    mix += mean_over(scope, arrangement_.corners(i));
  }
  return mix;
}

Mix PixelResolver::varied_square(const Scope& scope, glm::dvec2 center, double side, int depth) {
  edges_.clear();
  locals_.clear();
  const bool described = scope.outline_count == 0 || describe(scope, center, side);
  if (depth == 0) ++stats_.varied_pixels;
  const bool few = edges_.size() <= Arrangement::kMaxCuts;
  if ((described && describe_paints(scope, center, side, depth)) || depth == fine_.depth) {
    if (!described) describe_paints(scope, center, side, depth);
    constexpr double kChord = 1.4142135623730952;  // the longest line through a unit square
    error_ += described && scope.outline_count > 0 ? std::min(side, kChord * square_error_) * side
              : described                          ? 0.0
                                                   : side * side;
    error_ += std::min(paint_error_, 1.0) * side * side;
    if (few) return resolve_varied(scope, side);
    for (const int outline : scopes_.outlines(scope))
      scopes_.set_side(outline, distance(tape_.outlines[std::size_t(outline)], center) <= 0.0
                                    ? Side::in
                                    : Side::out);
    return color_at(scope, {0.0, 0.0});
  }
  return quarters(scope, center, side, depth);
}

}  // namespace mien
