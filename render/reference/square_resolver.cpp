#include <mien/render/reference/square_resolver.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kSqrt2 = 1.4142135623730952;  // rounded up
constexpr int kDepth = 10;  // halvings of a pixel: below 1/1024 px a cell shows in no depth
constexpr std::size_t kMostLines = 8;  // across one square: more are fewer in its quarters
constexpr std::size_t kMostCorners = 4 + kMostLines;

/// Twice a polygon's area, and six times its first moments about its first corner.
struct Moments {
  double area = 0;
  glm::dvec2 first{0.0};
};

Moments moments(std::span<const glm::dvec2> corners) {
  Moments m;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const glm::dvec2 a = corners[i - 1] - corners[0], b = corners[i] - corners[0];
    const double twice = a.x * b.y - a.y * b.x;
    m.area += twice, m.first += twice * (a + b);
  }
  return m;
}

double largest(const Mix& d) {
  return std::max({std::abs(d.r), std::abs(d.g), std::abs(d.b), std::abs(d.a)});
}

}  // namespace

SquareResolver::SquareResolver(const Scene& scene, const View& view, const PaintTable& paints,
                               double tolerance)
    : scene_(scene),
      paints_(paints),
      face_from_grid_(inverse(grid_from_face(scene.canvas(), view))),
      scale_(1.0 / face_from_grid_.scale()),
      tolerance_(tolerance) {}

Resolved SquareResolver::pixel(int x, int y) {
  seen_.clear();
  for (int i = 0; i < int(paints_.layers.size()); ++i) seen_.push_back({i, Reach::part});
  varies_ = false;
  Resolved found = square({x + 0.5, y + 0.5}, 0.5, 0, kDepth);
  found.varies = varies_;
  return found;
}

double SquareResolver::distance(int layer, glm::dvec2 p) const {
  return scale_ * scene_.distance(scene_.layers()[std::size_t(layer)].area, face_from_grid_(p));
}

/// The layers of those from `first` to `last` that are seen in the square are put behind them; says
/// from where on.
std::size_t SquareResolver::look_at(glm::dvec2 center, double half, std::size_t first,
                                    std::size_t last) {
  const std::size_t begin = seen_.size();
  const double reach = kSqrt2 * half;
  for (std::size_t i = last; i-- > first;) {
    Seen seen = seen_[i];
    if (seen.reach == Reach::part) {
      const double d = distance(seen.layer, center);
      if (!(d <= reach)) continue;
      if (d < -reach) seen.reach = Reach::whole;
    }
    seen_.push_back(seen);
    const PaintedLayer& layer = paints_.layers[std::size_t(seen.layer)];
    if (seen.reach != Reach::whole || layer.group >= 0) continue;
    const double opacity = layer.varied < 0
                               ? layer.mix.a
                               : paints_.varied[std::size_t(layer.varied)].paint.least_opacity();
    if (opacity >= 1.0) break;
  }
  std::reverse(seen_.begin() + std::ptrdiff_t(begin), seen_.end());
  return begin;
}

Resolved SquareResolver::square(glm::dvec2 center, double half, std::size_t first, int depth) {
  const std::size_t begin = look_at(center, half, first, seen_.size());
  const bool cut = std::any_of(seen_.begin() + std::ptrdiff_t(begin), seen_.end(),
                               [](const Seen& s) { return s.reach == Reach::part; });
  Resolved found;
  if (!cut) {
    found = covered(center, half, begin, depth);
  } else if (depth == 0) {  // the middle decides
    found.mix = color(center, begin);
    found.bound = 1.0;
  } else if (!cuts(center, half, begin, found)) {
    found = {};
    const double h = 0.5 * half;
    for (const double dy : {-h, h})
      for (const double dx : {-h, h}) {
        const Resolved part = square(center + glm::dvec2{dx, dy}, h, begin, depth - 1);
        found.mix += 0.25 * part.mix;
        found.bound += 0.25 * part.bound;
      }
  }
  seen_.resize(begin);
  return found;
}

