#include "render/reference/square_resolver.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kSqrt2 = 1.4142135623730952;  // rounded up
constexpr double kRounding = 1e-9;             // [px] of a distance, and more
constexpr int kMostDepth = 10;                 // halvings of a pixel

/// Which layers nothing is seen through.
std::vector<char> opaque(const PaintTable& paints) {
  std::vector<char> covers;
  for (const PaintedLayer& layer : paints.layers) {
    const double opacity = layer.varied < 0
                               ? layer.mix.a
                               : paints.varied[std::size_t(layer.varied)].paint.least_opacity();
    covers.push_back(layer.group < 0 && opacity >= 1.0);
  }
  return covers;
}

/// Halvings after which a square is too small to show: a quarter of the tolerance.
int depth_for(double tolerance) {
  int depth = 1;
  while (depth < kMostDepth && std::ldexp(1.0, -2 * depth) > 0.25 * tolerance) ++depth;
  return depth;
}

}  // namespace

SquareResolver::SquareResolver(const Scene& scene, const View& view, const PaintTable& paints,
                               double tolerance)
    : scene_(scene),
      paints_(paints),
      face_from_grid_(inverse(grid_from_face(scene.canvas(), view))),
      scale_(1.0 / face_from_grid_.scale()),
      tolerance_(tolerance),
      depth_(depth_for(tolerance)),
      logic_(scene, opaque(paints)),
      near_(paints.lit.size()),
      inside_(logic_.sets().size()) {}

Resolved SquareResolver::pixel(int x, int y) {
  enter_blocks(x, y);
  corner_ = {x, y};
  table_.begin();
  varies_ = false;
  const Scope scope = scope_of(blocks_.back().scope, {x + 0.5, y + 0.5}, 0.5);
  Resolved found = square({kUnits / 2, kUnits / 2, kUnits / 2}, scope, depth_);
  logic_.leave(scope);
  found.varies = varies_;
  return found;
}

/// Narrows the layers to whole blocks first, so that few are left for each pixel.
void SquareResolver::enter_blocks(int x, int y) {
  std::size_t same = 0;
  const auto first = [](int v, int side) { return side * (v / side); };
  while (same < blocks_.size() && blocks_[same].x == first(x, kBlocks[same]) &&
         blocks_[same].y == first(y, kBlocks[same]))
    ++same;
  for (; blocks_.size() > same; blocks_.pop_back()) logic_.leave(blocks_.back().scope);
  for (; same < std::size(kBlocks); ++same) {
    const int side = kBlocks[same], left = first(x, side), top = first(y, side);
    const double half = 0.5 * side;
    const Scope& outer = same ? blocks_.back().scope : logic_.whole_picture();
    blocks_.push_back({left, top, scope_of(outer, {left + half, top + half}, half)});
  }
}

SquareResolver::Scope SquareResolver::scope_of(const Scope& outer, glm::dvec2 center, double half) {
  const double reach = kSqrt2 * half + kRounding;
  return logic_.enter(outer, [&](int set) {
    const LevelSet& s = logic_.sets()[std::size_t(set)];
    const double d = s.level > -HUGE_VAL ? distance(s.shape, center) - scale_ * s.level : HUGE_VAL;
    return d < -reach ? Reach::whole : d <= reach ? Reach::part : Reach::none;
  });
}

double SquareResolver::distance(int shape, glm::dvec2 p) {
  ++stats_.distances;
  worked(40);
  return scale_ * scene_.shape_distance(std::size_t(shape), face_from_grid_(p));
}

glm::dvec2 SquareResolver::place(int x, int y) const {
  return {corner_.x + double(x) / kUnits, corner_.y + double(y) / kUnits};
}

double SquareResolver::distance(int shape, int x, int y) {
  return table_.at(shape, x, y, [&] { return distance(shape, place(x, y)); });
}

