#include "sdf/arrange/sweep.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

// Of a band's steps, and more for each piece and end that it passes: enough for any face, and an end.
constexpr long kHalvingsOfBand = 2000;

}  // namespace

bool Sweep::inside(int outline, int winding) const {
  return outlines_->rules[std::size_t(outline)] == FillRule::even_odd ? winding & 1 : winding != 0;
}

void Sweep::sweep(const Outlines& outlines, double top, double bottom, Regions& regions,
                  double order) {
  outlines_ = &outlines, regions_ = &regions, bottom_ = bottom, may_differ_ = order;
  constexpr double kFar = 0x1p30;  // the same side whatever is swept
  side_ = {outlines.left, -kFar, 0.0, kFar, 0.0, 0.0, outlines.left, kFar};
  fragments_.clear(), doubts_.clear(), order_.clear(), region_.clear(), free_.clear();
  first_in_band_.assign(1, 0);
  lanes_.count = 0, active_.clear(), slopes_.clear();
  stats_ = {};
  stats_.pieces = long(outlines.pieces.size());
  halvings_left_ = kHalvingsOfBand;
  holds(bytes());
  begin_at(top);
  double border = std::floor(top / kBandRows) * kBandRows + kBandRows;  // the next one
  for (auto e = std::lower_bound(outlines.ends.begin(), outlines.ends.end(), top,
                                 [](const OutlineEnd&end, double y) { return end.y < y; });
       e != outlines.ends.end() && e->y < bottom; ++e) {
    for (; border <= e->y; border += kBandRows) cross_border(border);
    go_to(e->y);
    end_or_begin(*e);
    halvings_left_ += kHalvingsOfPiece;
  }
  for (; border < bottom; border += kBandRows) cross_border(border);
  go_to(bottom);
  for (const int lane : order_) finish(lane, bottom);
  finish_left(bottom);
  first_in_band_.push_back(int(fragments_.size()));
  stats_.regions = regions.count();
}

void Sweep::cross_border(double y) {
  go_to(y);
  if (in_bands_) {
    for (const int lane : order_) finish(lane, y);
    finish_left(y);
    first_in_band_.push_back(int(fragments_.size()));
  }
  sort_at_border();
  halvings_left_ = kHalvingsOfBand;
}

/// The order from nothing: the chains that come from above, as they are seen from there.
void Sweep::begin_at(double y) {
  y_ = y;
  windings_.assign(outlines_->rules.size(), 0);
  left_ = 0, left_from_ = y;
  for (const OutlineEnd& e : outlines_->ends)
    if (const OutlineChain& c = outlines_->chains[std::size_t(e.chain)];
        e.other < 0 && e.y < y && e.x == outlines_->left)
      windings_[std::size_t(c.outline)] += e.begins ? -c.turn : c.turn;
  for (std::size_t i = 0; i < windings_.size(); ++i)
    if (inside(int(i), windings_[i])) left_ = regions_->across(left_, int(i));
  left_look_ = regions_->look(left_);
  const auto& pieces = outlines_->pieces;
  for (std::size_t i = 0; i < outlines_->chains.size(); ++i) {
    const OutlineChain& c = outlines_->chains[i];
    if (!(pieces[std::size_t(c.first)].y0 < y && y <= pieces[std::size_t(c.last)].y1)) continue;
    int p = c.first;
    while (pieces[std::size_t(p)].y1 < y) ++p;
    const OutlinePiece& own = pieces[std::size_t(p)];
    const double t = parameter_at(own, y);
    const int lane = enter(count(), int(i), p, x_of(own, t), y);
    lanes_.t[std::size_t(lane)] = t;
  }
  std::sort(order_.begin(), order_.end(), [&](int a, int b) { return belongs_after(b, a); });
  for (int slot = 0; slot < count(); ++slot) {
    Active& c = at(slot);
    c.winding = winding_left_of(slot, c.outline);
    c.flips = inside(c.outline, c.winding) != inside(c.outline, c.winding + c.turn);
    const int left = region_left_of(slot);
    region_[std::size_t(slot)] = c.flips ? regions_->across(left, c.outline) : left;
    c.left_look = regions_->look(left), c.right_look = regions_->look(region_[std::size_t(slot)]);
  }
}

