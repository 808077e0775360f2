// One step of the sweep: all active chains from one height to the next.

#include "lib/base/watch.h"
#include "sdf/arrange/sweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

constexpr double kUntouched = -HUGE_VAL;

}  // namespace

void Sweep::step(double y, int depth) {
  constexpr int kOften = 64;  // steps between two counts of what is held
  if (++stats_.steps % kOften == 0) holds(bytes());
  worked(30 + 10 * std::int64_t(order_.size()));
  pass_pieces(y);
  place(lanes_, y_, y);
  for (const int lane : passed_) stray(lane, y);
  may_halve_ = depth < most_halvings_ && halvings_left_ > 0;
  if (!in_order_until(y) && may_halve_) {
    --halvings_left_, ++stats_.halvings;
    for (const int lane : passed_) {
      Active& c = active_[std::size_t(lane)];
      c.piece = c.above;
      lanes_.load(std::size_t(lane), outlines_->pieces[std::size_t(c.piece)]);
    }
    const double least = (y - y_) * 0x1p-6, inside = std::clamp(fails_at_, y_, y),
                 middle = inside - y_ > least && y - inside > least ? inside : 0.5 * (y_ + y);
    step(middle, depth + 1);
    y_ = middle;
    return step(y, depth + 1);
  }
  doubts_.insert(doubts_.end(), unsure_.begin(), unsure_.end());
  for (const Swap& s : swaps_) ++stats_.crossings, swap(s.slot, s.y);
  for (const int lane : passed_) {
    Active& c = active_[std::size_t(lane)];
    halvings_left_ += kHalvingsOfPiece * (c.piece - c.above);
    c.above = c.piece;
  }
  lanes_.x.swap(lanes_.next_x), lanes_.t.swap(lanes_.next_t);
}

/// Pieces that end at the upper height give way to the next; a level one between them moves its chain at once. Then to
/// the pieces at the lower height.
void Sweep::pass_pieces(double y) {
  const auto& pieces = outlines_->pieces;
  bool moved = false;
  passed_.clear();
  for (std::size_t lane = 0; lane < lanes_.count; ++lane) {
    if (!(lanes_.bottom[lane] < y)) continue;
    Active& c = active_[lane];
    if (c.piece == c.last) continue;
    if (lanes_.bottom[lane] <= y_) {
      while (pieces[std::size_t(c.piece)].y1 <= y_ && c.piece < c.last) ++c.piece;
      const double x = pieces[std::size_t(c.piece)].x0;
      moved = moved || std::abs(x - lanes_.x[lane]) > kTouch;
      lanes_.x[lane] = x, lanes_.t[lane] = 0.0;
    }
    c.above = c.piece;
    while (pieces[std::size_t(c.piece)].y1 < y && c.piece < c.last) ++c.piece;
    lanes_.load(lane, pieces[std::size_t(c.piece)]);
    if (c.above != c.piece) passed_.push_back(int(lane));
  }
  if (!moved) return;
  const auto x = [&](int slot) { return lanes_.x[std::size_t(order_[std::size_t(slot)])]; };
  for (int slot = 1; slot < count(); ++slot)
    for (int i = slot; i > 0 && x(i - 1) > x(i) + kTouch; --i) force(i - 1, y_);
}

/// How far a chain of several pieces strays: to where they meet, and by their own bulges.
void Sweep::stray(int lane, double y) {
  const auto i = std::size_t(lane);
  const Active& c = active_[i];
  const double x = lanes_.x[i], lean = (lanes_.next_x[i] - x) / (y - y_);
  double left = 0.0, right = 0.0, bulge_left = 0.0, bulge_right = 0.0;
  for (int k = c.above; k <= c.piece; ++k) {
    const OutlinePiece& p = outlines_->pieces[std::size_t(k)];
    if (k < c.piece) {
      const double off = p.x1 - (x + (p.y1 - y_) * lean);
      left = std::max(left, -off), right = std::max(right, off);
      lanes_.low[i] = std::min(lanes_.low[i], p.x1);
      lanes_.high[i] = std::max(lanes_.high[i], p.x1);
    }
    const double turns = turning(p), high = p.y1 - p.y0, wide = std::abs(p.x1 - p.x0);
    double& bulge = turns > 0.0 ? bulge_right : bulge_left;
    if (high > 0.0) bulge = std::max(bulge, std::min(0.5 * std::abs(turns) / high, wide));
  }
  lanes_.sag_left[i] = left + bulge_left, lanes_.sag_right[i] = right + bulge_right;
}

/// Whether extents or chords prove two lanes in order all the way down.
bool Sweep::cheap(int left, int right) const {
  const auto a = std::size_t(left), b = std::size_t(right);
  const SweepLanes& s = lanes_;
  if (s.high[a] <= s.low[b] + may_differ_) return true;
  const double gap = std::min(s.x[b] - s.x[a], s.next_x[b] - s.next_x[a]);
  return gap + may_differ_ >= s.sag_right[a] + s.sag_left[b];
}

