#include "render/shade/nearest/near_feet.h"
#include "lib/base/monotonic_seconds.h"
#include "sdf/csg/combine.h"
#include "sdf/shape/curve/path.h"
#include "sdf/shape/curve/path_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <type_traits>
#include <variant>

namespace mien {
namespace {

Spine<double> spine_of(const QuadBezier& c, const double (&w)[3]) {
  const glm::dvec2 a = 2.0 * (c.p1 - c.p0), b = (c.p2 - c.p1) - (c.p1 - c.p0);
  return {.x0 = c.p0.x,
          .x1 = a.x,
          .x2 = b.x,
          .y0 = c.p0.y,
          .y1 = a.y,
          .y2 = b.y,
          .w0 = w[0],
          .w1 = 2.0 * (w[1] - w[0]),
          .w2 = (w[2] - w[1]) - (w[1] - w[0]),
          .begin_x = 0.0,
          .begin_y = 0.0,
          .end_x = 0.0,
          .end_y = 0.0,
          .side = 0.0};
}

QuadBezier straight(glm::dvec2 a, glm::dvec2 b) {
  return {a, 0.5 * (a + b), b};
}

glm::dvec2 on_spine(const Spine<double>& s, double t) {
  return {s.x0 + t * (s.x1 + t * s.x2), s.y0 + t * (s.y1 + t * s.y2)};
}

/// B' at an end; where it is 0, the way to the other end.
glm::dvec2 along(const Spine<double>& s, double t) {
  const glm::dvec2 speed{s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2};
  if (glm::length(speed) > 1e-12) return glm::normalize(speed);
  const glm::dvec2 chord = on_spine(s, 1.0) - on_spine(s, 0.0);
  return glm::length(chord) > 0.0 ? glm::normalize(chord) : glm::dvec2{1.0, 0.0};
}

glm::dvec2 outward(const Spine<double>& s, double t) {
  const glm::dvec2 way = along(s, t);
  return s.side * glm::dvec2{way.y, -way.x};
}

/// Whether sides touch each other at joints only. A side's control triangle may reach far from the side, so a path
/// that fails as it is is tested again in eighths.
bool is_simple_in_pieces(const Path& path, Path& fine) {
  if (is_simple(path)) return true;
  constexpr int kPieces = 8;
  fine.rule = path.rule;
  fine.loops.resize(path.loops.size());
  for (std::size_t k = 0; k < path.loops.size(); ++k) {
    std::vector<QuadBezier>& to = fine.loops[k].sides;
    to.clear();
    for (const QuadBezier& side : path.loops[k].sides) {
      glm::dvec2 begin = side.p0;
      for (int i = 1; i <= kPieces; ++i) {
        const double s = double(i - 1) / kPieces, t = double(i) / kPieces;
        const auto blossom = [&](double u, double v) {
          const double both = u * v, one = u * (1.0 - v) + v * (1.0 - u);
          return (1.0 - u) * (1.0 - v) * side.p0 + one * side.p1 + both * side.p2;
        };
        const glm::dvec2 end = i == kPieces ? side.p2 : blossom(t, t);
        to.push_back({begin, blossom(s, t), end});
        begin = end;
      }
    }
  }
  return is_simple(fine);
}

/// Those of a path: by a tree where it has many sides.
class Windings {
 public:
  explicit Windings(const Path& path) : path_(path) {
    std::size_t sides = 0;
    for (const Path::Loop& loop : path.loops) sides += loop.sides.size();
    if (sides > 4 * PathTree::kFewSides) tree_.emplace(path);
  }
  int at(glm::dvec2 p) const { return tree_ ? tree_->winding(p) : winding(path_, p); }

