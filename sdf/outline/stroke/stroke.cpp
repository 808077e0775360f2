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
#include <span>

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

/// The rims of pens that go on as each other, from the first's t0 to the last's t1, where |w'| <= |B'|, with a round
/// end at 0 and at 1.
void write_open(OutlineLoop& loop, std::span<const Pen> pens, double t0, double t1) {
  const Pen &first = pens.front(), &last = pens.back();
  const Rim right0 = rim_at(first, -1.0, t0), left1 = rim_at(last, 1.0, t1);
  Rim from = right0, to = from;
  loop.begin(from.point);
  for (const Pen& pen : pens) {
    if (&pen != &first) from = rim_at(pen, -1.0, 0.0), from.point = loop.at();
    write_rim(loop, pen, -1.0, from, to = rim_at(pen, -1.0, &pen == &last ? t1 : 1.0));
  }
  if (t1 == 1.0 && last.width(1.0) > kThinStroke)
    write_cap(loop, last, 1.0, to.normal, left1.point);
  if (t1 < 1.0) write_tip(loop, last, t1, 1.0, to.normal, left1.point);
  loop.line(left1.point);
  from = left1;
  for (std::size_t i = pens.size(); i-- > 0;) {
    if (i + 1 < pens.size()) from = rim_at(pens[i], 1.0, 1.0), from.point = loop.at();
    write_rim(loop, pens[i], 1.0, from, to = rim_at(pens[i], 1.0, i == 0 ? t0 : 0.0));
  }
  if (t0 == 0.0 && first.w > kThinStroke) write_cap(loop, first, 0.0, to.normal, right0.point);
  if (t0 > 0.0) write_tip(loop, first, t0, -1.0, to.normal, right0.point);
  loop.close();
}

/// Whether no width is below 0 and no disc holds its neighbours.
bool is_open(const Pen& pen) {
  const glm::dvec2 end = pen.a + pen.b;
  const double rate = pen.wa + pen.wb;
  return std::min({pen.w, pen.w + pen.wa, pen.w + 2.0 * pen.wa + pen.wb}) >= 0.0 &&
         glm::dot(pen.a, pen.a) > pen.wa * pen.wa && glm::dot(pen.a, end) > pen.wa * rate &&
         glm::dot(end, end) > rate * rate;
}

/// Whether the rims of one pen go on in those of the other.
bool goes_on(const Pen& before, const Pen& pen) {
  const auto apart = [&](double toward) {
    return norm(rim_at(before, toward, 1.0).point - rim_at(pen, toward, 0.0).point);
  };
  return is_open(pen) && norm(before.center(1.0) - pen.p) <= kFlatStroke &&
         std::max(apart(1.0), apart(-1.0)) <= kFlatStroke;
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
      write_open(loop, {&pen, 1}, cuts.t[i - 1], cuts.t[i]);
}

}  // namespace

void write_capsule(OutlineLoop& loop, glm::dvec2 c0, double r0, glm::dvec2 c1, double r1) {
  const glm::dvec2 d = c1 - c0;
  const double length = norm(d);
  if (length <= std::abs(r1 - r0) + kThinStroke)
    return r0 > r1 ? write_disc(loop, c0, r0) : write_disc(loop, c1, r1);
  const Pen pen({c0, 0.5 * (c0 + c1), c1}, r0, 0.5 * (r0 + r1), r1);
  write_open(loop, {&pen, 1}, 0.0, 1.0);
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

void StrokeRow::add(const Pen& pen) {
  const bool more = count_ > 0 && count_ < pens_.size() && is_open(pens_[0]);
  if (!more || !goes_on(pens_[count_ - 1], pen)) end();
  pens_[count_++] = pen;
}

void StrokeRow::end() {
  if (count_ == 1) write_stroke(loop_, pens_[0]);
  if (count_ > 1) write_open(loop_, {pens_.data(), count_}, 0.0, 1.0);
  count_ = 0;
}

}  // namespace mien