/// Plans the swaps of a step. False if it cannot be proven that the order is right with them.
bool Sweep::in_order_until(double y) {
  swaps_.clear(), unproven_.clear(), unsure_.clear();
  bool crossed = false;
  double most = -HUGE_VAL;  // of the places so far: many slight disorders make a large one
  for (int slot = 0; slot + 1 < count(); ++slot) {
    const int a = order_[std::size_t(slot)], b = order_[std::size_t(slot) + 1];
    most = std::max(most, lanes_.next_x[std::size_t(a)]);
    const double next = lanes_.next_x[std::size_t(b)];
    if (cheap(a, b)) {
      crossed = crossed || most > next + may_differ_;
      continue;
    }
    unproven_.push_back(slot);
    crossed = crossed || most > next + kTouch;
  }
  if (unproven_.empty() && !crossed) return true;
  planned_ = order_;
  in_run_.assign(order_.size(), 0);
  since_.assign(order_.size(), kUntouched);
  if (crossed) {
    plan_runs(y);
    std::sort(swaps_.begin(), swaps_.end(), [](const Swap& a, const Swap& b) {
      return a.y != b.y ? a.y < b.y : a.number < b.number;
    });
    planned_ = order_;
    since_.assign(order_.size(), kUntouched);
  }
  prove_swaps(y);
  return unsure_.empty();
}

/// Runs of slots whose chains change places: a run ends where no chain to its right has to go farther left.
void Sweep::plan_runs(double y) {
  const auto next = [&](int slot) { return lanes_.next_x[std::size_t(order_[std::size_t(slot)])]; };
  least_.resize(order_.size() + 1);
  least_.back() = HUGE_VAL;
  for (int i = count() - 1; i >= 0; --i)
    least_[std::size_t(i)] = std::min(least_[std::size_t(i) + 1], next(i));
  const auto least_right_of = [&](int slot) { return least_[std::size_t(slot) + 1] + kTouch; };
  runs_.clear();
  for (int slot = 0; slot < count(); ++slot) {
    int last = slot;
    for (double most = next(slot); most > least_right_of(last); most = std::max(most, next(last)))
      ++last;
    if (last > slot) runs_.emplace_back(slot, last);
    for (int i = slot; last > slot && i <= last; ++i) in_run_[std::size_t(i)] = 1;
    slot = last;
  }
  met_.resize(order_.size());
  for (const auto& [first, last] : runs_) plan_run(first, last, y);
}

/// Each time the highest crossing of two that are neighbours by then: a chain may come from afar before.
void Sweep::plan_run(int first, int last, double y) {
  if (last == first + 1 && hidden(first))
    return swaps_.push_back({y_, int(swaps_.size()), first, true});
  using Met = std::pair<double, int>;
  const auto later = [](const Met& a, const Met& b) { return a > b; };
  std::fill(met_.begin() + first, met_.begin() + last, HUGE_VAL);
  heap_.clear();
  const auto meet = [&](int slot, double from) {
    const auto s = std::size_t(slot);
    const int a = planned_[s], b = planned_[s + 1];
    met_[s] = HUGE_VAL;
    if (!(lanes_.next_x[std::size_t(a)] > lanes_.next_x[std::size_t(b)] + kTouch)) return;
    met_[s] = meeting(run_of(a), run_of(b), from, y);
    heap_.emplace_back(met_[s], slot);
    std::push_heap(heap_.begin(), heap_.end(), later);
  };
  for (int slot = first; slot < last; ++slot) meet(slot, y_);
  while (!heap_.empty()) {
    const auto [height, slot] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
    worked(200);
    if (met_[std::size_t(slot)] != height) continue;  // others are neighbours there by now
    int &a = planned_[std::size_t(slot)], &b = planned_[std::size_t(slot) + 1];
    const bool falls = gap_goes_one_way(a, b) &&
                       lanes_.x[std::size_t(a)] <= lanes_.x[std::size_t(b)] + may_differ_;
    swaps_.push_back({height, int(swaps_.size()), slot, falls});
    std::swap(a, b);
    met_[std::size_t(slot)] = HUGE_VAL;
    if (slot > first) meet(slot - 1, height);
    if (slot + 1 < last) meet(slot + 1, height);
  }
}