/// Whether a gradient may have a stop in the square at which it jumps.
bool SquareResolver::may_jump(glm::dvec2 center, double half, std::size_t first) {
  for (std::size_t i = first; i < seen_.size(); ++i) {
    const int index = paints_.layers[std::size_t(seen_[i].layer)].varied;
    if (index < 0) continue;
    const TapePaint& paint = paints_.varied[std::size_t(index)].paint;
    if (!paint.ramp || !paint.ramp->jumps()) continue;
    const PaintField& f = paint.field;
    const double d = f.kind == PaintField::Kind::distance
                         ? paints_.distances[std::size_t(f.distance)].at(center)
                         : 0.0;
    const double t = f.at(center, d), reach = f.per_pixel * kSqrt2 * half;
    constexpr int kFew = 8;
    if (!paint.ramp->kinks(t - reach, t + reach, kFew, kinks_) || !kinks_.empty()) return true;
  }
  return false;
}

/// Nothing but whole layers: Gauss's rule of four places, where the middle agrees with it.
Resolved SquareResolver::covered(glm::dvec2 center, double half, std::size_t first, int depth) {
  const bool varies =
      std::any_of(seen_.begin() + std::ptrdiff_t(first), seen_.end(),
                  [&](const Seen& s) { return paints_.layers[std::size_t(s.layer)].varied >= 0; });
  const Mix middle = color(center, first);
  if (!varies) return {middle, 0.0};
  const double g = half * 0.57735026918962576;
  Mix mean{0.0}, least = middle, most = middle;
  for (const double dy : {-g, g})
    for (const double dx : {-g, g}) {
      const Mix c = color(center + glm::dvec2{dx, dy}, first);
      mean += 0.25 * c;
      least = glm::min(least, c), most = glm::max(most, c);
    }
  // What is smooth differs little; a kink in the square moves the mean by less than an eighth of the
  // change across it. A jump may be missed by all five places: there squares are divided to the end.
  const double change = largest(most - least), bend = largest(mean - middle);
  const bool smooth = !may_jump(center, half, first);
  if (depth == 0 || (smooth && bend <= tolerance_ && change <= 24.0 * tolerance_))
    return {mean, bend};
  Resolved found;
  const double h = 0.5 * half;
  for (const double dy : {-h, h})
    for (const double dx : {-h, h}) {
      const Resolved part = covered(center + glm::dvec2{dx, dy}, h, first, depth - 1);
      found.mix += 0.25 * part.mix;
      found.bound += 0.25 * part.bound;
    }
  return found;
}

/// All outlines across the square are straight ones, and what they cut it into has one colour each.
bool SquareResolver::cuts(glm::dvec2 center, double half, std::size_t first, Resolved& to) {
  constexpr double kSmall = 1.0 / 32;  // [px] varied paints are asked once a polygon
  lines_.clear(), off_ = 0.0;
  for (std::size_t i = first; i < seen_.size(); ++i) {
    if (seen_[i].reach == Reach::part && !straight(center, half, i)) return false;
    if (paints_.layers[std::size_t(seen_[i].layer)].varied >= 0 && 2.0 * half > kSmall)
      return false;
  }
  const glm::dvec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  sum_ = Mix{0.0}, least_ = Mix{HUGE_VAL}, most_ = Mix{-HUGE_VAL};
  polygon(center, first, 0, corners);
  for (const StraightCut& line : lines_) seen_[line.seen].reach = Reach::part;
  const double side = 2.0 * half;
  to.mix = sum_ / (side * side);
  to.bound = 2.0 * off_ / side * largest(most_ - least_);
  return true;
}

/// One layer's outline: straight where the distance at the corners is what its slope at the middle
/// says.
bool SquareResolver::straight(glm::dvec2 center, double half, std::size_t which) {
  if (lines_.size() == kMostLines) return false;
  const int layer = seen_[which].layer;
  const double corners[4] = {distance(layer, center + glm::dvec2{-half, -half}),
                             distance(layer, center + glm::dvec2{half, -half}),
                             distance(layer, center + glm::dvec2{-half, half}),
                             distance(layer, center + glm::dvec2{half, half})};
  const double middle = distance(layer, center);
  const glm::dvec2 slope{(corners[1] + corners[3] - corners[0] - corners[2]) / (4.0 * half),
                         (corners[2] + corners[3] - corners[0] - corners[1]) / (4.0 * half)};
  const double mean = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const double twist = 0.25 * std::abs(corners[0] + corners[3] - corners[1] - corners[2]);
  const double length = glm::length(slope);
  const double off = std::abs(mean - middle) + twist + half * std::abs(length - 1.0);
  if (!(off <= tolerance_) || !(std::abs(length - 1.0) < 0.25)) return false;
  lines_.push_back({which, slope / length, (2.0 * middle + mean) / 3.0});
  off_ += off;
  return true;
}

