#include "path_meetings_private.h"

#include "lib/base/watch.h"
#include "sdf/shape/curve/path_outline.h"

#include <mien/box2.h>
#include <mien/quad_bezier_distance.h>

#include "path_sides_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Pairs of sides whose extents along x meet, and those whose boxes do, of a path and for each of its sides.
constexpr std::size_t kPairs = 1 << 22, kPairsEach = 1024;
constexpr std::size_t kMeeting = 1 << 19, kMeetingEach = 64;

/// Fourth powers of coordinates are finite, and not 0.
constexpr double kLeastTolerance = 1e-70, kMostTolerance = 1e50;

double largest_coordinate(const Path& path) {
  double most = 1e-280;
  for (const Path::Loop& loop : path.loops)
    for (const QuadBezier& side : loop.sides)
      for (const glm::dvec2 p : {side.p0, side.p1, side.p2})
        most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most;
}

Box2 box_of(const QuadBezier& side) {
  Box2 box;
  for (const glm::dvec2 p : {side.p0, side.p1, side.p2}) box = around(box, p);
  return box;
}

bool within(const Box2& box, glm::dvec2 p) {
  return p.x >= box.lo.x && p.x <= box.hi.x && p.y >= box.lo.y && p.y <= box.hi.y;
}

}  // namespace

PathMeetings::PathMeetings(const Path& path, double share)
    : tolerance_(share * largest_coordinate(path)) {
  for (const Path::Loop& loop : path.loops) {
    const std::size_t first = sides_.size();
    for_each_side(loop, [&](const QuadBezier& side) { add_side(side); });
    if (sides_.size() > first) end_loop(first);
  }
}

/// A side that does not leave its chord is straight, and two if it turns back on it.
void PathMeetings::add_side(const QuadBezier& c) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  const glm::dvec2 longest = glm::length(a) > glm::length(a + b) ? a : a + b;
  const double length = glm::length(longest);
  if (!(length > 0.0)) return;
  if (is_straight(c) || std::abs(a.x * b.y - a.y * b.x) > 0.25 * tolerance_ * length) {
    sides_.push_back(c);
    return;
  }
  const double turn = -glm::dot(a, longest) / glm::dot(b, longest);
  const glm::dvec2 fold = turn > 0.0 && turn < 1.0 ? point(c, turn) : c.p2;
  for (const auto& [from, to] : {std::pair(c.p0, fold), std::pair(fold, c.p2)})
    if (from != to) sides_.push_back(straight(from, to));
}

void PathMeetings::end_loop(std::size_t first) {
  for (std::size_t i = first; i < sides_.size(); ++i) {
    next_.push_back(i + 1 < sides_.size() ? i + 1 : first);
    begins_.push_back(place_at(sides_[i].p0));
  }
  loop_ends_.push_back(sides_.size());
}

/// The place within the tolerance of p, or p as a new one.
int PathMeetings::place_at(glm::dvec2 p) {
  constexpr double kCell = 64.0;
  const auto cell = [&](double v) { return std::int64_t(std::floor(v / (kCell * tolerance_))); };
  const auto key = [](std::int64_t x, std::int64_t y) {
    return std::uint64_t(x) * 0x9e3779b97f4a7c15ull ^ std::uint64_t(y) * 0xc2b2ae3d27d4eb4full;
  };
  for (std::int64_t x = cell(p.x - tolerance_); x <= cell(p.x + tolerance_); ++x)
    for (std::int64_t y = cell(p.y - tolerance_); y <= cell(p.y + tolerance_); ++y) {
      const auto known = cells_.find(key(x, y));
      for (int i = known == cells_.end() ? -1 : known->second; i >= 0; i = others_[std::size_t(i)])
        if (glm::distance(places_[std::size_t(i)], p) <= tolerance_) return i;
    }
  const auto [own, is_new] = cells_.try_emplace(key(cell(p.x), cell(p.y)), -1);
  others_.push_back(own->second);
  places_.push_back(p);
  return own->second = int(places_.size()) - 1;
}

