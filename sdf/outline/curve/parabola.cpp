#include "parabola_private.h"

#include "cross_private.h"

#include <mien/parabola_side.h>
#include "lib/math/quartic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// [1/px] A parabola bent more than this is a ray in any picture: 10⁹ px from its vertex it is 6·10⁻⁵ px wide.
constexpr double kMostBend = 1e18;

/// Coordinates of p in a side's frame: u along its outline, v towards its inside.
glm::dvec2 in_frame(const ParabolaSide& side, glm::dvec2 p) {
  const glm::dvec2 q = p - side.vertex;
  return {cross(side.axis, q), glm::dot(q, side.axis)};
}

/// The control point of the side's outline from u to w.
glm::dvec2 control(const ParabolaSide& side, double u, double w) {
  return side.vertex + 0.5 * (u + w) * turned(side.axis) + (side.bend * u * w) * side.axis;
}

struct ClosedSide {
  glm::dvec2 control, to;
};

/// The inside of a parabola, cut off beyond a box around the window: from `begin` along its sides.
struct Closed {
  glm::dvec2 begin;
  std::array<ClosedSide, 6> sides;
};

Closed closed(const ParabolaSide& side, const Box2& window) {
  Box2 seen;
  for (const double x : {window.lo.x, window.hi.x})
    for (const double y : {window.lo.y, window.hi.y}) seen = around(seen, in_frame(side, {x, y}));
  seen = grown(seen, 1.0 + 0.01 * (seen.size().x + seen.size().y));
  // The outline is seen between two u, and not beyond the height on which it leaves the box.
  const double height = side.bend > 0.0 ? std::max(0.0, seen.hi.y) : std::min(0.0, seen.lo.y);
  const double reach = side.bend != 0.0 ? std::sqrt(height / side.bend) : seen.size().x;
  const double u = std::clamp(-reach, seen.lo.x, seen.hi.x);
  const double w = std::clamp(reach, seen.lo.x, seen.hi.x);
  const double v_at_u = side.bend * u * u, v_at_w = side.bend * w * w;
  const double top = std::max({seen.hi.y, v_at_u, v_at_w});
  const auto at = [&](double x, double y) {
    return side.vertex + x * turned(side.axis) + y * side.axis;
  };
  // From high u to low, as all outlines here. A cup is closed upwards; a hill, and a line, goes on
  // to both sides first.
  const bool cup = side.bend > 0.0;
  const double lo = cup ? u : seen.lo.x, hi = cup ? w : seen.hi.x;
  const glm::dvec2 corners[] = {at(w, v_at_w), at(u, v_at_u),  at(lo, v_at_u), at(lo, top),
                                at(hi, top),   at(hi, v_at_w), at(w, v_at_w)};
  Closed c;
  c.begin = corners[0];
  c.sides[0] = {control(side, u, w), corners[1]};
  for (int i = 1; i < 6; ++i) c.sides[i] = {0.5 * (corners[i] + corners[i + 1]), corners[i + 1]};
  return c;
}

ParabolaSide tamed(ParabolaSide side) {
  side.bend = std::clamp(side.bend, -kMostBend, kMostBend);
  return side;
}

/// Writes the part of a closed outline that lies inside a parabola's side.
class CutWriter {
 public:
  CutWriter(CurvePen& pen, const ParabolaSide& side) : pen_(pen), side_(side) {}

  void quad(glm::dvec2 p, glm::dvec2 control, glm::dvec2 to) {
    const glm::dvec2 a = control - p, b = (to - control) - a;
    std::array<double, 6> cut{0.0};
    int count = 1;
    const QuarticRoots roots = crossings(p, a, b);
    for (int i = 0; i < roots.count; ++i)
      if (roots.x[i] > 0.0 && roots.x[i] < 1.0) cut[count++] = roots.x[i];
    cut[count] = 1.0;
    const auto at = [&](double t) { return t < 1.0 ? p + t * (2.0 * a + t * b) : to; };
    if (count > 1) met_ = true, meeting_ = at(cut[1]);
    for (int i = 0; i < count; ++i) {
      const double s = cut[i], t = cut[i + 1];
      if (inside(at(0.5 * (s + t))))
        runs_[count_++] = {at(s), p + ((s + t) * a + (s * t) * b), at(t)};
    }
  }