/// Whoever are neighbours, from when to when they are, with the planned swaps.
void Sweep::prove_swaps(double y) {
  const auto end_of = [&](int slot, double height) {  // as neighbours
    double& since = since_[std::size_t(slot)];
    if (!stays(slot, std::max(since, y_), height, y) && may_halve_) return false;
    since = height;
    return true;
  };
  for (const Swap& s : swaps_) {
    for (int slot = std::max(s.slot - 1, 0); slot <= s.slot + 1 && slot + 1 < count(); ++slot)
      if (s.proven && slot == s.slot)
        since_[std::size_t(slot)] = y;
      else if (!end_of(slot, s.y))
        return;
    std::swap(planned_[std::size_t(s.slot)], planned_[std::size_t(s.slot) + 1]);
  }
  for (const Swap& s : swaps_)
    for (int slot = std::max(s.slot - 1, 0); slot <= s.slot + 1 && slot + 1 < count(); ++slot)
      if (!end_of(slot, y)) return;
  for (const int slot : unproven_)
    if (since_[std::size_t(slot)] == kUntouched && !end_of(slot, y)) return;
}

/// Whether the neighbours planned for a slot and the next are in order between two heights of the step to y, or it
/// shows nowhere if they are not.
bool Sweep::stays(int slot, double from, double to, double y) {
  const int a = planned_[std::size_t(slot)], b = planned_[std::size_t(slot) + 1];
  if (!(to > from) || cheap(a, b)) return true;
  const auto gap = [&](double at) { return x_of_lane(b, at, y) - x_of_lane(a, at, y); };
  if (gap_goes_one_way(a, b) && gap(from) >= -may_differ_ && gap(to) >= -may_differ_) return true;
  if (hidden(slot)) return true;
  worked(100);
  const std::optional<double> fails = disorder(run_of(a), run_of(b), from, to, may_differ_);
  if (!fails) return true;
  fails_at_ = *fails;
  const auto i = std::size_t(a), k = std::size_t(b);
  unsure_.push_back(
      {std::min(lanes_.low[i], lanes_.low[k]), std::max(lanes_.high[i], lanes_.high[k]), from, to});
  return false;
}

/// Whether it shows nowhere in this step which of a slot and the next is left: one of the two is seen neither left nor
/// right of the other, and both keep to their side of all others, wherever in the step they cross.
bool Sweep::hidden(int slot) const {
  const auto s = std::size_t(slot);
  const bool first = slot == 0, last = slot + 2 == count();
  if ((!first && in_run_[s - 1]) || (!last && in_run_[s + 2])) return false;
  const int left = region_left_of(slot), l = regions_->look(left), m = regions_->look(region_[s]),
            r = regions_->look(region_[s + 1]);
  if (l != m && m != r) return false;
  const Active &p = at(slot), &q = at(slot + 1);
  const bool flips = p.outline == q.outline
                         ? inside(q.outline, p.winding) != inside(q.outline, p.winding + q.turn)
                         : q.flips;
  const int other = flips ? regions_->look(regions_->across(left, q.outline)) : l;
  if (!((l == m && other == r) || (m == r && l == other))) return false;
  const int a = order_[s], b = order_[s + 1];
  const auto after = [&](std::size_t i) { return cheap(order_[i], a) && cheap(order_[i], b); };
  return (first || after(s - 1)) && (slot < 2 || cheap(order_[s - 2], b)) &&
         (last || (cheap(a, order_[s + 2]) && cheap(b, order_[s + 2])));
}

/// The directions that a chain takes in the step.
const Sweep::Slopes& Sweep::slopes(int lane) {
  const auto i = std::size_t(lane);
  Slopes& all = slopes_[i];
  if (all.step == stats_.steps) return all;
  const Active& c = active_[i];
  all = {HUGE_VAL, -HUGE_VAL, stats_.steps};
  const auto add = [&](const OutlinePiece& p, double t) {
    const double x = p.ax + t * p.bx, y = p.ay + t * p.by;
    const double slope = y > 0.0 ? x / y : x > 0.0 ? HUGE_VAL : x < 0.0 ? -HUGE_VAL : 0.0;
    all.least = std::min(all.least, slope), all.most = std::max(all.most, slope);
  };
  for (int k = c.above; k <= c.piece; ++k) {
    const OutlinePiece& p = outlines_->pieces[std::size_t(k)];
    add(p, k == c.above ? lanes_.t[i] : 0.0), add(p, k == c.piece ? lanes_.next_t[i] : 1.0);
  }
  return all;
}

bool Sweep::gap_goes_one_way(int left, int right) {
  const Slopes &l = slopes(left), &r = slopes(right);
  return l.most <= r.least || r.most <= l.least;
}

PieceRun Sweep::run_of(int lane) const {
  const Active& c = active_[std::size_t(lane)];
  return {&outlines_->pieces[std::size_t(c.above)], &outlines_->pieces[std::size_t(c.piece)]};
}

/// At a height of the step to y.
double Sweep::x_of_lane(int lane, double at, double y) const {
  if (at == y_) return lanes_.x[std::size_t(lane)];
  if (at == y) return lanes_.next_x[std::size_t(lane)];
  return x_at(run_of(lane).at(at), at);
}

}  // namespace mien
