// What the sweep does at the picture's sides, where outlines are cut: a loop that leaves through a side leaves the
// order, one that comes back enters it. Beyond the left side there are winding numbers and one region; what the
// right side cuts off changes no pixel.

#include "sdf/arrange/sweep.h"

namespace mien {

void Sweep::end_or_begin(const OutlineEnd& e) {
  const auto piece_of = [&](int chain) {
    const OutlineChain& c = outlines_->chains[std::size_t(chain)];
    return e.begins ? c.first : c.last;
  };
  const int own = piece_of(e.chain);
  if (e.other >= 0) return (this->*(e.begins ? &Sweep::start : &Sweep::end))(own, piece_of(e.other), e);
  const bool left = e.x == outlines_->left;
  if (left)
    windings_[std::size_t(piece(own).outline)] += e.begins ? -piece(own).turn : piece(own).turn;
  if (e.begins)
    come(own, left, e.y);
  else
    leave(own, left, e.y);
  show_left(e.y);
}

void Sweep::leave(int i, bool left, double y) {
  int slot = piece(i).slot;
  for (; left && slot > 0; --slot) ++stats_.forced, swap(slot - 1, y);
  for (; !left && slot + 1 < count_; ++slot) ++stats_.forced, swap(slot, y);
  if (slot > 0) parted(slot - 1, y);
  if (slot + 1 < count_) parted(slot, y);
  finish(slot, y);
  if (left) left_ = region_[0];
  piece(i).slot = -1;
  close_slots(slot, 1);
}

void Sweep::come(int i, bool left, double y) {
  const int slot = left ? 0 : count_;
  open_slots(slot, 1);
  put(slot, i);
  SweepPiece& p = piece(i);
  p.winding = winding_left_of(slot, p.outline);
  p.flips = inside(p.outline, p.winding) != inside(p.outline, p.winding + p.turn);
  const int before = region_left_of(slot),
            across = p.flips ? regions_->across(before, p.outline) : before;
  region_[std::size_t(slot)] = left ? before : across;
  if (left) left_ = across;
  enter(slot, y);
  if (slot > 0) together_[std::size_t(slot) - 1] = y;
  meet_others(slot, y, 0);
}

/// What lies left of the picture may look different now: what was shown so far becomes a fragment of its side.
void Sweep::show_left(double y) {
  const int look = regions_->look(left_), none = regions_->look(0);
  if (look == left_look_ && y < bottom_) return;
  if (left_look_ != none && y > left_from_)
    fragments_.push_back({int(outlines_->pieces.size()), none, left_look_, left_from_, y});
  left_look_ = look, left_from_ = y;
}

}  // namespace mien
