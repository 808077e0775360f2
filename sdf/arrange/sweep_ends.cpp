// Where chains begin and end: in the picture two at once; at its sides, where outlines are cut, one. A loop that leaves
// through a side leaves the order, one that comes back enters it. Beyond the left side there are winding numbers and
// one region; what the right side cuts off changes no pixel.

#include "lib/base/watch.h"
#include "sdf/arrange/sweep.h"

#include <algorithm>

namespace mien {

void Sweep::end_or_begin(const OutlineEnd& e) {
  worked(200 + 2 * count());  // slots are looked through, and moved
  if (e.other >= 0) {
    (this->*(e.begins ? &Sweep::start : &Sweep::end))(e);
    return;
  }
  const bool left = e.x == outlines_->left;
  const OutlineChain& c = outlines_->chains[std::size_t(e.chain)];
  if (left) windings_[std::size_t(c.outline)] += e.begins ? -c.turn : c.turn;
  if (e.begins)
    come(e, left);
  else
    leave(e, left);
  show_left(e.y);
}

/// A chain into a slot of its own; its looks are not known yet. Returns its lane.
int Sweep::enter(int slot, int chain, int piece, double x, double y) {
  const OutlineChain& c = outlines_->chains[std::size_t(chain)];
  int lane = int(lanes_.count);
  if (free_.empty()) {
    lanes_.room_for(++lanes_.count);
    active_.emplace_back(), slopes_.emplace_back();
  } else {
    lane = free_.back();
    free_.pop_back();
  }
  const auto i = std::size_t(lane);
  active_[i] = {chain, c.outline, c.turn, piece, piece, c.last, 0, 0, 0, false, piece, y};
  lanes_.load(i, outlines_->pieces[std::size_t(piece)]);
  lanes_.x[i] = x, lanes_.t[i] = 0.0;
  order_.insert(order_.begin() + slot, lane);
  region_.insert(region_.begin() + slot, 0);
  return lane;
}

/// Out of the order.
void Sweep::leave_slot(int slot, double y) {
  const int lane = order_[std::size_t(slot)];
  finish(lane, y);
  free_.push_back(lane);
  lanes_.bottom[std::size_t(lane)] = HUGE_VAL;
  order_.erase(order_.begin() + slot);
  region_.erase(region_.begin() + slot);
}

int Sweep::slot_of(int chain) const {
  int slot = 0;
  while (at(slot).chain != chain) ++slot;
  return slot;
}

void Sweep::start(const OutlineEnd& e) {
  const auto first = [&](int chain) { return outlines_->chains[std::size_t(chain)].first; };
  // Which is left? Their places a little farther down decide.
  const OutlinePiece &p = outlines_->pieces[std::size_t(first(e.chain))],
                     &q = outlines_->pieces[std::size_t(first(e.other))];
  const double y = std::min(p.y1, q.y1), middle = 0.5 * (e.y + y);
  double side = x_at(p, middle) - x_at(q, middle);
  if (side == 0.0) side = x_at(p, y) - x_at(q, y);
  const int left = side < 0.0 ? e.chain : e.other, right = side < 0.0 ? e.other : e.chain;
  const auto place = std::lower_bound(order_.begin(), order_.end(), e.x, [&](int lane, double x) {
    return lanes_.x[std::size_t(lane)] < x;
  });
  const int slot = int(place - order_.begin());
  enter(slot, right, first(right), e.x, e.y);
  enter(slot, left, first(left), e.x, e.y);
  Active &l = at(slot), &r = at(slot + 1);
  l.winding = winding_left_of(slot, l.outline), r.winding = l.winding + l.turn;
  l.flips = r.flips = inside(l.outline, l.winding) != inside(l.outline, r.winding);
  const int around = region_left_of(slot),
            within = l.flips ? regions_->across(around, l.outline) : around;
  region_[std::size_t(slot)] = within, region_[std::size_t(slot) + 1] = around;
  l.left_look = r.right_look = regions_->look(around);
  l.right_look = r.left_look = regions_->look(within);
}

void Sweep::end(const OutlineEnd& e) {
  int slot = slot_of(e.chain), last = slot_of(e.other);
  if (slot > last) std::swap(slot, last);
  for (; last > slot + 1; --last)  // whatever is between them still is out of order
    force(last - 1, e.y);
  finish(order_[std::size_t(slot)], e.y);
  leave_slot(slot + 1, e.y);
  leave_slot(slot, e.y);
}

void Sweep::leave(const OutlineEnd& e, bool left) {
  int slot = slot_of(e.chain);
  for (; left && slot > 0; --slot) force(slot - 1, e.y);
  for (; !left && slot + 1 < count(); ++slot) force(slot, e.y);
  if (left) left_ = region_[0];
  leave_slot(slot, e.y);
}

void Sweep::come(const OutlineEnd& e, bool left) {
  const int slot = left ? 0 : count();
  enter(slot, e.chain, outlines_->chains[std::size_t(e.chain)].first, e.x, e.y);
  Active& c = at(slot);
  c.winding = winding_left_of(slot, c.outline);
  c.flips = inside(c.outline, c.winding) != inside(c.outline, c.winding + c.turn);
  const int before = region_left_of(slot),
            across = c.flips ? regions_->across(before, c.outline) : before;
  region_[std::size_t(slot)] = left ? before : across;
  if (left) left_ = across;
  c.left_look = regions_->look(region_left_of(slot));
  c.right_look = regions_->look(region_[std::size_t(slot)]);
}

/// What lies left of the picture may look different now.
void Sweep::show_left(double y) {
  const int look = regions_->look(left_);
  if (look == left_look_) return;
  finish_left(y);
  left_look_ = look;
}

/// What was shown there so far becomes a fragment of its side.
void Sweep::finish_left(double y) {
  const int none = regions_->look(0);
  if (left_look_ != none && y > left_from_)
    fragments_.push_back({int(outlines_->pieces.size()), none, left_look_, left_from_, y});
  left_from_ = y;
}

}  // namespace mien
