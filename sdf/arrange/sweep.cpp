#include "sdf/arrange/sweep.h"
#include "lib/base/watch.h"
#include "sdf/arrange/reach.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace mien {
namespace {

constexpr long kAgainFirst =
    10'000;  // comparisons repeated after forced swaps: enough for any face, and an end

constexpr double kProven = HUGE_VAL;  // such neighbours need no further proof of their order

}  // namespace

bool Sweep::later(const Event& a, const Event& b) {
  return a.y != b.y ? a.y > b.y : a.x != b.x ? a.x > b.x : a.order > b.order;
}

bool Sweep::inside(int outline, int winding) const {
  return outlines_->rules[std::size_t(outline)] == FillRule::even_odd ? winding & 1 : winding != 0;
}

void Sweep::run(const Outlines& outlines, double top, double bottom, Regions& regions,
                double order) {
  outlines_ = &outlines, regions_ = &regions, top_ = top, bottom_ = bottom, may_differ_ = order;
  fragments_.clear(), doubts_.clear(), events_.clear(), again_.clear(), pieces_.clear();
  stats_ = told_ = {}, count_ = 0, found_ = 0, told_regions_ = 0, since_held_ = since_told_ = 0;
  pieces_.reserve(outlines.pieces.size() + 1);
  for (const OutlineChain& c : outlines.chains)
    for (int i = c.first; i <= c.last; ++i)
      pieces_.push_back(sweep_piece(outlines.pieces[std::size_t(i)], c.outline, c.turn));
  again_left_ = kAgainFirst + 4 * long(pieces_.size());
  room_for(0);
  holds(bytes());
  worked(50 * std::int64_t(pieces_.size()));
  sort_vertices();
  begin_at_top();
  for (const Vertex& v : vertices_) {
    events_until(v.y, v.x);
    vertex(v);
    step();
  }
  events_until(bottom_, HUGE_VAL);
  for (int slot = 0; slot < count_; ++slot) {
    if (slot + 1 < count_) parted(slot, bottom_);
    finish(slot, bottom_);
  }
  show_left(bottom_);
  stats_.pieces = long(pieces_.size());
  const double x =
      outlines.left;  // the side itself, which what is shown left of the picture ends at
  pieces_.push_back(
      sweep_piece({x, top, 0.0, 0.5 * (bottom - top), 0.0, 0.0, x, bottom}));
  stats_.regions = regions.count();
}

/// Vertices between top and bottom, by height and then from the left.
void Sweep::sort_vertices() {
  vertices_.clear();
  const auto add = [&](const Vertex& v) {
    if (v.y > top_ && v.y < bottom_) vertices_.push_back(v);
  };
  for (const OutlineChain& c : outlines_->chains)
    for (int i = c.first + 1; i <= c.last; ++i)
      add({piece(i).y0, piece(i).x0, i - 1, i, -1});
  for (std::size_t i = 0; i < outlines_->ends.size(); ++i)
    add({outlines_->ends[i].y, outlines_->ends[i].x, -1, -1, int(i)});
  std::sort(vertices_.begin(), vertices_.end(), [](const Vertex& a, const Vertex& b) {
    return a.y != b.y       ? a.y < b.y
           : a.x != b.x     ? a.x < b.x
           : a.end != b.end ? a.end < b.end
                            : a.above < b.above;
  });
}

void Sweep::room_for(int more) {
  if (count_ + more + int(kReachSpare) <= int(active_.size())) return;
  const std::size_t size = 2 * active_.size() + std::size_t(more) + 64;
  active_.resize(size), region_.resize(size), lowest_.resize(size), highest_.resize(size);
  together_.resize(size);
}

void Sweep::put(int slot, int i) {
  const auto s = std::size_t(slot);
  SweepPiece& p = piece(i);
  active_[s] = i, lowest_[s] = p.lowest_x, highest_[s] = p.highest_x, p.slot = slot;
}

