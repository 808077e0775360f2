#include "stroke_private.h"

#include "rim_private.h"
#include "sdf/outline/curve/arc_private.h"
#include "sdf/outline/curve/cross_private.h"

#include <mien/cubic_roots.h>
#include "lib/math/norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [px] Thinner than this there is no stroke.
constexpr double kThinStroke = 1e-9;
/// [px] A flatter bend is no bend, and a width that changes less towards a turn is constant: three times the
/// lattice that vertices lie on, below which rims come apart. A seventh of the finest tolerance.
constexpr double kFlatStroke = 3e-6;
/// Parameters this close are one.
constexpr double kSamePoint = 1e-12;

/// 0, where it is to be cut, 1: ascending.
struct StrokeCuts {
  int count = 1;
  std::array<double, 8> t{0.0};

  void add(double value) {
    if (value > kSamePoint && value < 1.0 - kSamePoint) t[count++] = value;
  }
  void add_roots(double a, double b, double c) {
    const Roots roots = solve_quadratic(a, b, c);
    for (int i = 0; i < roots.count; ++i) add(roots.x[i]);
  }
  void end() {
    t[count++] = 1.0;
    std::sort(t.begin(), t.begin() + count);
  }
};

/// How far |B'| is above |w'|: (|B'|² − w'²)/4.
double openness(const Pen& pen, double t) {
  const glm::dvec2 v = pen.velocity(t);
  const double speed = norm(v), rate = std::abs(pen.rate(t));
  return 0.25 * (speed - rate) * (speed + rate);
}

/// The largest w(t), t in [0, 1].
double widest_on(const Pen& pen) {
  const double top = std::clamp(-pen.wa / pen.wb, 0.0, 1.0);  // a NaN stays one
  const double ends = std::max(pen.w, pen.width(1.0));
  return pen.wb < 0.0 ? std::max(ends, pen.width(top)) : ends;
}

/// Around the disc at the pen's end from one rim to the other.
void write_cap(OutlineLoop& loop, const Pen& pen, double t, glm::dvec2 from, glm::dvec2 to) {
  const double lean = lean_at(pen, t);
  write_arc(loop, pen.center(t), pen.width(t), from, 2.0 * std::acos(t > 0.5 ? -lean : lean), to);
}

/// Where |w'| reaches |B'| both rims end in one point, except for the error of t, which a tight bend of the spine
/// magnifies. The disc there fills the gap.
void write_tip(OutlineLoop& loop, const Pen& pen, double t, double end, glm::dvec2 from,
               glm::dvec2 to) {
  const double lean = lean_at(pen, t);
  const double turn = 2.0 * std::acos(std::abs(lean));
  if (turn < 1.0)
    write_arc(loop, pen.center(t), pen.width(t), from, lean * end < 0.0 ? turn : -turn, to);
}

/// The rims from t0 to t1, where |w'| <= |B'|, with a round end at 0 and at 1.
void write_open(OutlineLoop& loop, const Pen& pen, double t0, double t1) {
  const Rim right0 = rim_at(pen, -1.0, t0), right1 = rim_at(pen, -1.0, t1);
  const Rim left0 = rim_at(pen, 1.0, t0), left1 = rim_at(pen, 1.0, t1);
  loop.begin(right0.point);
  write_rim(loop, pen, -1.0, t0, t1);
  if (t1 == 1.0 && pen.width(1.0) > kThinStroke)
    write_cap(loop, pen, 1.0, right1.normal, left1.point);
  if (t1 < 1.0) write_tip(loop, pen, t1, 1.0, right1.normal, left1.point);
  loop.line(left1.point);
  write_rim(loop, pen, 1.0, t1, t0);
  if (t0 == 0.0 && pen.w > kThinStroke) write_cap(loop, pen, 0.0, left0.normal, right0.point);
  if (t0 > 0.0) write_tip(loop, pen, t0, -1.0, left0.normal, right0.point);
  loop.close();
}