 private:
  const Path& path_;
  std::optional<PathTree> tree_;
};

/// The sides of a path, each with the hand on which its outside lies; false if a side has the same on both hands.
bool add_path(const Path& path, SpineShape& made, Path& pieces) {
  std::vector<Spine<double>>& to = made.spines;
  if (!is_simple_in_pieces(path, pieces)) return false;
  const Windings windings(path);
  for (const Path::Loop& loop : path.loops) {
    const std::size_t first = to.size();
    for (const QuadBezier& side : loop.sides) {
      if (side.p0 == side.p1 && side.p1 == side.p2) continue;
      Spine<double> s = spine_of(side, {0.0, 0.0, 0.0});
      constexpr double kAside = 1e-4;  // [px]
      const glm::dvec2 way = along(s, 0.5), right{way.y, -way.x}, p = on_spine(s, 0.5);
      const bool in_right = is_inside(path.rule, windings.at(p + kAside * right));
      const bool in_left = is_inside(path.rule, windings.at(p - kAside * right));
      if (in_right == in_left) return false;
      s.side = in_right ? -1.0 : 1.0;
      to.push_back(s);
    }
    const std::size_t count = to.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      Spine<double>&s = to[first + i], &next = to[first + (i + 1) % count];
      if (on_spine(s, 1.0) != on_spine(next, 0.0) &&
          glm::distance(on_spine(s, 1.0), on_spine(next, 0.0)) > 1e-6)
        return false;  // not closed
      const glm::dvec2 mean = outward(s, 1.0) + outward(next, 0.0);
      const glm::dvec2 n = glm::length(mean) > 1e-9 ? glm::normalize(mean) : outward(s, 1.0);
      s.end_x = next.begin_x = n.x, s.end_y = next.begin_y = n.y;
      made.next.push_back(first + (i + 1) % count);
    }
  }
  return !to.empty();
}

/// The spines of each kind of shape, where it has any; else the shape is slow.
struct SpinesOfShape {
  glm::dvec2 center;
  SpineShape& made;
  Path& pieces;

  void add(const QuadBezier& spine, double a, double b, double c) {
    made.spines.push_back(spine_of(spine, {a, b, c}));
  }
  void add(const QuadBezier& spine, double width) { add(spine, width, width, width); }