/// The order at the top from scratch: what crosses it, from left to right.
void Sweep::begin_at_top() {
  std::vector<int>& first = active_;  // sorted in its place
  windings_.assign(outlines_->rules.size(), 0);
  left_ = 0, left_from_ = top_;
  int n = 0;
  for (const SweepPiece& p : pieces_) n += p.y0 <= top_ && p.y1 > top_;
  room_for(n);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const SweepPiece& p = pieces_[i];
    if (p.y0 > top_ || p.y1 <= top_) continue;
    first[std::size_t(count_++)] = int(i);
  }
  for (const OutlineEnd& e : outlines_->ends)
    if (const OutlineChain& c = outlines_->chains[std::size_t(e.chain)];
        e.other < 0 && e.y <= top_ && e.x == outlines_->left)
      windings_[std::size_t(c.outline)] += e.begins ? -c.turn : c.turn;
  for (std::size_t i = 0; i < windings_.size(); ++i)
    if (inside(int(i), windings_[i])) left_ = regions_->across(left_, int(i));
  left_look_ = regions_->look(left_);
  std::sort(first.begin(), first.begin() + count_, [&](int i, int j) {
    const SweepPiece &a = piece(i), &b = piece(j);
    const double x = x_at(a, top_), u = x_at(b, top_);
    return x != u ? x < u : i < j;
  });
  for (int slot = 0; slot < count_; ++slot) {
    put(slot, first[std::size_t(slot)]);
    SweepPiece& p = at(slot);
    p.winding = winding_left_of(slot, p.outline);
    p.flips = inside(p.outline, p.winding) != inside(p.outline, p.winding + p.turn);
    const int left = region_left_of(slot);
    region_[std::size_t(slot)] = p.flips ? regions_->across(left, p.outline) : left;
    enter(slot, top_);
  }
  for (int slot = 0; slot < count_; ++slot) {
    meet_others(slot, top_, slot + 1);
    tell_work();
  }
}

/// Looks of a piece that the sweep meets here.
void Sweep::enter(int slot, double y) {
  SweepPiece& p = at(slot);
  p.left_look = regions_->look(region_left_of(slot));
  p.right_look = regions_->look(region_[std::size_t(slot)]);
  p.shown_from = y;
  together_[std::size_t(slot)] = y;
}

/// The looks may change here: what was shown so far becomes a fragment.
void Sweep::show(int slot, double y) {
  SweepPiece& p = at(slot);
  const int left = regions_->look(region_left_of(slot)),
            right = regions_->look(region_[std::size_t(slot)]);
  if (left == p.left_look && right == p.right_look) return;
  finish(slot, y);
  p.left_look = left, p.right_look = right;
}

void Sweep::finish(int slot, double y) {
  SweepPiece& p = at(slot);
  if (p.left_look != p.right_look && y > p.shown_from)
    fragments_.push_back({active_[std::size_t(slot)], p.left_look, p.right_look, p.shown_from, y});
  p.shown_from = y;
}

void Sweep::vertex(const Vertex& v) {
  if (v.end < 0)
    go_on(v.above, v.below, v.y);
  else
    end_or_begin(outlines_->ends[std::size_t(v.end)]);
}

int Sweep::winding_left_of(int slot, int outline) {
  while (slot-- > 0)
    if (const SweepPiece& f = at(slot); f.outline == outline) return f.winding + f.turn;
  return windings_[std::size_t(outline)];
}

void Sweep::open_slots(int slot, int more) {
  room_for(more);
  for (int i = count_ - 1; i >= slot; --i) {
    put(i + more, active_[std::size_t(i)]);
    region_[std::size_t(i + more)] = region_[std::size_t(i)];
    together_[std::size_t(i + more)] = together_[std::size_t(i)];
  }
  count_ += more;
}

void Sweep::close_slots(int slot, int fewer) {
  for (int i = slot + fewer; i < count_; ++i) {
    put(i - fewer, active_[std::size_t(i)]);
    region_[std::size_t(i - fewer)] = region_[std::size_t(i)];
    together_[std::size_t(i - fewer)] = together_[std::size_t(i)];
  }
  count_ -= fewer;
}

void Sweep::go_on(int old, int now, double y) {
  SweepPiece &o = piece(old), &n = piece(now);
  const int slot = o.slot;
  if (slot > 0) parted(slot - 1, y);
  if (slot + 1 < count_) parted(slot, y);
  finish(slot, y);
  n.left_look = o.left_look, n.right_look = o.right_look, n.shown_from = y;
  n.winding = o.winding, n.flips = o.flips;
  o.slot = -1;
  put(slot, now);
  meet_others(slot, y, 0);
}

