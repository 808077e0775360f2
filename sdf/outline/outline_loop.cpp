#include "sdf/outline/outline_loop.h"

#include "lib/base/watch.h"
#include "sdf/outline/curve/cross_private.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [px] between the window and its border: pieces along the border are no pixel's business.
constexpr double kMargin = 2.0;
/// [px] Coordinates beyond are cut to it: snapping needs the low bits.
constexpr double kFarthest = 0x1p30;
/// Larger coordinates count as NaN: their fourth powers must stay finite.
constexpr double kLargest = 1e60;
/// Where x or y turns this close to a side's end, in its parameter, the piece is not cut: it leaves the box of its
/// ends only by the square of this.
constexpr double kNearEnd = 1e-7;
/// [px] A piece that leaves its chord by less is straight: half the grid of vertices.
constexpr double kStraight = 0x1p-21;

/// [px] A way back that leaves the way there by less encloses nothing: some units of the grid of vertices.
constexpr double kThinnest = 0x1p-19;

/// To multiples of 2⁻²⁰, for |v| < 2³¹.
double snapped(double v) {
  constexpr double kShift = 0x1.8p32;
  return (v + kShift) - kShift;
}

glm::dvec2 clamped(glm::dvec2 p, const Box2& box) {
  return {std::clamp(p.x, box.lo.x, box.hi.x), std::clamp(p.y, box.lo.y, box.hi.y)};
}

/// Parameters in (0, 1), to be sorted.
struct Cuts {
  int count = 0;
  std::array<double, 12> t;

  void add(double value, double near_end) {
    if (value > near_end && value < 1.0 - near_end) t[count++] = value;
  }
  /// Where 2 a t + b t² = height.
  void add_crossings(double a, double b, double height) {
    const double root = a * a + b * height;
    if (!(root >= 0.0)) return;
    const double q = a + std::copysign(std::sqrt(root), a);
    if (q == 0.0) return;
    add(height / q, 0.0);
    if (b != 0.0) add(-q / b, 0.0);
  }
  void sort() { std::sort(t.begin(), t.begin() + count); }
};

}  // namespace

void OutlineLoop::frame(const Box2& window, double tolerance, Outlines& to) {
  to_ = &to;
  tolerance_ = tolerance;
  backwards_ = false;
  window_ = window.empty() ? Box2{{0, 0}, {0, 0}} : grown(window, kMargin);
  for (int i = 0; i < 2; ++i) {
    window_.lo[i] = std::floor(std::clamp(window_.lo[i], -kFarthest, kFarthest));
    window_.hi[i] = std::ceil(std::clamp(window_.hi[i], -kFarthest, kFarthest));
  }
  to.left = window_.lo.x, to.right = window_.hi.x;
}

int OutlineLoop::outline(FillRule rule) {
  to_->rules.push_back(rule);
  return static_cast<int>(to_->rules.size()) - 1;
}

bool OutlineLoop::is_number(glm::dvec2 p) {
  if (!(std::abs(p.x) + std::abs(p.y) < kLargest)) bad_ = true;
  return !bad_;
}

void OutlineLoop::begin(glm::dvec2 p) {
  first_vertex_ = static_cast<int>(to_->vertices.size());
  first_piece_ = static_cast<int>(to_->pieces.size());
  bad_ = false;
  if (!is_number(p)) return;
  start_ = at_ = p;
  const glm::dvec2 q = clamped(p, window_);
  to_->vertices.push_back({snapped(q.x), snapped(q.y), -1, -1});
}

void OutlineLoop::line(glm::dvec2 to) {
  if (!is_number(to)) return;
  if (window_.contains(at_) && window_.contains(to)) {
    piece(to, to, true);
  } else if (beyond({glm::min(at_, to), glm::max(at_, to)})) {
    piece(to, clamped(to, window_), true);
  } else {
    cut(0.5 * (at_ + to), to, true);
  }
  at_ = to;
}

