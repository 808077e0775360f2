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
glm::dvec2 snapped(glm::dvec2 v) {
  constexpr double kShift = 0x1.8p32;
  return {(v.x + kShift) - kShift, (v.y + kShift) - kShift};
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
  to_->begin(rule);
  return static_cast<int>(to_->rules.size()) - 1;
}

bool OutlineLoop::is_number(glm::dvec2 p) {
  if (!(std::abs(p.x) + std::abs(p.y) < kLargest)) bad_ = true;
  return !bad_;
}

void OutlineLoop::begin(glm::dvec2 p) {
  sides_.clear();
  bad_ = false;
  if (!is_number(p)) return;
  start_ = at_ = p;
  first_ = snapped(clamped(p, window_));
}

void OutlineLoop::line(glm::dvec2 to) {
  if (!is_number(to)) return;
  if (window_.contains(at_) && window_.contains(to)) {
    side(to, to, true);
  } else if (beyond({glm::min(at_, to), glm::max(at_, to)})) {
    side(to, clamped(to, window_), true);
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
    side(to, clamped(to, window_), true);
  } else {
    cut(control, to, true);
  }
  at_ = to;
}

/// From at_: at turns of x and y, and at the window's four lines. Between two cuts the curve stays
/// in one of the nine fields around and in the window.
void OutlineLoop::cut(glm::dvec2 control, glm::dvec2 to, bool clip) {
  const glm::dvec2 p = at_, a = control - p, c = to - control, b = c - a;
  if (!clip && a.x * c.x >= 0.0 && a.y * c.y >= 0.0) return side(control, to, false);
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
    side(p + ((u + w) * a + (u * w) * b), clip ? clamped(end, window_) : end, !inside);
    u = w;
  }
}

/// Whether the last side and the one from there to `to` run along one line of the border.
bool OutlineLoop::runs_along_border(glm::dvec2 to) const {
  const glm::dvec2 a = from(sides_.size() - 1), b = sides_.back().to;
  return (a.x == b.x && b.x == to.x && (b.x == window_.lo.x || b.x == window_.hi.x)) ||
         (a.y == b.y && b.y == to.y && (b.y == window_.lo.y || b.y == window_.hi.y));
}

/// Whether `to` lies back along the last side's chord, and on its line. Then the way there encloses nothing, and the end
/// of that side may as well be `to`, if both ways are flat: paths that run to and fro without area are so no more than
/// a line.
bool OutlineLoop::runs_back(glm::dvec2 to) const {
  const glm::dvec2 end = sides_.back().to, way = end - from(sides_.size() - 1), back = to - end;
  const double longest =
      std::max(std::abs(way.x) + std::abs(way.y), std::abs(back.x) + std::abs(back.y));
  // Corners often turn back and seldom on the line: as one condition this is foreseen by the processor.
  const bool turns = way.x * back.x + way.y * back.y < 0.0,
             on_line = std::abs(cross(way, back)) <= kThinnest * longest;
  return turns & on_line;
}

/// Whether the last side and the way by `control` to `to`, of which `runs_back` is true, leave their line by nothing.
bool OutlineLoop::are_flat(glm::dvec2 control, glm::dvec2 to, bool straight) const {
  const Side& last = sides_.back();
  const glm::dvec2 end = last.to, way = end - from(sides_.size() - 1), back = to - end;
  const double longest =
      std::max(std::abs(way.x) + std::abs(way.y), std::abs(back.x) + std::abs(back.y));
  return (last.straight || std::abs(cross(way, last.control - end)) <= kThinnest * longest) &&
         (straight || std::abs(cross(back, control - end)) <= kThinnest * glm::length(back));
}

void OutlineLoop::side(glm::dvec2 control, glm::dvec2 to, bool straight) {
  const glm::dvec2 end = snapped(to);
  if (from(sides_.size()) == end) return;
  if (straight && !sides_.empty() && runs_along_border(end)) {
    sides_.back().to = end;
    if (from(sides_.size() - 1) == end) sides_.pop_back();
    return;
  }
  if (may_run_back_ && !sides_.empty() && runs_back(end) && are_flat(control, end, straight)) {
    sides_.pop_back();
    return side(to, to, true);
  }
  sides_.push_back({control, end, straight});
}

