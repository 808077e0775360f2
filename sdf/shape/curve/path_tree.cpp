#include "sdf/shape/curve/path_tree.h"
#include "lib/base/watch.h"
#include "sdf/shape/curve/path.h"

#include "path_sides_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace mien {
namespace {

constexpr int kFew = 8;         // sides that are not worth another halving
constexpr int kDeepest = 26;    // halvings: sides that meet in a joint never come apart
constexpr int kMostLists = 16;  // sides listed in all parts, for each of the path …
constexpr std::size_t kMoreLists = 144, kFirstSides = 2000;  // … and more for the first ones
constexpr int kStretches = 4;                                // of a side that bends

double cross_of(glm::dvec2 u, glm::dvec2 v) {
  return u.x * v.y - u.y * v.x;
}

QuadBezier turned(const QuadBezier& c) {
  return {{c.p0.y, c.p0.x}, {c.p1.y, c.p1.x}, {c.p2.y, c.p2.x}};
}

/// The distance from p to a box.
double distance_to(const Box2& box, glm::dvec2 p) {
  const double x = std::max({box.lo.x - p.x, p.x - box.hi.x, 0.0}),
               y = std::max({box.lo.y - p.y, p.y - box.hi.y, 0.0});
  return std::sqrt(x * x + y * y);
}

}  // namespace

PathTree::PathTree(const Path& path) : rule_(path.rule) {
  Box2 box;
  for (const Path::Loop& loop : path.loops)
    for_each_side(loop, [&](const QuadBezier& side) {
      sides_.push_back(side), turned_.push_back(turned(side));
      for (const glm::dvec2 p : {side.p0, side.p1, side.p2}) box = around(box, p);
    });
  if (sides_.empty()) return;
  const auto largest = [](glm::dvec2 v) { return std::max(std::abs(v.x), std::abs(v.y)); };
  slack_ = 1e-12 * std::max({largest(box.lo), largest(box.hi), 1e-280});
  for (const QuadBezier& side : sides_) add_stretches(side);
  first_stretch_.push_back(int(stretches_.size()));
  // A little more than all of the path, so that marks lie beside level and upright paths too.
  const double more = 0x1p-10 * largest(box.size()) + 64.0 * slack_;
  parts_.push_back({.box = grown(box, more), .count = int(sides_.size())});
  for (int i = 0; i < int(sides_.size()); ++i) listed_.push_back(i);
  set_mark(0, -1);
  const std::size_t most =
      kMostLists * sides_.size() + kMoreLists * std::min(sides_.size(), kFirstSides);
  for (int i = 0; i < int(parts_.size()) && listed_.size() < most; ++i)
    if (halve(i))
      for (const int child : {parts_[std::size_t(i)].child, parts_[std::size_t(i)].child + 1})
        set_mark(child, i);
}

std::size_t PathTree::bytes() const {
  return (sides_.capacity() + turned_.capacity()) * sizeof(QuadBezier) +
         stretches_.capacity() * sizeof(Stretch) + boxes_.capacity() * sizeof(Box2) +
         parts_.capacity() * sizeof(Part) + listed_.capacity() * sizeof(int);
}

void PathTree::add_stretches(const QuadBezier& side) {
  first_stretch_.push_back(int(stretches_.size()));
  const int count = is_straight(side) ? 1 : kStretches;
  const auto blossom = [&](double u, double v) {
    return (1.0 - u) * ((1.0 - v) * side.p0 + v * side.p1) +
           u * ((1.0 - v) * side.p1 + v * side.p2);
  };
  Box2 all;
  for (int i = 0; i < count; ++i) {
    const double s = double(i) / count, t = double(i + 1) / count;
    const QuadBezier c{blossom(s, s), blossom(s, t), blossom(t, t)};
    Box2 box;
    for (const glm::dvec2 p : {c.p0, c.p1, c.p2}) box = around(box, p);
    stretches_.push_back({grown(box, slack_), c});
  }
  for (const glm::dvec2 p : {side.p0, side.p1, side.p2}) all = around(all, p);
  boxes_.push_back(all);
}