void OutlineLoop::quad(glm::dvec2 control, glm::dvec2 to) {
  if (!is_number(control) || !is_number(to)) return;
  const Box2 box{glm::min(glm::min(at_, to), control), glm::max(glm::max(at_, to), control)};
  if (window_.contains(box.lo) && window_.contains(box.hi)) {
    cut(control, to, false);
  } else if (beyond(box)) {
    piece(to, clamped(to, window_), true);
  } else {
    cut(control, to, true);
  }
  at_ = to;
}

/// From at_: at turns of x and y, and at the window's four lines. Between two cuts the curve stays
/// in one of the nine fields around and in the window.
void OutlineLoop::cut(glm::dvec2 control, glm::dvec2 to, bool clip) {
  const glm::dvec2 p = at_, a = control - p, c = to - control, b = c - a;
  if (!clip && a.x * c.x >= 0.0 && a.y * c.y >= 0.0) return piece(control, to, false);
  Cuts cuts;
  cuts.add(-a.x / b.x, kNearEnd);
  cuts.add(-a.y / b.y, kNearEnd);
  if (clip)
    for (const glm::dvec2 corner : {window_.lo, window_.hi})
      for (int i = 0; i < 2; ++i) cuts.add_crossings(a[i], b[i], corner[i] - p[i]);
  cuts.sort();
  double u = 0.0;
  for (int i = 0; i <= cuts.count; ++i) {
    const double w = i < cuts.count ? cuts.t[i] : 1.0, middle = 0.5 * (u + w);
    const glm::dvec2 end = i < cuts.count ? p + w * (2.0 * a + w * b) : to;
    const bool inside = !clip || window_.contains(p + middle * (2.0 * a + middle * b));
    piece(p + ((u + w) * a + (u * w) * b), clip ? clamped(end, window_) : end, !inside);
    u = w;
  }
}

/// Whether the piece that ends at `vertex` and the one from there to `to` run along one line of the border.
bool OutlineLoop::runs_along_border(int vertex, glm::dvec2 to) const {
  const OutlineVertex &a = to_->vertices[vertex - 1], &b = to_->vertices[vertex];
  return (a.x == b.x && b.x == to.x && (b.x == window_.lo.x || b.x == window_.hi.x)) ||
         (a.y == b.y && b.y == to.y && (b.y == window_.lo.y || b.y == window_.hi.y));
}

/// Whether `to` lies back along the last piece's chord, and on its line. Then the way there encloses nothing, and the end
/// of that piece may as well be `to`, if both ways are flat: paths that run to and fro without area are so no more than
/// a line.
bool OutlineLoop::runs_back(glm::dvec2 to) const {
  const OutlineVertex* const end = &to_->vertices.back();
  const glm::dvec2 way{end[0].x - end[-1].x, end[0].y - end[-1].y},
      back{to.x - end[0].x, to.y - end[0].y};
  const double longest =
      std::max(std::abs(way.x) + std::abs(way.y), std::abs(back.x) + std::abs(back.y));
  // Corners often turn back and seldom on the line: as one condition this is foreseen by the processor.
  const bool turns = way.x * back.x + way.y * back.y < 0.0,
             on_line = std::abs(cross(way, back)) <= kThinnest * longest;
  return turns & on_line;
}

/// Whether the last piece and the way by `control` to `to`, of which `runs_back` is true, leave their line by nothing.
bool OutlineLoop::are_flat(glm::dvec2 control, glm::dvec2 to, bool straight) const {
  const OutlinePiece& p = to_->pieces.back();
  const OutlineVertex &a = to_->vertices[p.top], &b = to_->vertices[p.bottom];
  const glm::dvec2 end{b.x, b.y}, way = end - glm::dvec2{a.x, a.y}, back = to - end;
  const double longest =
      std::max(std::abs(way.x) + std::abs(way.y), std::abs(back.x) + std::abs(back.y));
  return (p.turn == 0 ||
          std::abs(cross(way, glm::dvec2{p.ax, p.ay} - end)) <= kThinnest * longest) &&
         (straight || std::abs(cross(back, control - end)) <= kThinnest * glm::length(back));
}