Resolved SquareResolver::square(const Square& s, const Scope& scope, int depth) {
  ++stats_.squares;
  worked(200);
  const glm::dvec2 center = place(s.x, s.y);
  if (scope.open == 0) return covered(center, double(s.half) / kUnits, scope, depth);
  Resolved found;
  if (depth == 0) {  // the middle decides
    for (const int set : logic_.open_sets(scope)) {
      const LevelSet& level = logic_.sets()[std::size_t(set)];
      inside_[std::size_t(set)] = distance(level.shape, center) <= scale_ * level.level;
    }
    return {color(center, scope), 1.0};
  }
  if (cuts(s, scope, found)) return found;
  found = {};
  const int h = s.half / 2;
  for (const int dy : {-h, h})
    for (const int dx : {-h, h}) {
      const Square quarter{s.x + dx, s.y + dy, h};
      const Scope inner = scope_of(scope, place(quarter.x, quarter.y), double(h) / kUnits);
      const Resolved part = square(quarter, inner, depth - 1);
      logic_.leave(inner);
      found.mix += 0.25 * part.mix;
      found.bound += 0.25 * part.bound;
    }
  return found;
}

bool SquareResolver::varied(const Scope& scope) const {
  const auto live = logic_.live(scope);
  return std::any_of(live.begin(), live.end(), [&](const LiveLayer& l) {
    return paints_.layers[std::size_t(l.layer)].varied >= 0;
  });
}

/// Whether light falls in the square, or a ramp goes by a distance.
bool SquareResolver::lit(const Scope& scope) const {
  const auto live = logic_.live(scope);
  return std::any_of(live.begin(), live.end(), [&](const LiveLayer& l) {
    const int index = paints_.layers[std::size_t(l.layer)].varied;
    return index >= 0 && paints_.varied[std::size_t(index)].lit >= 0;
  });
}

/// Whether a gradient seen in the square may have a stop there, or even one at which it jumps; or a profile a kink, or a
/// highlight that places may miss.
SquareResolver::Kink SquareResolver::kink_in(glm::dvec2 center, double half, const Scope& scope) {
  Kink worst = Kink::none;
  for (const LiveLayer& live : logic_.live(scope)) {
    const int index = paints_.layers[std::size_t(live.layer)].varied;
    if (index < 0) continue;
    const VariedPaint& varied = paints_.varied[std::size_t(index)];
    const GridPaint& paint = varied.paint;
    if (varied.lit >= 0) {
      const LitSurface& surface = paints_.lit[std::size_t(varied.lit)].surface();
      const Outward at = outward(varied.lit, center);
      if (surface.highlight_hides(surface.zone_inside(at.d), center, at, kSqrt2 * half))
        return Kink::jump;
      for (const double level : surface.levels())
        if (std::abs(at.d - level) <= kSqrt2 * half) worst = Kink::stop;
    }
    if (!paint.ramp) continue;
    const PaintField& f = paint.field;
    const double d = f.kind == PaintField::Kind::distance
                         ? paints_.distances[std::size_t(f.distance)].at(center)
                         : 0.0;
    const double t = f.at(center, d), reach = f.per_pixel * kSqrt2 * half;
    constexpr int kFew = 8;
    if (paint.ramp->kinks(t - reach, t + reach, kFew, kinks_) && kinks_.empty()) continue;
    if (paint.ramp->jumps()) return Kink::jump;
    worst = Kink::stop;
  }
  return worst;
}