  void write() {
    for (int i = 0; i < count_; ++i)
      if (!runs_[i].written && enters(i)) write_from(i);
    // All inside: no run enters.
    if (count_ > 0 && !runs_[0].written) write_from(0);
    if (count_ == 0 && met_) {  // they touch: a point
      pen_.begin(meeting_);
      pen_.close();
    }
  }

 private:
  struct Run {
    glm::dvec2 from, control, to;
    bool written = false;
  };

  bool inside(glm::dvec2 p) const {
    const glm::dvec2 q = in_frame(side_, p);
    return q.y >= side_.bend * q.x * q.x;
  }
  double u(glm::dvec2 p) const { return in_frame(side_, p).x; }
  int next(int i) const { return i + 1 < count_ ? i + 1 : 0; }
  bool enters(int i) const { return runs_[i > 0 ? i - 1 : count_ - 1].to != runs_[i].from; }

  /// Follows runs, and from where a run leaves the side the side's own outline, with falling u as all outlines
  /// here, to where the next run enters.
  void write_from(int first) {
    pen_.begin(runs_[first].from);
    int i = first;
    do {
      Run& run = runs_[i];
      run.written = true;
      pen_.quad(run.control, run.to);
      i = next(i);
      if (!enters(i)) continue;
      const double here = u(run.to);
      i = entry_below(here, first);
      pen_.quad(control(side_, here, u(runs_[i].from)), runs_[i].from);
    } while (i != first && !runs_[i].written);
    pen_.close();
  }

  /// The next run that enters below `here`. If rounding hides it, the loop closes.
  int entry_below(double here, int otherwise) const {
    int best = otherwise;
    double highest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < count_; ++i) {
      const double there = u(runs_[i].from);
      if (enters(i) && there <= here && there > highest) best = i, highest = there;
    }
    return best;
  }

  /// Parameters of p + t (2a + t b) where it crosses the side's outline.
  QuarticRoots crossings(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) const {
    const glm::dvec2 c0 = in_frame(side_, p);
    const glm::dvec2 c1 = 2.0 * glm::dvec2(cross(side_.axis, a), glm::dot(a, side_.axis));
    const glm::dvec2 c2{cross(side_.axis, b), glm::dot(b, side_.axis)};
    const double k = side_.bend;
    return solve_quartic(-k * c2.x * c2.x, -2.0 * k * c1.x * c2.x,
                         c2.y - k * (c1.x * c1.x + 2.0 * c0.x * c2.x), c1.y - 2.0 * k * c0.x * c1.x,
                         c0.y - k * c0.x * c0.x);
  }

  CurvePen& pen_;
  const ParabolaSide& side_;
  int count_ = 0;
  bool met_ = false;
  glm::dvec2 meeting_{0.0};
  std::array<Run, 30> runs_;
};

}  // namespace

void write_half_plane(CurvePen& pen, const HalfPlane& side) {
  write_parabola_side(pen, {side.offset * side.normal, -side.normal, 0.0});
}

void write_parabola_side(CurvePen& pen, const ParabolaSide& side) {
  const Closed c = closed(tamed(side), pen.window());
  pen.begin(c.begin);
  for (const ClosedSide& s : c.sides) pen.quad(s.control, s.to);
  pen.close();
}

void write_band(CurvePen& pen, const Band& band) {
  const ParabolaSide upper = tamed(band.upper);
  const Closed c = closed(tamed(band.lower), pen.window());
  CutWriter cut(pen, upper);
  glm::dvec2 p = c.begin;
  for (const ClosedSide& s : c.sides) {
    cut.quad(p, s.control, s.to);
    p = s.to;
  }
  cut.write();
}

}  // namespace mien