/// Adds a polygon of the square, cut by the lines from `done` on.
void SquareResolver::polygon(glm::dvec2 center, std::size_t first, std::size_t done,
                             std::span<const glm::dvec2> corners) {
  const Moments m = moments(corners);
  if (!(m.area > 0.0)) return;
  if (done == lines_.size()) {
    const Mix mix = color(center + corners[0] + m.first / (3.0 * m.area), first);
    sum_ += 0.5 * m.area * mix;
    least_ = glm::min(least_, mix), most_ = glm::max(most_, mix);
    return;
  }
  const StraightCut& line = lines_[done];
  for (const double sign : {1.0, -1.0}) {
    glm::dvec2 part[kMostCorners];
    std::size_t count = 0;
    const auto depth = [&](glm::dvec2 p) {
      return sign * (line.offset + glm::dot(line.normal, p));
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 p = corners[i], q = corners[i + 1 < corners.size() ? i + 1 : 0];
      const double d = depth(p), e = depth(q);
      if (d <= 0.0) part[count++] = p;
      if ((d < 0.0 && e > 0.0) || (d > 0.0 && e < 0.0)) part[count++] = p + d / (d - e) * (q - p);
    }
    seen_[line.seen].reach = sign > 0.0 ? Reach::whole : Reach::none;
    polygon(center, first, done + 1, {part, count});
  }
}

Mix SquareResolver::paint(const PaintedLayer& layer, glm::dvec2 p) {
  if (layer.varied < 0) return layer.mix;
  varies_ = true;
  const TapePaint& paint = paints_.varied[std::size_t(layer.varied)].paint;
  Mix mix = paint.color;
  if (paint.ramp) {
    const PaintField& f = paint.field;
    const double d = f.kind == PaintField::Kind::distance
                         ? paints_.distances[std::size_t(f.distance)].at(p)
                         : 0.0;
    mix = paint.ramp->color(f.at(p, d));
  }
  if (!paint.relief) return mix;
  const TapeRelief& relief = *paint.relief;
  double d = 0.0;
  glm::dvec2 gradient{0.0};
  if (relief.distance >= 0) {
    const AreaDistance& area = paints_.distances[std::size_t(relief.distance)];
    constexpr double kStep = 1e-5;  // [px]
    d = area.at(p);
    gradient = {area.at({p.x + kStep, p.y}) - area.at({p.x - kStep, p.y}),
                area.at({p.x, p.y + kStep}) - area.at({p.x, p.y - kStep})};
    gradient /= 2.0 * kStep;
  }
  return relief.lamp.lit(mix, relief.slope(p, d, gradient), paints_.blend);
}

/// Layers bottom to top; a group is collected by itself and then laid over what was there.
Mix SquareResolver::color(glm::dvec2 p, std::size_t first) {
  levels_.assign(1, paints_.background);
  open_.clear();
  const auto close_to = [&](std::size_t depth) {
    while (open_.size() > depth) {
      const Mix mix = paints_.groups[std::size_t(open_.back())].opacity * levels_.back();
      open_.pop_back(), levels_.pop_back();
      levels_.back() = over(mix, levels_.back());
    }
  };
  for (std::size_t i = first; i < seen_.size(); ++i) {
    const Seen& seen = seen_[i];
    if (seen.reach == Reach::none) continue;
    if (seen.reach == Reach::part && !(distance(seen.layer, p) <= 0.0)) continue;
    const PaintedLayer& layer = paints_.layers[std::size_t(seen.layer)];
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
