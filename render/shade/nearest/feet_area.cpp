// Shapes as spines.

#include "lib/base/watch.h"
#include "render/shade/nearest/near_feet.h"
#include "sdf/shape/curve/path.h"
#include "sdf/shape/curve/path_tree.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
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
    if (made.slow) add_crossing(s);
  }
  /// Sides that cross have no hand; feet on them are those of lines without width.
  void add_crossing(const Path& s) {
    made.spines.clear(), made.next.clear();
    for (const Path::Loop& loop : s.loops)
      for (std::size_t i = 0; i < loop.sides.size(); ++i) {
        const glm::dvec2 end = loop.sides[i ? i - 1 : loop.sides.size() - 1].p2;
        if (end != loop.sides[i].p0) add(straight(end, loop.sides[i].p0), 0.0);
        add(loop.sides[i], 0.0);
      }
    if (made.spines.empty()) return;
    made.stroke = true, made.slow = false;
    made.tree.emplace(s);
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
  made.ellipse.reset(), made.tree.reset();
  made.spines.clear(), made.reach.clear(), made.next.clear();
  std::visit(SpinesOfShape{center, made, pieces}, shape);
  if (made.slow) made.spines.clear();
  made.crosses = std::holds_alternative<Polyline>(shape) || made.tree ||
                 (made.slow && std::holds_alternative<Path>(shape));
  for (Spine<double>& s : made.spines) {
    s.x0 += center.x, s.y0 += center.y;
    double most = 0.0;
    for (const double t : {0.0, 1.0})
      most = std::max(most, std::hypot(s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2) +
                                std::abs(s.w1 + 2.0 * t * s.w2));
    made.reach.push_back(most);
  }
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
    worked(500);
    make_spines(shape, center, shapes_[i], pieces_);
    const glm::dvec2 size = bounds(shape).size();
    fine_ = fine_ || (shapes_.size() > 1 && std::min(size.x, size.y) < kSmall);
  }
}

}  // namespace mien