  void operator()(const TaperedStroke& s) {
    add(s.spine, s.half_width[0], s.half_width[1], s.half_width[2]);
  }
  void operator()(const QuadStroke& s) { add(s.spine, s.half_width); }
  void operator()(const Line& s) { add(straight(s.a, s.b), s.half_width); }
  void operator()(const Polyline& s) {
    for (std::size_t i = 1; i < s.points.size(); ++i)
      add(straight(s.points[i - 1], s.points[i]), s.half_width);
    if (s.points.size() == 1) add(straight(s.points[0], s.points[0]), s.half_width);
    made.slow = made.spines.empty();
  }
  void operator()(const Disc& s) { add(straight(s.center, s.center), s.radius); }
  void operator()(const Path& s) {
    made.stroke = false;
    made.slow = !add_path(s, made, pieces);
  }
  void operator()(const Triangle& s) {
    Path path;
    path.loops.push_back({{straight(s.a, s.b), straight(s.b, s.c), straight(s.c, s.a)}});
    (*this)(path);
  }
  void operator()(const Ellipse& s) {
    made.ellipse = s;
    made.ellipse->center += center;
    made.slow = !(std::min(s.radii.x, s.radii.y) > 1e-3 * std::max(s.radii.x, s.radii.y));
  }
  template <class Other>
  void operator()(const Other&) {
    made.slow = true;
  }
};

void make_spines(const Shape& shape, glm::dvec2 center, SpineShape& made, Path& pieces) {
  made.stroke = true, made.slow = false;
  made.ellipse.reset();
  made.spines.clear(), made.reach.clear(), made.next.clear();
  std::visit(SpinesOfShape{center, made, pieces}, shape);
  if (made.slow) made.spines.clear();
  made.crosses =
      std::holds_alternative<Polyline>(shape) || (made.slow && std::holds_alternative<Path>(shape));
  for (Spine<double>& s : made.spines) {
    s.x0 += center.x, s.y0 += center.y;
    double most = 0.0;
    for (const double t : {0.0, 1.0})
      most = std::max(most, std::hypot(s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2) +
                                std::abs(s.w1 + 2.0 * t * s.w2));
    made.reach.push_back(most);
  }
}

double key(const Spine<double>& s, double t, glm::dvec2 p) {
  return glm::distance(on_spine(s, t), p) - (s.w0 + t * (s.w1 + t * s.w2));
}

Spine<float> seen_from(const Spine<double>& s, glm::dvec2 p) {
  return {float(s.x0 - p.x), float(s.x1),    float(s.x2),    float(s.y0 - p.y), float(s.y1),
          float(s.y2),       float(s.w0),    float(s.w1),    float(s.w2),       float(s.begin_x),
          float(s.begin_y),  float(s.end_x), float(s.end_y), float(s.side)};
}

/// Whether |p − B| − w has no second minimum in t for any p of a disc: |B'|² stays above what the bends of spine
/// and width can take away from it.
bool has_one_foot(const Spine<double>& s, double from, double to, double farthest) {
  double slowest = std::numeric_limits<double>::infinity(), w = 0.0, fastest = 0.0;
  const double dot = s.x1 * s.x2 + s.y1 * s.y2, bend2 = s.x2 * s.x2 + s.y2 * s.y2;
  const double still = bend2 > 0.0 ? std::clamp(-0.5 * dot / bend2, from, to) : from;
  for (const double t : {from, to, still}) {
    const double speed2 = std::pow(s.x1 + 2.0 * t * s.x2, 2) + std::pow(s.y1 + 2.0 * t * s.y2, 2);
    slowest = std::min(slowest, speed2), fastest = std::max(fastest, speed2);
    w = std::max(w, std::abs(s.w1 + 2.0 * t * s.w2));
  }
  const double taken = 2.0 * farthest * (std::sqrt(bend2) + std::abs(s.w2));
  return slowest - taken - w * std::sqrt(fastest) > 0.3 * slowest;
}

/// How far apart samples may lie [px]: a third of the tile's radius; where the spine turns more tightly than that,
/// close enough for both sides of the bend to be seen, but at least a tenth.
double sample_gap(const Spine<double>& s, double from, double to, double radius) {
  const double dot = s.x1 * s.x2 + s.y1 * s.y2, bend2 = s.x2 * s.x2 + s.y2 * s.y2;
  const double slowest = bend2 > 0.0 ? std::clamp(-0.5 * dot / bend2, from, to) : from;
  const double speed = std::hypot(s.x1 + 2.0 * slowest * s.x2, s.y1 + 2.0 * slowest * s.y2);
  const double turn = 2.0 * std::abs(s.x1 * s.y2 - s.y1 * s.x2);  // |B' x B''|, the same for all t
  const double tightest = speed > 0.0 ? speed * speed * speed / turn : 0.0;
  return turn == 0.0 && speed > 0.0 ? 0.3 * radius
                                    : std::clamp(tightest, 0.1 * radius, 0.3 * radius);
}

constexpr int kSteps = 32;  // in which a spine is searched for what is near
using Keys = std::array<double, kSteps + 1>;

/// The stretch of a spine that may be within `most` of the middle; none if first >= last.
struct Stretch {
  int first = kSteps, last = 0;
};
Stretch stretch_within(double most, const Keys& keys, double apart) {
  Stretch found;
  for (int i = 0; i < kSteps; ++i) {
    const double low = std::min(keys[std::size_t(i)], keys[std::size_t(i) + 1]) - 0.5 * apart;
    if (low > most) continue;
    found.first = std::min(found.first, i), found.last = std::max(found.last, i + 1);
  }
  return found;
}

/// Sets as many samples along [from, to] as the spine's bend asks for.
void place_samples(const Spine<double>& s, double reach, double from, double to, double radius,
                   NearSpine& near) {
  const double count = std::ceil((to - from) * reach / sample_gap(s, from, to, radius)) + 1.0;
  near.samples = int(std::clamp(count, 2.0, near.single ? 4.0 : double(NearSpine::kMostSamples)));
  if (reach == 0.0) near.samples = 1;
  near.first = float(from), near.step = float((to - from) / std::max(1, near.samples - 1));
  near.apart = float(0.5 * reach) * near.step;
}

}  // namespace