/// Whether a side may have a point in the box: the control points of a stretch are not all beyond a side of the box,
/// nor is the box on one hand of them, seen along the chord.
bool PathTree::meets(int side, const Box2& box) const {
  const glm::dvec2 half = 0.5 * box.size() + slack_, middle = box.center();
  for (int k = first_stretch_[std::size_t(side)]; k < first_stretch_[std::size_t(side) + 1]; ++k) {
    const Stretch& s = stretches_[std::size_t(k)];
    if (s.box.lo.x > box.hi.x || s.box.hi.x < box.lo.x || s.box.lo.y > box.hi.y ||
        s.box.hi.y < box.lo.y)
      continue;
    const glm::dvec2 chord = s.curve.p2 - s.curve.p0;
    const double across = cross_of(chord, middle - s.curve.p0),
                 bend = cross_of(chord, s.curve.p1 - s.curve.p0);
    const double reach = std::abs(chord.x) * half.y + std::abs(chord.y) * half.x;
    if (across + reach >= std::min(bend, 0.0) && across - reach <= std::max(bend, 0.0)) return true;
  }
  return false;
}

/// Across its longer side, or the other one if that parts nothing.
bool PathTree::halve(int index) {
  const Part whole = parts_[std::size_t(index)];
  if (whole.count <= kFew || whole.depth >= kDeepest) return false;
  const glm::dvec2 size = whole.box.size();
  const int longer = size.x >= size.y ? 0 : 1;
  for (const int axis : {longer, 1 - longer}) {
    const double at = whole.box.center()[axis];
    if (!(at > whole.box.lo[axis] && at < whole.box.hi[axis])) continue;
    std::array<Part, 2> halves{whole, whole};
    halves[0].box.hi[axis] = halves[1].box.lo[axis] = at;
    const std::size_t begin = listed_.size();
    worked(30 * std::int64_t(whole.count));
    for (Part& half : halves) {
      half.first = int(listed_.size()), half.child = -1, ++half.depth;
      for (int k = whole.first; k < whole.first + whole.count; ++k)
        if (const int side = listed_[std::size_t(k)]; meets(side, half.box))
          listed_.push_back(side);
      half.count = int(listed_.size()) - half.first;
    }
    const bool parts = std::max(halves[0].count, halves[1].count) < whole.count ||
                       std::min(halves[0].count, halves[1].count) < whole.count / 2;
    if (!parts) {
      listed_.resize(begin);
      continue;
    }
    parts_[std::size_t(index)].child = int(parts_.size());
    parts_[std::size_t(index)].axis = axis;
    parts_.push_back(halves[0]), parts_.push_back(halves[1]);
    return true;
  }
  return false;
}

/// A place that is nobody's middle, and its winding number by the sides of the part around.
void PathTree::set_mark(int index, int outer) {
  Part& part = parts_[std::size_t(index)];
  worked(10 * std::int64_t(part.count));
  part.mark = part.box.lo + glm::dvec2{0.5358137, 0.4813579} * part.box.size();
  part.winding =
      outer < 0 ? winding_of_all(part.mark) : winding_in(parts_[std::size_t(outer)], part.mark);
  part.beyond = 0;
  for (const int side : sides_of(part))
    part.beyond += passes(turned_[std::size_t(side)], {part.mark.y, part.mark.x});
}

int PathTree::winding_of_all(glm::dvec2 p) const {
  worked(10 * std::int64_t(sides_.size()));
  int count = 0;
  for (const QuadBezier& side : sides_) count += passes(side, p);
  return count;
}