std::size_t OutlineLoop::forget_sides(std::size_t count) {
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < count; ++i) pieces += !lies_beyond(i);
  first_ = sides_[count - 1].to;
  sides_.erase(sides_.begin(), sides_.begin() + std::ptrdiff_t(count));
  return pieces;
}

/// All on one line of the border: there and back.
bool OutlineLoop::encloses_nothing() const {
  Box2 box;
  for (const Side& s : sides_) box = around(box, s.to);
  return beyond(box);
}

void OutlineLoop::close() {
  if (bad_) return sides_.clear();
  line(start_);
  worked(40 * std::int64_t(sides_.size()));
  if (sides_.size() >= 2 && !encloses_nothing()) write_chains();
}

bool OutlineLoop::runs_down(std::size_t i) const {
  const glm::dvec2 p = from(i), q = sides_[i].to;
  return p.y != q.y ? p.y < q.y : p.x < q.x;
}

/// Whether it runs along the picture's left or right side.
bool OutlineLoop::lies_beyond(std::size_t i) const {
  const glm::dvec2 p = from(i), q = sides_[i].to;
  return p.x == q.x && (p.x == window_.lo.x || p.x == window_.hi.x);
}

/// The closed loop's runs of sides that go up or down, from where the first of them begins.
void OutlineLoop::write_chains() {
  const std::size_t n = sides_.size();
  const auto follows = [&](std::size_t i, std::size_t next) {  // in one chain
    return !lies_beyond(i) && !lies_beyond(next) && runs_down(i) == runs_down(next);
  };
  std::size_t start = 0;
  while (start < n && follows((start + n - 1) % n, start)) ++start;
  int first = -1, before = -1;  // chains; −1: the loop lies beyond a side
  const auto turn = [&](int arrives, int leaves, std::size_t at) {
    const glm::dvec2 p = from(at);
    const bool down = leaves >= 0 ? runs_down(at) : !runs_down((at + n - 1) % n);
    if (arrives >= 0 && leaves >= 0)
      to_->turns.push_back({p.y, p.x, arrives, leaves, down});
    else if (arrives >= 0 || leaves >= 0)
      to_->turns.push_back({p.y, p.x, std::max(arrives, leaves), -1, down});
  };
  for (std::size_t done = 0; done < n;) {
    const std::size_t begin = (start + done) % n;
    std::size_t count = 1;
    while (done + count < n && follows((begin + count - 1) % n, (begin + count) % n)) ++count;
    const int chain = lies_beyond(begin) ? -1 : write_chain(begin, count);
    if (done == 0)
      first = chain;
    else
      turn(before, chain, begin);
    before = chain, done += count;
  }
  turn(before, first, start % n);
}

int OutlineLoop::write_chain(std::size_t first, std::size_t count) {
  const std::size_t n = sides_.size();
  const bool down = runs_down(first);
  const int begin = int(to_->pieces.size());
  for (std::size_t i = 0; i < count; ++i)
    write_piece((first + (down ? i : count - 1 - i)) % n, down);
  to_->chains.push_back({begin, int(to_->pieces.size()) - 1, int(to_->rules.size()) - 1,
                         down != backwards_ ? 1 : -1});
  return int(to_->chains.size()) - 1;
}

void OutlineLoop::write_piece(std::size_t i, bool down) {
  const Side& s = sides_[i];
  const glm::dvec2 top = down ? from(i) : s.to, bottom = down ? s.to : from(i),
                   chord = bottom - top;
  const glm::dvec2 a = glm::clamp(s.control, glm::min(top, bottom), glm::max(top, bottom)) - top;
  const bool bends = !s.straight && std::abs(cross(chord, a)) >
                                        2.0 * kStraight * std::max(std::abs(chord.x), chord.y);
  const glm::dvec2 way = bends ? a : 0.5 * chord, bend = bends ? (chord - a) - a : glm::dvec2{0.0};
  to_->pieces.push_back({top.x, top.y, way.x, way.y, bend.x, bend.y, bottom.x, bottom.y});
}

}  // namespace mien