void FeetArea::make(const AreaDistance& area, glm::dvec2 center) {
  constexpr double kSmall = 32.0;  // [px]
  area_ = &area, center_ = center, fine_ = false;
  // A shell folds the distance at the outline, so a thin one has three ridges beside each other.
  for (const Node& n : area.nodes()) fine_ = fine_ || n.op == Op::shell;
  shapes_.resize(area.shapes().size());
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = area.shapes()[i];
    make_spines(shape, center, shapes_[i], pieces_);
    const glm::dvec2 size = bounds(shape).size();
    fine_ = fine_ || (shapes_.size() > 1 && std::min(size.x, size.y) < kSmall);
  }
}

void NearFeet::narrow(const FeetArea& area, glm::dvec2 middle, double radius) {
  area_ = &area, middle_ = middle, radius_ = radius;
  leaves_.clear(), spines_.clear();
  tangled_ = false;
  const AreaDistance& tree = *area.area();
  for (const Node& n : tree.nodes()) {
    if (n.op != Op::shape) continue;
    const SpineShape& shape = area.shapes()[std::size_t(n.a)];
    Leaf leaf{std::size_t(n.a), &shape, spines_.size(), 0};
    if (!shape.slow) narrow_shape(shape);
    leaf.count = spines_.size() - leaf.first;
    tangled_ = tangled_ || (shape.crosses && (shape.slow || leaf.count > 1));
    leaves_.push_back(leaf);
  }
}

/// Whether a path's side has its foot at one of its ends, seen from anywhere in the disc, where another side goes
/// on that is equally near.
bool NearFeet::ends_beside(const SpineShape& shape, std::size_t index) const {
  const auto leans = [&](const Spine<double>& s, double t) {
    const glm::dvec2 speed{s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2};
    return std::pair{glm::dot(on_spine(s, t) - middle_, speed), radius_ * glm::length(speed)};
  };
  const auto begins = [&](const Spine<double>& s) {
    const auto [slope, slack] = leans(s, 0.0);
    return slope > slack;
  };
  const Spine<double>& s = shape.spines[index];
  if (begins(s)) return true;
  const auto [slope, slack] = leans(s, 1.0);
  return slope < -slack && !begins(shape.spines[shape.next[index]]);
}

void NearFeet::narrow_shape(const SpineShape& shape) {
  const std::size_t begin = spines_.size();
  // First an upper bound, from a few places of every spine.
  double best = std::numeric_limits<double>::infinity();
  for (const Spine<double>& s : shape.spines)
    for (const double t : {0.0, 0.5, 1.0}) best = std::min(best, key(s, t, middle_));
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t k = 0; k < shape.spines.size(); ++k) {
      const Spine<double>& s = shape.spines[k];
      const double apart = shape.reach[k] / kSteps;
      if (key(s, 0.5, middle_) - 0.5 * shape.reach[k] > best + 2.0 * radius_) continue;
      Keys v;
      for (int i = 0; i <= kSteps; ++i) {
        v[std::size_t(i)] = key(s, double(i) / kSteps, middle_);
        best = std::min(best, v[std::size_t(i)]);
      }
      if (pass == 0) continue;
      const Stretch stretch = stretch_within(best + 2.0 * radius_, v, apart);
      if (stretch.first >= stretch.last) continue;
      NearSpine near{seen_from(s, middle_), 1, 0, 0, false, 0, 0};
      near.least = float(*std::min_element(v.begin(), v.end()) - 0.5 * apart);
      const double from = double(stretch.first) / kSteps, to = double(stretch.last) / kSteps;
      const double widest = std::max({s.w0, s.w0 + 0.5 * s.w1 + 0.25 * s.w2, s.w0 + s.w1 + s.w2});
      const double farthest = std::abs(best) + 3.0 * radius_ + std::abs(widest);
      near.single = has_one_foot(s, from, to, farthest);
      if (!shape.next.empty() && has_one_foot(s, 0.0, 1.0, farthest) && ends_beside(shape, k))
        continue;
      place_samples(s, shape.reach[k], from, to, radius_, near);
      spines_.push_back(near);
    }
  }
  std::sort(spines_.begin() + std::ptrdiff_t(begin), spines_.end(),
            [](const NearSpine& a, const NearSpine& b) { return a.least < b.least; });
}