void Sweep::start(int a, int b, const OutlineEnd& v) {
  int slot = 0;
  for (int end = count_; slot < end;) {
    const int middle = (slot + end) / 2;
    if (x_at(at(middle), v.y) < v.x)
      slot = middle + 1;
    else
      end = middle;
  }
  // Which is left? Their directions decide, or their places a little farther down.
  const SweepPiece &p = piece(a), &q = piece(b);
  double side = p.ax * q.ay - q.ax * p.ay;
  if (std::abs(side) <= 1e-12 * (std::abs(p.ax) + p.ay) * (std::abs(q.ax) + q.ay)) {
    const double y = std::min(p.y1, q.y1), m = 0.5 * (v.y + y);
    side = x_at(p, m) - x_at(q, m);
    if (side == 0.0) side = x_at(p, y) - x_at(q, y);
  }
  const int left = side < 0.0 ? a : b, right = side < 0.0 ? b : a;
  if (slot > 0 && slot < count_) parted(slot - 1, v.y);
  open_slots(slot, 2);
  put(slot, left);
  put(slot + 1, right);
  SweepPiece &l = piece(left), &r = piece(right);
  const int winding = winding_left_of(slot, l.outline);
  l.winding = winding;
  r.winding = winding + l.turn;
  l.flips = r.flips = inside(l.outline, winding) != inside(l.outline, winding + l.turn);
  const int around = region_left_of(slot);
  region_[std::size_t(slot)] = l.flips ? regions_->across(around, l.outline) : around;
  region_[std::size_t(slot) + 1] = around;
  enter(slot, v.y);
  enter(slot + 1, v.y);
  if (slot > 0) together_[std::size_t(slot) - 1] = v.y;
  meet_others(slot, v.y, 0);
  meet_others(slot + 1, v.y, 0, slot);
}

void Sweep::end(int a, int b, const OutlineEnd& v) {
  int slot = std::min(piece(a).slot, piece(b).slot), last = std::max(piece(a).slot, piece(b).slot);
  for (; last > slot + 1; --last) {  // whatever is between them still is out of order
    ++stats_.forced;
    swap(last - 1, v.y);
  }
  for (int i = std::max(slot - 1, 0); i <= slot + 1 && i + 1 < count_; ++i) parted(i, v.y);
  finish(slot, v.y);
  finish(slot + 1, v.y);
  piece(a).slot = piece(b).slot = -1;
  close_slots(slot, 2);
  if (slot > 0 && slot < count_) together_[std::size_t(slot) - 1] = v.y;
}

void Sweep::swap(int slot, double y, bool one_way) {
  const auto s = std::size_t(slot);
  const int a = active_[s], b = active_[s + 1];
  if (one_way) together_[s] = kProven;
  for (int i = std::max(slot - 1, 0); i <= slot + 1 && i + 1 < count_; ++i) parted(i, y);
  SweepPiece &p = piece(a), &q = piece(b);
  if (p.outline == q.outline) {
    q.winding = p.winding;
    p.winding = q.winding + q.turn;
    q.flips = inside(q.outline, q.winding) != inside(q.outline, q.winding + q.turn);
    p.flips = inside(p.outline, p.winding) != inside(p.outline, p.winding + p.turn);
  }
  const int left = region_left_of(slot);
  region_[s] = q.flips ? regions_->across(left, q.outline) : left;
  if (one_way) together_[s] = kProven;
  put(slot, b);
  put(slot + 1, a);
  show(slot, y);
  show(slot + 1, y);
}

void Sweep::events_until(double y, double x) {
  while (!events_.empty() && !before(x, y, events_.front().x, events_.front().y)) {
    const Event event = events_.front();
    std::pop_heap(events_.begin(), events_.end(), later);
    events_.pop_back();
    const int from = piece(event.left).slot, to = piece(event.right).slot;
    if (from >= 0 && to >= 0 && from < to) swap_past(event, from, to);
    step();
  }
}

