#include "render/svg/fragment_loops.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>

namespace mien {
namespace {

/// Where a fragment begins or ends, seen along the loop: it `arrives` there or leaves.
struct FragmentEnd {
  double y, x;
  int fragment;
  bool arrives;
};

/// A fragment as the loop runs along it.
struct FragmentCurve {
  glm::dvec2 from;
  LoopSide side;
};

/// What is inside lies to the right of the picture where a loop runs down, for then it is on the loop's left.
bool runs_down(const Fragment& f) {
  return f.right == 1;
}

FragmentCurve curve_of(const Fragment& f, const OutlinePiece& p) {
  const double t = parameter_at(p, f.top), u = parameter_at(p, f.bottom);
  const glm::dvec2 a{p.ax, p.ay}, b{p.bx, p.by}, top{x_at(p, f.top), f.top},
      bottom{x_at(p, f.bottom), f.bottom};
  const glm::dvec2 control = glm::dvec2{p.x0, p.y0} + (t + u) * a + (t * u) * b;
  const bool straight = p.bx == 0.0 && p.by == 0.0;
  return runs_down(f) ? FragmentCurve{top, {control, bottom, straight}}
                      : FragmentCurve{bottom, {control, top, straight}};
}

/// By fragment: the one that goes on where it arrives.
std::vector<int> followers(std::span<const Fragment> fragments,
                           std::span<const FragmentCurve> curves) {
  std::vector<FragmentEnd> ends;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const FragmentCurve& c = curves[i];
    ends.push_back({c.from.y, c.from.x, int(i), false});
    ends.push_back({c.side.to.y, c.side.to.x, int(i), true});
  }
  std::sort(ends.begin(), ends.end(), [](const FragmentEnd& a, const FragmentEnd& b) {
    return std::tie(a.y, a.x, a.fragment) < std::tie(b.y, b.x, b.fragment);
  });
  std::vector<int> next(fragments.size(), -1);
  // Ends that could not pair off at their height would wait for the next one: loops close in any case.
  std::vector<FragmentEnd> waiting;
  for (const FragmentEnd& end : ends) {
    if (waiting.empty() || waiting.back().arrives == end.arrives) {
      waiting.push_back(end);
      continue;
    }
    const FragmentEnd other = waiting.back();
    waiting.pop_back();
    const auto [arriving, leaving] = end.arrives ? std::pair{end, other} : std::pair{other, end};
    next[std::size_t(arriving.fragment)] = leaving.fragment;
  }
  return next;
}

/// The side that both are parts of, if there is one. A parabola cut at t has the control points p0 + t (m − p0) and
/// p2 − (1 − t) (p2 − m), whose distances from the cut are as t to 1 − t; both give m.
std::optional<LoopSide> joined(glm::dvec2 from, const LoopSide& a, const LoopSide& b,
                               double tolerance) {
  if (a.straight != b.straight) return {};
  if (a.straight) {
    const glm::dvec2 way = b.to - from;
    const double length = glm::length(way), along = glm::dot(a.to - from, way);
    if (!(along > 0.0 && along < length * length)) return {};
    const double off = (a.to.x - from.x) * way.y - (a.to.y - from.y) * way.x;
    if (std::abs(off) > 1e-3 * tolerance * length) return {};  // many may follow each other
    return LoopSide{0.5 * (from + b.to), b.to, true};
  }
  const double before = glm::distance(a.control, a.to), after = glm::distance(a.to, b.control);
  if (!(before > 0.0 && after > 0.0)) return {};
  const double t = before / (before + after);
  const glm::dvec2 m = from + (a.control - from) / t, n = b.to + (b.control - b.to) / (1.0 - t);
  if (!(glm::distance(m, n) <= tolerance)) return {};
  if (glm::dot(a.to - a.control, b.control - a.to) <= 0.0) return {};  // it turns back: a cusp
  return LoopSide{0.5 * (m + n), b.to, false};
}

void add_side(FragmentLoop& loop, const LoopSide& side, double tolerance) {
  auto& sides = loop.sides;
  if (!sides.empty()) {
    const glm::dvec2 from = sides.size() > 1 ? sides[sides.size() - 2].to : loop.start;
    if (const auto one = joined(from, sides.back(), side, tolerance)) {
      sides.back() = *one;
      return;
    }
  }
  sides.push_back(side);
}

/// The last side and the first one, too, may be one.
void join_ends(FragmentLoop& loop, double tolerance) {
  auto& sides = loop.sides;
  if (sides.size() < 3) return;
  const glm::dvec2 from = sides[sides.size() - 2].to;
  if (const auto one = joined(from, sides.back(), sides.front(), tolerance)) {
    loop.start = one->to;
    sides.front() = *one;
    std::rotate(sides.begin(), sides.begin() + 1, sides.end());
    sides.erase(sides.end() - 2);
  }
}

}  // namespace

std::vector<FragmentLoop> fragment_loops(std::span<const Fragment> fragments,
                                         std::span<const OutlinePiece> pieces, double tolerance) {
  std::vector<FragmentCurve> curves;
  for (const Fragment& f : fragments) {
    worked(100);
    curves.push_back(curve_of(f, pieces[std::size_t(f.piece)]));
  }
  const std::vector<int> next = followers(fragments, curves);
  std::vector<char> seen(fragments.size(), 0);
  std::vector<FragmentLoop> loops;
  for (std::size_t first = 0; first < fragments.size(); ++first) {
    if (seen[first]) continue;
    FragmentLoop loop{curves[first].from, {}};
    for (int i = int(first); i >= 0 && !seen[std::size_t(i)]; i = next[std::size_t(i)]) {
      const FragmentCurve& curve = curves[std::size_t(i)];
      seen[std::size_t(i)] = 1;
      worked(100);
      const glm::dvec2 at = loop.sides.empty() ? loop.start : loop.sides.back().to;
      if (glm::distance(at, curve.from) > tolerance)
        add_side(loop, {0.5 * (at + curve.from), curve.from, true}, tolerance);
      add_side(loop, curve.side, tolerance);
    }
    const glm::dvec2 end = loop.sides.back().to;
    if (glm::distance(end, loop.start) > tolerance)
      add_side(loop, {0.5 * (end + loop.start), loop.start, true}, tolerance);
    else
      loop.sides.back().to = loop.start;
    join_ends(loop, tolerance);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace mien