void NearFeet::slow_at(std::size_t shape, std::span<const float> x, std::span<const float> y,
                       const Feet& out) const {
  constexpr double kStep = 1e-5, kAside = 1e-3;  // [px]
  const AreaDistance& area = *area_->area();
  const auto distance_at = [&](glm::dvec2 p) { return area.of_shape(shape, p); };
  const auto gradient = [&](glm::dvec2 p, double d) {
    const glm::dvec2 g{distance_at(p + glm::dvec2{kStep, 0.0}) - d,
                       distance_at(p + glm::dvec2{0.0, kStep}) - d};
    const double length = glm::length(g);
    return length > 0.0 ? g / length : glm::dvec2{0.0};
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const glm::dvec2 p = middle_ - area_->center() + glm::dvec2{x[i], y[i]};
    const double d = distance_at(p);
    const glm::dvec2 n = gradient(p, d), along_level{-n.y, n.x}, q = p + kAside * along_level;
    const double bend = glm::dot(gradient(q, distance_at(q)) - n, along_level) / kAside;
    out.d[i] = float(d), out.nx[i] = float(n.x), out.ny[i] = float(n.y);
    out.bend[i] = float(std::clamp(bend, -4.0, 4.0));
  }
}

void NearFeet::shape_at(const Leaf& leaf, std::span<const float> x, std::span<const float> y,
                        const Feet& out) {
  if (leaf.spines->slow) return slow_at(leaf.shape, x, y, out);
  if (const auto& e = leaf.spines->ellipse) {
    const glm::dvec2 at = e->center - middle_;
    return ellipse_feet({float(at.x), float(at.y), float(e->axis.x), float(e->axis.y),
                         float(e->radii.x), float(e->radii.y)},
                        x, y, out);
  }
  spine_feet(std::span<const NearSpine>{spines_}.subspan(leaf.first, leaf.count),
             leaf.spines->stroke, x, y, out);
}

void NearFeet::at(std::span<const float> x, std::span<const float> y, const Feet& out) {
  if (!work_) return combine_at(x, y, out);
  const double begin = monotonic_seconds();
  combine_at(x, y, out);
  work_->distances += (long long)(x.size() * leaves_.size());
  work_->seconds += monotonic_seconds() - begin;
}

void NearFeet::combine_at(std::span<const float> x, std::span<const float> y, const Feet& out) {
  const auto& nodes = area_->area()->nodes();
  if (nodes.size() == 1) return shape_at(leaves_[0], x, y, out);
  const std::size_t n = x.size();
  nodes_.resize(nodes.size() * 4 * n);
  const auto of = [&](std::size_t node) {
    float* first = nodes_.data() + node * 4 * n;
    return Feet{first, first + n, first + 2 * n, first + 3 * n};
  };
  std::size_t leaf = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node& node = nodes[k];
    const Feet to = of(k);
    if (node.op == Op::shape) {
      shape_at(leaves_[leaf++], x, y, to);
      continue;
    }
    const Feet a = of(std::size_t(node.a)), b = of(std::size_t(node.b));
    for (std::size_t i = 0; i < n; ++i) {
      const double d = combine(node.op, double(a.d[i]), double(b.d[i]), node.amount);
      const bool uses_b = (node.op == Op::unite && b.d[i] < a.d[i]) ||
                          (node.op == Op::intersect && b.d[i] > a.d[i]) ||
                          (node.op == Op::subtract && -b.d[i] > a.d[i]);
      const Feet& from = uses_b ? b : a;
      const bool turned = node.op == Op::complement || (node.op == Op::shell && a.d[i] < 0.0f) ||
                          (uses_b && node.op == Op::subtract);
      const float sign = turned ? -1.0f : 1.0f;
      to.d[i] = float(d), to.nx[i] = sign * from.nx[i], to.ny[i] = sign * from.ny[i];
      to.bend[i] = sign * from.bend[i];
    }
  }
  const Feet last = of(nodes.size() - 1);
  std::copy_n(last.d, n, out.d), std::copy_n(last.nx, n, out.nx);
  std::copy_n(last.ny, n, out.ny), std::copy_n(last.bend, n, out.bend);
}

}  // namespace mien