/// A square in which only whole layers are seen: by three rules of four places (and the middle), each exact for
/// polynomials of degree three. A straight ridge through the square parts a corner from the others, so corners must be
/// as the other places tell. Stops of gradients and kinks of profiles are known; where the colour changes little, so do
/// they. A jump of a gradient may be missed by all places, so squares with one are divided to the end. Highlights may be
/// narrow, too: light is looked at in small squares.
Resolved SquareResolver::covered(glm::dvec2 center, double half, const Scope& scope, int depth) {
  const Mix middle = color(center, scope);
  if (!varied(scope)) return {middle, 0.0};
  Mix least = middle, most = middle;
  const auto four = [&](glm::dvec2 p) {
    std::array<Mix, 4> seen;
    for (Mix& c : seen) {
      c = color(center + p, scope), p = {-p.y, p.x};
      least = glm::min(least, c), most = glm::max(most, c);
    }
    return seen;
  };
  const auto mean_of = [](const std::array<Mix, 4>& c) {
    return 0.25 * ((c[0] + c[1]) + (c[2] + c[3]));
  };
  constexpr double kGauss = 0.57735026918962576, kRing = 0.81649658092772603;
  const std::array<Mix, 4> gauss = four({kGauss * half, kGauss * half});
  const Mix mean = mean_of(gauss);
  if (depth == 0) return {mean, largest(mean - middle)};
  const Kink kink = kink_in(center, half, scope);
  if (kink != Kink::jump && !(lit(scope) && half > kLitHalf)) {
    const std::array<Mix, 4> edges = four({half, 0.0});
    double off = largest(mean - (middle + 2.0 * mean_of(edges)) / 3.0);
    if (off <= tolerance_) off = std::max(off, largest(mean - mean_of(four({kRing * half, 0.0}))));
    if (off <= tolerance_) {
      // Of the square: what a line past the nearest places cuts off, at most.
      constexpr double kCorner = 0.09;
      const std::array<Mix, 4> corners = four({half, half});
      const Mix twist = 0.75 * ((gauss[0] - gauss[1]) + (gauss[2] - gauss[3]));
      for (std::size_t i = 0; i < 4; ++i) {
        const Mix told = edges[i] + edges[(i + 1) % 4] - middle + (i % 2 ? -twist : twist);
        off = std::max(off, kCorner * largest(corners[i] - told));
      }
    }
    const double change = largest(most - least);
    if (off <= tolerance_ && (kink == Kink::none || change <= 24.0 * tolerance_))
      return {mean, std::max({tolerance_, off, kink == Kink::none ? 0.0 : 0.05 * change})};
  }
  Resolved found;
  const double h = 0.5 * half;
  for (const double dy : {-h, h})
    for (const double dx : {-h, h}) {
      const Resolved part = covered(center + glm::dvec2{dx, dy}, h, scope, depth - 1);
      found.mix += 0.25 * part.mix;
      found.bound += 0.25 * part.bound;
    }
  return found;
}

/// How far the area that a relief rises from is, by what of it decides in this pixel.
Outward SquareResolver::outward(int lit, glm::dvec2 p) {
  const LitSurface& surface = paints_.lit[std::size_t(lit)].surface();
  if (!surface.area()) return {};
  NearPixel& near = near_[std::size_t(lit)];
  if (near.nodes.empty() || near.corner != corner_) {
    constexpr double kHalf = 0.5;
    near.corner = corner_;
    surface.area()->narrow(corner_ + kHalf - surface.center(), kSqrt2 * kHalf, near.nodes);
  }
  return surface.outward(p, near.nodes);
}

Mix SquareResolver::paint(const PaintedLayer& layer, glm::dvec2 p) {
  if (layer.varied < 0) return layer.mix;
  varies_ = true;
  const VariedPaint& varied = paints_.varied[std::size_t(layer.varied)];
  if (varied.lit < 0) return varied.paint.ramp->color(varied.paint.field.at(p, 0.0));
  const LitSurface& surface = paints_.lit[std::size_t(varied.lit)].surface();
  const Outward at = outward(varied.lit, p);
  return surface.color(surface.zone_inside(at.d), p, at);
}

/// Layers bottom to top; a group is composited by itself and then mixed with what was there.
Mix SquareResolver::color(glm::dvec2 p, const Scope& scope) {
  worked(30 + 30 * scope.layers);
  levels_.assign(1, paints_.background);
  open_.clear();
  const auto close_to = [&](std::size_t depth) {
    while (open_.size() > depth) {
      const PaintedGroup& group = paints_.groups[std::size_t(open_.back())];
      const Mix mix = group.opacity * levels_.back();
      open_.pop_back(), levels_.pop_back();
      levels_.back() = blended(group.mode, mix, levels_.back());
    }
  };
  for (const LiveLayer& live : logic_.live(scope)) {
    if (!logic_.holds(live, inside_)) continue;
    const PaintedLayer& layer = paints_.layers[std::size_t(live.layer)];
    chain_.clear();
    for (int g = layer.group; g >= 0; g = paints_.groups[std::size_t(g)].parent)
      chain_.insert(chain_.begin(), g);
    std::size_t same = 0;
    while (same < open_.size() && same < chain_.size() && open_[same] == chain_[same]) ++same;
    close_to(same);
    for (; same < chain_.size(); ++same) open_.push_back(chain_[same]), levels_.emplace_back(0.0);
    levels_.back() = over(paint(layer, p), levels_.back());
  }
  close_to(0);
  return levels_.back();
}

}  // namespace mien