/// From the mark along y to p's height, then along x to p. If that corner lies on a side, all sides decide.
int PathTree::winding_in(const Part& part, glm::dvec2 p) const {
  const glm::dvec2 corner{part.mark.x, p.y};
  const double near = 16.0 * slack_;
  int along_x = 0, beyond = 0, passed = 0;
  for (const int i : sides_of(part)) {
    const QuadBezier& side = sides_[std::size_t(i)];
    const Box2& box = boxes_[std::size_t(i)];
    if (box.lo.y <= p.y && p.y <= box.hi.y) {
      if (box.hi.x > corner.x - near) {
        ++passed;
        const int left = passes(side, {corner.x - near, corner.y});
        if (box.lo.x <= corner.x + near && left != passes(side, {corner.x + near, corner.y}))
          return winding_of_all(p);
        along_x -= left;
      }
      if (box.hi.x > p.x) ++passed, along_x += passes(side, p);
    }
    if (box.lo.x <= corner.x && corner.x <= box.hi.x && box.hi.y > corner.y)
      ++passed, beyond += passes(turned_[std::size_t(i)], {corner.y, corner.x});
  }
  worked(20 + 2 * std::int64_t(part.count) + 12 * passed);
  // A loop that turns from +x towards +y passes x upwards where it passes y downwards.
  return part.winding + (part.beyond - beyond) + along_x;
}

int PathTree::winding(glm::dvec2 p) const {
  if (parts_.empty() || !parts_[0].box.contains(p)) return 0;
  int at = 0;
  while (parts_[std::size_t(at)].child >= 0) {
    const Part& part = parts_[std::size_t(at)];
    const double border = parts_[std::size_t(part.child)].box.hi[part.axis];
    at = part.child + (p[part.axis] > border ? 1 : 0);
  }
  return winding_in(parts_[std::size_t(at)], p);
}

bool PathTree::inside(glm::dvec2 p) const {
  return is_inside(rule_, winding(p));
}

/// Nearer halves first; parts farther than the nearest side so far are left out.
PathTree::Nearest PathTree::nearest(glm::dvec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  int nearest_side = 0;
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || parts_.empty()) return {nearest, -1};
  constexpr double kRounded = 1.0 - 1e-14;
  std::array<std::pair<double, int>, kDeepest + 2> later;
  std::size_t waiting = 0;
  later[waiting++] = {0.0, 0};
  while (waiting > 0) {
    auto [least, at] = later[--waiting];
    while (kRounded * least <= nearest) {
      const Part& part = parts_[std::size_t(at)];
      if (part.child < 0) {
        int cost = 20 + 4 * part.count;
        for (const int i : sides_of(part)) {
          if (kRounded * distance_to(boxes_[std::size_t(i)], p) > nearest) continue;
          cost += is_bent(i) ? 250 : 40;
          const double own = distance_to_side(sides_[std::size_t(i)], p);
          if (own < nearest) nearest = own, nearest_side = i;
        }
        worked(cost);
        break;
      }
      const std::size_t child = std::size_t(part.child);
      double one = distance_to(parts_[child].box, p), other = distance_to(parts_[child + 1].box, p);
      int nearer = part.child, farther = part.child + 1;
      if (other < one) std::swap(one, other), std::swap(nearer, farther);
      later[waiting++] = {std::max(other, least), farther};
      at = nearer, least = std::max(one, least);
    }
  }
  return {nearest, nearest_side};
}

double PathTree::distance(glm::dvec2 p) const {
  const Nearest found = nearest(p);
  return found.side >= 0 && inside(p) ? -found.distance : found.distance;
}

Outward PathTree::outward(glm::dvec2 p) const {
  const auto [away, index] = nearest(p);
  if (index < 0) return {away, glm::dvec2{0.0}};
  const QuadBezier& side = sides_[std::size_t(index)];
  const glm::dvec2 way =
      way_of_growth(p, away, [&](glm::dvec2 q) { return distance_to_side(side, q); });
  return inside(p) ? Outward{-away, -way} : Outward{away, way};
}

}  // namespace mien