void PathMeetings::cut(std::size_t side, double t, int place) {
  if (place != begin_of(side) && place != end_of(side)) cuts_.push_back({side, t, place});
}

/// Cuts a side where an end of another one lies on it.
void PathMeetings::end_on(const Extent& ending, const Extent& on, bool swapped) {
  for (const double t : {0.0, 1.0}) {
    const int place = t == 0.0 ? begin_of(ending.side) : end_of(ending.side);
    double s = 0.0;
    if (place == end_of(on.side)) s = 1.0;
    if (place != begin_of(on.side) && place != end_of(on.side)) {
      const glm::dvec2 p = places_[std::size_t(place)];
      if (!within(on.box, p)) continue;
      const NearestPoint foot = nearest(sides_[on.side], p);
      if (!(foot.distance <= tolerance_)) continue;
      cut(on.side, s = foot.t, place);
    }
    contacts_.push_back(swapped ? SideCrossing{s, t} : SideCrossing{t, s});
  }
}

/// Whether two sides lie on each other between two places in which they meet: where they touch, several may be found.
bool PathMeetings::alike_between(std::size_t i, std::size_t k, const SideCrossing& a,
                                 const SideCrossing& b) const {
  constexpr double kNear = 4.0, kShares[] = {0.37, 0.5};
  return std::all_of(std::begin(kShares), std::end(kShares), [&](double share) {
    const glm::dvec2 p = point(sides_[i], a.a + share * (b.a - a.a));
    return nearest(sides_[k], p).distance <= kNear * tolerance_;
  });
}

void PathMeetings::meet(const Extent& a, const Extent& b) {
  worked(200);
  contacts_.clear();
  end_on(a, b, false), end_on(b, a, true);
  const std::size_t i = a.side, k = b.side;
  const SideCrossings found = side_crossings(sides_[i], sides_[k], tolerance_);
  for (int n = 0; n < found.count; ++n) {
    const SideCrossing& at = found.at[std::size_t(n)];
    if (std::any_of(contacts_.begin(), contacts_.end(),
                    [&](const SideCrossing& known) { return alike_between(i, k, at, known); }))
      continue;
    contacts_.push_back(at);
    const int place = place_at(point(sides_[i], at.a));
    cut(i, at.a, place), cut(k, at.b, place);
  }
}

bool PathMeetings::find() {
  if (!(tolerance_ > kLeastTolerance && tolerance_ < kMostTolerance)) return false;
  std::vector<Extent> extents(sides_.size());
  for (std::size_t i = 0; i < sides_.size(); ++i)
    extents[i] = {grown(box_of(sides_[i]), tolerance_), i};
  std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
    return a.box.lo.x != b.box.lo.x ? a.box.lo.x < b.box.lo.x : a.side < b.side;
  });
  std::size_t pairs = kPairs + kPairsEach * sides_.size(),
              near = kMeeting + kMeetingEach * sides_.size();
  for (std::size_t i = 0; i < extents.size(); ++i)
    for (std::size_t k = i + 1; k < extents.size(); ++k) {
      const Box2 &a = extents[i].box, &b = extents[k].box;
      if (b.lo.x > a.hi.x) break;
      worked(1);
      if (pairs-- == 0) return false;
      if (b.lo.y > a.hi.y || b.hi.y < a.lo.y) continue;
      meet(extents[i], extents[k]);
      if (near-- == 0 || cuts_.size() > 2 * kMostMeetings) return false;
    }
  std::sort(cuts_.begin(), cuts_.end(), [](const SideCut& a, const SideCut& b) {
    return a.side != b.side ? a.side < b.side : a.t != b.t ? a.t < b.t : a.place < b.place;
  });
  // About what is held of each.
  holds(cuts_.size() * sizeof(SideCut) + 128 * (sides_.size() + places_.size()));
  return true;
}

}  // namespace mien
