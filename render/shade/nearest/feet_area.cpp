// Shapes as spines.

#include "render/shade/nearest/feet_area.h"
#include <mien/parabola_side.h>
#include "lib/base/watch.h"
#include "sdf/shape/curve/band.h"
#include "sdf/shape/curve/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <variant>

namespace mien {
namespace {

// [px] Half planes and the insides of parabolas end so far away.
constexpr double kEndless = 1e6;

/// Along a parabola, from its vertex.
double endless(const ParabolaSide& side) {
  return side.bend == 0.0 ? kEndless
                          : std::min(kEndless, std::sqrt(kEndless / std::abs(side.bend)));
}

Spine spine_of(const QuadBezier& c, const double (&w)[3]) {
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

/// A curve along a line, which turns back on it, as the straight one over the same places.
QuadBezier unfolded(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  const double bend2 = glm::dot(b, b), turn = bend2 > 0.0 ? -glm::dot(a, b) / bend2 : 0.0;
  if (!(turn > 0.0 && turn < 1.0) || std::abs(a.x * b.y - a.y * b.x) > 1e-12 * bend2) return c;
  const glm::dvec2 tip = c.p0 + turn * (2.0 * a + turn * b);
  return straight(glm::distance(tip, c.p0) > glm::distance(tip, c.p2) ? c.p0 : c.p2, tip);
}

/// B' at an end; where it is 0, the way to the other end.
glm::dvec2 way_along(const Spine& s, double t) {
  const glm::dvec2 speed = along_spine(s, t);
  if (glm::length(speed) > 1e-12) return glm::normalize(speed);
  const glm::dvec2 chord = on_spine(s, 1.0) - on_spine(s, 0.0);
  return glm::length(chord) > 0.0 ? glm::normalize(chord) : glm::dvec2{1.0, 0.0};
}

glm::dvec2 outward(const Spine& s, double t) {
  const glm::dvec2 way = way_along(s, t);
  return s.side * glm::dvec2{way.y, -way.x};
}

/// Sets the outline's normal where one side goes on in the other.
void join(Spine& s, Spine& next) {
  const glm::dvec2 mean = outward(s, 1.0) + outward(next, 0.0);
  const glm::dvec2 n = glm::length(mean) > 1e-9 ? glm::normalize(mean) : outward(s, 1.0);
  s.end_x = next.begin_x = n.x, s.end_y = next.begin_y = n.y;
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
bool add_path(const Path& path, SpineList& made, Path& pieces) {
  std::vector<Spine>& to = made.spines;
  if (!is_simple_in_pieces(path, pieces)) return false;
  const Windings windings(path);
  for (const Path::Loop& loop : path.loops) {
    const std::size_t first = to.size();
    for (const QuadBezier& side : loop.sides) {
      if (side.p0 == side.p1 && side.p1 == side.p2) continue;
      Spine s = spine_of(side, {0.0, 0.0, 0.0});
      constexpr double kAside = 1e-4;  // [px]
      const glm::dvec2 way = way_along(s, 0.5), right{way.y, -way.x}, p = on_spine(s, 0.5);
      const bool in_right = is_inside(path.rule, windings.at(p + kAside * right));
      const bool in_left = is_inside(path.rule, windings.at(p - kAside * right));
      if (in_right == in_left) return false;
      s.side = in_right ? -1.0 : 1.0;
      to.push_back(s);
    }
    const std::size_t count = to.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      Spine &s = to[first + i], &next = to[first + (i + 1) % count];
      if (on_spine(s, 1.0) != on_spine(next, 0.0) &&
          glm::distance(on_spine(s, 1.0), on_spine(next, 0.0)) > 1e-6)
        return false;  // not closed
      join(s, next);
      made.next.push_back(first + (i + 1) % count);
    }
  }
  return !to.empty();
}

/// At an angle; `by` radii from the centre.
glm::dvec2 on_ellipse(const Ellipse& e, double by, double angle) {
  const glm::dvec2 u = e.axis, v{-u.y, u.x};
  return e.center + by * (e.radii.x * std::cos(angle) * u + e.radii.y * std::sin(angle) * v);
}

/// An ellipse's arc from angle a to angle b, as pieces. A piece of angle w is off by r w⁴ / 128 at most.
void add_arc(const Ellipse& e, double a, double b, std::vector<QuadBezier>& to) {
  constexpr double kOff =
      3e-4;  // [px] a hundredth of a level at most where light changes by 30 per px
  const double radius = std::max({e.radii.x, e.radii.y, 1e-9});
  const double widest = std::pow(128.0 * kOff / radius, 0.25);
  const int pieces = std::clamp(int(std::ceil((b - a) / std::min(widest, 0.8))), 1, 256);
  const auto at = [&](double by, double w) { return on_ellipse(e, by, w); };
  for (int i = 0; i < pieces; ++i) {
    const double from = a + (b - a) * i / pieces, until = a + (b - a) * (i + 1) / pieces;
    const double middle = 0.5 * (from + until);
    to.push_back({at(1.0, from), at(1.0 / std::cos(0.5 * (until - from)), middle), at(1.0, until)});
  }
}

/// A piece of a parabola's outline; its inside lies to the left.
QuadBezier piece_of(const ParabolaSide& side, double from, double to) {
  const glm::dvec2 along{side.axis.y, -side.axis.x};
  const auto blossom = [&](double u, double v) {
    return side.vertex + 0.5 * (u + v) * along + side.bend * u * v * side.axis;
  };
  return {blossom(from, from), blossom(from, to), blossom(to, to)};
}

/// The spines of each kind of shape.
struct SpinesOfShape {
  ShapeSpines& made;
  Path& pieces;
  std::vector<QuadBezier>& sides;  ///< scratch

  void add(const QuadBezier& spine, double a, double b, double c) {
    made.list.spines.push_back(spine_of(spine, {a, b, c}));
  }
  void add(const QuadBezier& spine, double width) { add(spine, width, width, width); }

  void operator()(const TaperedStroke& s) {
    add(s.spine, s.half_width[0], s.half_width[1], s.half_width[2]);
  }
  void operator()(const QuadStroke& s) { add(unfolded(s.spine), s.half_width); }
  void operator()(const Line& s) { add(straight(s.a, s.b), s.half_width); }
  void operator()(const Polyline& s) {
    for (std::size_t i = 1; i < s.points.size(); ++i)
      add(straight(s.points[i - 1], s.points[i]), s.half_width);
    if (s.points.size() == 1) add(straight(s.points[0], s.points[0]), s.half_width);
  }
  void operator()(const Disc& s) { add(straight(s.center, s.center), s.radius); }
  void operator()(const Path& s) {
    made.list.stroke = false;
    if (!add_path(s, made.list, pieces)) add_crossing(s);
  }
  /// Sides that cross have no outside of their own: any will do, since winding numbers tell signs.
  void add_crossing(const Path& s) {
    made.list.spines.clear(), made.list.next.clear();
    for (const Path::Loop& loop : s.loops) {
      const std::size_t first = made.list.spines.size();
      for (const QuadBezier& side : loop.sides) {
        if (side.p0 == side.p1 && side.p1 == side.p2) continue;
        add(side, 0.0);
        made.list.spines.back().side = 1.0;
      }
      const std::size_t count = made.list.spines.size() - first;
      for (std::size_t i = 0; i < count; ++i) {
        join(made.list.spines[first + i], made.list.spines[first + (i + 1) % count]);
        made.list.next.push_back(first + (i + 1) % count);
      }
    }
    made.tree.emplace(s);
  }
  void operator()(const Triangle& s) {
    Path path;
    path.loops.push_back({{straight(s.a, s.b), straight(s.b, s.c), straight(s.c, s.a)}});
    (*this)(path);
  }
  void operator()(const HalfPlane& s) {
    const glm::dvec2 along{-s.normal.y, s.normal.x}, foot = s.offset * s.normal;
    sides.push_back(straight(foot - kEndless * along, foot + kEndless * along));
    add_sides();
  }
  void operator()(const ParabolaSide& s) {
    sides.push_back(piece_of(s, -endless(s), endless(s)));
    add_sides();
  }
  void operator()(const Band& s) {
    // Its distance goes to the farther side: to no outline.
    made.slow = is_empty(s);
    if (made.slow) return;
    add_band_side(s.lower, s.upper, corners(s)), add_band_side(s.upper, s.lower, corners(s));
    add_sides();
  }
  /// What of a parabola lies in the other one.
  void add_band_side(const ParabolaSide& side, const ParabolaSide& other, const BandCorners& at) {
    std::array<double, 6> cuts;
    const glm::dvec2 along{side.axis.y, -side.axis.x};
    const std::size_t count = std::size_t(at.count);
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t k = i + 1;
      const double cut = glm::dot(at.point[i] - side.vertex, along);
      for (; k > 1 && cuts[k - 1] > cut; --k) cuts[k] = cuts[k - 1];
      cuts[k] = cut;
    }
    cuts[0] = -endless(side), cuts[count + 1] = endless(side);
    for (std::size_t i = 0; i <= count; ++i) {
      const double far = 1.0 + std::abs(cuts[i == 0 ? 1 : i]);
      const double middle = count == 0   ? 0.0
                            : i == 0     ? cuts[1] - far
                            : i == count ? cuts[i] + far
                                         : 0.5 * (cuts[i] + cuts[i + 1]);
      const QuadBezier at_middle = piece_of(side, middle, middle);
      if (distance(other, at_middle.p0) <= 0.0)
        sides.push_back(piece_of(side, cuts[i], cuts[i + 1]));
    }
  }
  void operator()(const CutDisc& s) {
    const double pi = glm::pi<double>();
    const double top = std::asin(std::clamp(s.upper, 0.0, 1.0)),
                 low = std::asin(std::clamp(s.lower, 0.0, 1.0));
    const Ellipse round{s.center, {s.radius, s.radius}, {s.up.y, -s.up.x}};
    add_arc(round, -low, top, sides);
    if (top < 0.5 * pi) add_chord(round, top, pi - top);
    add_arc(round, pi - top, pi + low, sides);
    if (low < 0.5 * pi) add_chord(round, pi + low, 2.0 * pi - low);
    add_sides();
  }
  void add_chord(const Ellipse& round, double from, double to) {
    sides.push_back(straight(on_ellipse(round, 1.0, from), on_ellipse(round, 1.0, to)));
  }
  void operator()(const Ellipse& s) {
    if (s.radii.x == s.radii.y) return (*this)(Disc{s.center, s.radii.x});
    add_arc(s, 0.0, 2.0 * glm::pi<double>(), sides);
    add_sides();
  }
  /// Sides with the inside to their left, in loops where one begins at the other's end.
  void add_sides() {
    constexpr double kMeets = 1e-6;  // [px]
    made.list.stroke = false;
    for (const QuadBezier& side : sides) {
      made.list.spines.push_back(spine_of(side, {0.0, 0.0, 0.0}));
      made.list.spines.back().side = 1.0;
    }
    std::vector<Spine>& all = made.list.spines;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const glm::dvec2 own = outward(all[i], 0.0), end = outward(all[i], 1.0);
      all[i].begin_x = own.x, all[i].begin_y = own.y, all[i].end_x = end.x, all[i].end_y = end.y;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::size_t next = (i + 1) % all.size();
      for (std::size_t k = 0; k < all.size(); ++k) {
        const std::size_t at = (i + 1 + k) % all.size();
        if (glm::distance(on_spine(all[at], 0.0), on_spine(all[i], 1.0)) > kMeets) continue;
        next = at;
        join(all[i], all[at]);
        break;
      }
      made.list.next.push_back(next);
    }
  }
};

void make_spines(const Shape& shape, glm::dvec2 center, ShapeSpines& made, Path& pieces,
                 std::vector<QuadBezier>& sides) {
  sides.clear();
  made.list.stroke = true, made.slow = false;
  made.tree.reset();
  made.list.spines.clear(), made.list.next.clear();
  std::visit(SpinesOfShape{made, pieces, sides}, shape);
  for (Spine& s : made.list.spines) s.x0 += center.x, s.y0 += center.y;
  made.list.before.resize(made.list.next.size());
  for (std::size_t i = 0; i < made.list.next.size(); ++i) made.list.before[made.list.next[i]] = i;
}

}  // namespace

void FeetArea::make(const AreaDistance& area, glm::dvec2 center) {
  area_ = &area, center_ = center;
  shapes_.resize(area.shapes().size());
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    worked(500);
    make_spines(area.shapes()[i], center, shapes_[i], pieces_, sides_);
  }
}

}  // namespace mien