/// At a border of bands: by place, to less than shows, and of those at one place by number.
bool Sweep::belongs_after(int a, int b) const {
  constexpr double kCells = 0x1p20;
  const double x = lanes_.x[std::size_t(a)], u = lanes_.x[std::size_t(b)];
  if (x + 2.0 / kCells < u) return false;
  const double i = std::floor(x * kCells), k = std::floor(u * kCells);
  return i != k ? i > k : active_[std::size_t(a)].chain > active_[std::size_t(b)].chain;
}

void Sweep::sort_at_border() {
  for (int slot = 1; slot < count(); ++slot)
    for (int i = slot; i > 0 && belongs_after(order_[std::size_t(i) - 1], order_[std::size_t(i)]);
         --i)
      force(i - 1, y_);
}

void Sweep::go_to(double y) {
  if (!(y > y_)) return;
  if (!order_.empty()) step(y, 0);
  y_ = y;
}

int Sweep::winding_left_of(int slot, int outline) const {
  while (slot-- > 0)
    if (const Active& f = at(slot); f.outline == outline) return f.winding + f.turn;
  return windings_[std::size_t(outline)];
}

/// Two that are where they are by more than a crossing.
void Sweep::force(int slot, double y) {
  worked(60);
  ++stats_.forced;
  swap(slot, y);
}

void Sweep::swap(int slot, double y) {
  const auto s = std::size_t(slot);
  Active &p = at(slot), &q = at(slot + 1);
  if (p.outline == q.outline) {
    q.winding = p.winding;
    p.winding = q.winding + q.turn;
    q.flips = inside(q.outline, q.winding) != inside(q.outline, q.winding + q.turn);
    p.flips = inside(p.outline, p.winding) != inside(p.outline, p.winding + p.turn);
  }
  const int left = region_left_of(slot);
  region_[s] = q.flips ? regions_->across(left, q.outline) : left;
  std::swap(order_[s], order_[s + 1]);
  show(slot, y), show(slot + 1, y);
}

/// The looks may change here: what was shown so far becomes fragments.
void Sweep::show(int slot, double y) {
  Active& c = at(slot);
  const int left = regions_->look(region_left_of(slot)),
            right = regions_->look(region_[std::size_t(slot)]);
  if (left == c.left_look && right == c.right_look) return;
  finish(order_[std::size_t(slot)], y);
  c.left_look = left, c.right_look = right;
}

/// What a chain has shown until now becomes fragments, one a piece.
void Sweep::finish(int lane, double y) {
  Active& c = active_[std::size_t(lane)];
  const auto& pieces = outlines_->pieces;
  if (c.left_look == c.right_look || !(y > c.shown_from)) {
    c.shown_from = y;
    return;
  }
  int i = c.shown_piece;
  for (double from = c.shown_from; from < y;) {
    while (i < c.last && pieces[std::size_t(i)].y1 <= from) ++i;
    const double until = i < c.last ? std::min(pieces[std::size_t(i)].y1, y) : y;
    fragments_.push_back({i, c.left_look, c.right_look, from, until});
    from = until;
  }
  c.shown_piece = i, c.shown_from = y;
}

std::size_t Sweep::bytes() const {
  return fragments_.capacity() * sizeof(Fragment) + doubts_.capacity() * sizeof(Doubt) +
         active_.capacity() * sizeof(Active) + lanes_.bytes() +
         outlines_->pieces.capacity() * sizeof(OutlinePiece) +
         outlines_->chains.capacity() * sizeof(OutlineChain) +
         outlines_->ends.capacity() * sizeof(OutlineEnd) + regions_->bytes();
}

}  // namespace mien