/// Swaps with everything between as well: those events fall at this height too, or were missed.
void Sweep::swap_past(const Event& event, int from, int to) {
  if (to == from + 1) return swap(from, event.y, event.one_way);
  for (int slot = from; slot < to; ++slot) swap(slot, event.y);
  stats_.forced += to - from - 1;
  for (int slot = from; slot < to - 1; ++slot)
    again_.emplace_back(event.left, active_[std::size_t(slot)]);
  for (; !again_.empty(); again_.pop_back()) {
    const auto [a, b] = again_.back();
    if (again_left_-- > 0) compare(a, b, event.y);
  }
}

void Sweep::schedule(double y, int left, int right, bool one_way) {
  const SweepPiece &a = piece(left), &b = piece(right);
  const double there = x_at(a, y), here = x_at(b, y);
  double x = a.y1 - a.y0 > b.y1 - b.y0 ? there : here;  // the steeper one gives it more exactly
  if (y >= a.y1) x = std::min(x, a.x1);                 // before either ends
  if (y >= b.y1) x = std::min(x, b.x1);
  one_way = one_way && std::abs(there - here) <= may_differ_;
  events_.push_back({y, x, left, right, found_++, one_way});
  std::push_heap(events_.begin(), events_.end(), later);
  ++stats_.crossings;
}

void Sweep::compare(int a, int b, double y) {
  if (piece(a).slot < piece(b).slot)
    meet(a, b, y);
  else
    meet(b, a, y);
}

void Sweep::meet(int left, int right, double y) {
  ++stats_.pairs;
  const SweepPiece &a = piece(left), &b = piece(right);
  if (chord_gap(a, b, y, std::min(a.y1, b.y1)) > 0.0) return;
  const Crossings found = crossings(a, b, y);
  for (int i = 0; i < found.count; ++i, std::swap(left, right))
    schedule(found.at[std::size_t(i)], left, right, found.one_way);
}

/// Compares the piece at a slot with all others from `first_slot` on whose reach along x meets its own, except the
/// one at `met`.
void Sweep::meet_others(int slot, double y, int first_slot, int met) {
  const int own = active_[std::size_t(slot)];
  const std::size_t first = std::size_t(first_slot), count = std::size_t(count_) - first;
  const std::size_t words = (count + 63) / 64;
  met_.resize(words);
  if (words == 0) return;
  met_.back() = 0;
  const SweepPiece& p = piece(own);
  meeting({lowest_.data() + first, highest_.data() + first, count}, p.lowest_x, p.highest_x,
          reinterpret_cast<std::uint8_t*>(met_.data()));
  if (count % 64) met_.back() &= (std::uint64_t{1} << count % 64) - 1;
  for (const int not_this : {slot - first_slot, met - first_slot})
    if (not_this >= 0) met_[std::size_t(not_this) / 64] &= ~(std::uint64_t{1} << not_this % 64);
  for (std::size_t w = 0; w < words; ++w)
    for (std::uint64_t bits = met_[w]; bits; bits &= bits - 1) {
      const std::size_t at = first + 64 * w + std::size_t(std::countr_zero(bits));
      const int other = active_[at];
      if (int(at) < slot)
        meet(other, own, y);
      else
        meet(own, other, y);
    }
}

/// The pieces at a slot and the next have been neighbours until now: were they in order all the while?
void Sweep::parted(int slot, double y) {
  const double from = together_[std::size_t(slot)];
  together_[std::size_t(slot)] = y;
  if (!(y > from)) return;
  // Pieces that show nothing are checked too: a wrong order of theirs may hide something that would show.
  if (highest_[std::size_t(slot)] <= lowest_[std::size_t(slot) + 1]) return;
  const SweepPiece &left = at(slot), &right = at(slot + 1);
  ++stats_.proofs;
  if (in_order(left, right, from, y, may_differ_)) return;
  const double xs[] = {x_at(left, from), x_at(left, y), x_at(right, from), x_at(right, y)};
  const auto [lo, hi] = std::minmax_element(std::begin(xs), std::end(xs));
  doubts_.push_back({*lo, *hi, from, y});
}

}  // namespace mien