/// Until `finish` a piece keeps its control point in (ax, ay), its vertices in the loop's order, whether it may
/// bend in `turn`, and its direction around the loop in bx.
void OutlineLoop::piece(glm::dvec2 control, glm::dvec2 to, bool straight) {
  const glm::dvec2 end{snapped(to.x), snapped(to.y)};
  const int last = static_cast<int>(to_->vertices.size()) - 1;
  OutlineVertex& from = to_->vertices[last];
  if (from.x == end.x && from.y == end.y) return;
  if (straight && last > first_vertex_ && runs_along_border(last, end)) {
    from.x = end.x, from.y = end.y;
    const OutlineVertex& before = to_->vertices[last - 1];
    if (before.x == end.x && before.y == end.y) to_->vertices.pop_back(), to_->pieces.pop_back();
    return;
  }
  if (may_run_back_ && last > first_vertex_ && runs_back(end) && are_flat(control, end, straight)) {
    to_->vertices.pop_back();
    to_->pieces.pop_back();
    return piece(to, to, true);
  }
  OutlinePiece& p = to_->pieces.emplace_back();
  p.ax = control.x, p.ay = control.y;
  p.top = last, p.bottom = last + 1;
  p.outline = static_cast<int>(to_->rules.size()) - 1;
  p.turn = straight ? 0 : 1;
  p.bx = backwards_ ? -1.0 : 1.0;
  to_->vertices.push_back({end.x, end.y, -1, -1});
}

void OutlineLoop::drop() {
  to_->vertices.resize(first_vertex_);
  to_->pieces.resize(first_piece_);
}

/// All on one line of the border: there and back.
bool OutlineLoop::encloses_nothing() const {
  Box2 box;
  for (std::size_t i = first_vertex_; i < to_->vertices.size(); ++i)
    box = around(box, {to_->vertices[i].x, to_->vertices[i].y});
  return beyond(box);
}

void OutlineLoop::close() {
  if (bad_) return drop();
  line(start_);
  const auto count = static_cast<int>(to_->pieces.size()) - first_piece_;
  worked(40 * count);
  if (count < 2 || encloses_nothing()) return drop();
  // The last vertex is the first: both are the same point, snapped.
  to_->vertices.pop_back();
  to_->pieces.back().bottom = first_vertex_;
}

void OutlineLoop::finish() {
  auto& vertices = to_->vertices;
  for (std::size_t i = 0; i < to_->pieces.size(); ++i) {
    OutlinePiece& p = to_->pieces[i];
    if (p.bx < 0.0) std::swap(p.top, p.bottom);
    OutlineVertex &from = vertices[p.top], &into = vertices[p.bottom];
    from.out = into.in = static_cast<int>(i);
    const bool down = from.y != into.y ? from.y < into.y : from.x < into.x;
    const bool may_bend = p.turn != 0;
    p.turn = down ? 1 : -1;
    if (!down) std::swap(p.top, p.bottom);
    const OutlineVertex &top = vertices[p.top], &bottom = vertices[p.bottom];
    p.x0 = top.x, p.y0 = top.y, p.x1 = bottom.x, p.y1 = bottom.y;
    const glm::dvec2 chord{p.x1 - p.x0, p.y1 - p.y0};
    const glm::dvec2 a{std::clamp(p.ax, std::min(p.x0, p.x1), std::max(p.x0, p.x1)) - p.x0,
                       std::clamp(p.ay, p.y0, p.y1) - p.y0};
    const bool bends = may_bend && std::abs(cross(chord, a)) >
                                       2.0 * kStraight * std::max(std::abs(chord.x), chord.y);
    p.ax = bends ? a.x : 0.5 * chord.x, p.ay = bends ? a.y : 0.5 * chord.y;
    p.bx = bends ? (chord.x - a.x) - a.x : 0.0, p.by = bends ? (chord.y - a.y) - a.y : 0.0;
  }
}

}  // namespace mien