/// A part of a stroke with w >= 0, whose spine, if straight, does not turn back.
void write_part(OutlineLoop& loop, const Pen& pen) {
  const double w1 = pen.width(1.0);
  const bool open0 = openness(pen, 0.0) > 0.0, open1 = openness(pen, 1.0) > 0.0;
  // A disc at an end that contains its neighbours.
  if (!open0 && pen.w > kThinStroke && pen.rate(0.0) < 0.0) write_disc(loop, pen.p, pen.w);
  if (!open1 && w1 > kThinStroke && pen.rate(1.0) > 0.0) write_disc(loop, pen.center(1.0), w1);
  StrokeCuts cuts;
  cuts.add_roots(glm::dot(pen.b, pen.b) - pen.wb * pen.wb,
                 2.0 * (glm::dot(pen.a, pen.b) - pen.wa * pen.wb),
                 glm::dot(pen.a, pen.a) - pen.wa * pen.wa);
  cuts.end();
  for (int i = 1; i < cuts.count; ++i)
    if (openness(pen, 0.5 * (cuts.t[i - 1] + cuts.t[i])) > 0.0)
      write_open(loop, pen, cuts.t[i - 1], cuts.t[i]);
}

}  // namespace

void write_capsule(OutlineLoop& loop, glm::dvec2 c0, double r0, glm::dvec2 c1, double r1) {
  const glm::dvec2 d = c1 - c0;
  const double length = norm(d);
  if (length <= std::abs(r1 - r0) + kThinStroke)
    return r0 > r1 ? write_disc(loop, c0, r0) : write_disc(loop, c1, r1);
  write_open(loop, Pen({c0, 0.5 * (c0 + c1), c1}, r0, 0.5 * (r0 + r1), r1), 0.0, 1.0);
}

namespace {

/// Its spine, which is all but straight, made so.
Pen straightened(Pen pen) {
  const glm::dvec2 way = glm::normalize(norm(pen.a) > norm(pen.b) ? pen.a : pen.b);
  pen.a = glm::dot(pen.a, way) * way, pen.b = glm::dot(pen.b, way) * way;
  return pen;
}

}  // namespace

void write_stroke(OutlineLoop& loop, const Pen& drawn) {
  Pen pen = drawn;
  if (!(pen.widest() > kThinStroke) || loop.beyond(pen.box())) return;
  StrokeCuts cuts;
  if (std::min({pen.w, pen.w + pen.wa, pen.w + 2.0 * pen.wa + pen.wb}) < 0.0)
    cuts.add_roots(pen.wb, 2.0 * pen.wa, pen.w);
  const double size = std::max(norm(pen.a), norm(pen.b));
  if (size <= kThinStroke) return write_disc(loop, pen.p, widest_on(pen));
  const bool straight = std::abs(cross(pen.a, pen.b)) <= kFlatStroke * size;
  if (straight) pen = straightened(pen);
  double turn = straight ? -glm::dot(pen.a, pen.b) / glm::dot(pen.b, pen.b) : -1.0;
  constexpr double kNear = 1e-6;  // a spine that turns this near to its end turns at it
  const bool turns = turn > -kNear && turn < 1.0 + kNear;
  turn = std::clamp(turn, 0.0, 1.0);
  if (turns) cuts.add(turn);
  cuts.end();
  for (int i = 1; i < cuts.count; ++i) {
    const double t0 = cuts.t[i - 1], t1 = cuts.t[i];
    if (!(pen.width(0.5 * (t0 + t1)) > 0.0)) continue;
    const Pen part = pen.part(t0, t1);
    const bool rests = turns && std::min(std::abs(t0 - turn), std::abs(t1 - turn)) <= kSamePoint;
    // Towards a turn where the width rests too, spine and width are one function of t: a cone.
    if (rests && std::abs(pen.rate(turn)) <= kFlatStroke) {
      write_capsule(loop, part.p, part.w, part.center(1.0), part.width(1.0));
    } else {
      write_part(loop, part);
    }
  }
}

}  // namespace mien
