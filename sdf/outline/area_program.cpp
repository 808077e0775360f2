#include "sdf/outline/area_program.h"
#include "sdf/outline/outline_maker.h"
#include "sdf/shape/curve/band.h"
#include "sdf/shape/same_shape.h"

#include <algorithm>
#include <cmath>
#include "lib/base/bit_cast.h"

namespace mien {

using Kind = AreaStep::Kind;

namespace {

constexpr std::size_t kFirstOutlines = 256;

/// Whether both are strokes, and the second begins as the first ends.
bool meet(const Shape& first, const Shape& second) {
  const auto a = tapered(first), b = tapered(second);
  return a && b && a->spine.p2 == b->spine.p0 && a->half_width[2] == b->half_width[0];
}

std::uint64_t hash_of(const OutlineSource& source) {
  std::uint64_t h = mien::bit_cast<std::uint64_t>(source.amount) + std::uint64_t(source.rim);
  h = (h ^ (std::uint64_t(source.shape) << 32) ^ std::uint64_t(source.count)) *
      0x9e3779b97f4a7c15ull;
  return h ^ (h >> 29);
}

}  // namespace

void AreaPrograms::begin(const Scene& scene) {
  scene_ = &scene;
  steps_.clear(), outlines_.clear(), added_.clear();
  if (at_levels_.size() > kFirstOutlines) at_levels_.resize(std::max(4 * leveled_, kFirstOutlines));
  at_levels_.assign(std::bit_ceil(std::max(at_levels_.size(), kFirstOutlines)), -1);
  leveled_ = 0;
  filled_.assign(scene.shapes().size(), -1);
  find_alike();
}

/// Of equal shapes the first stands for all.
void AreaPrograms::find_alike() {
  const auto shapes = scene_->shapes();
  hashes_.clear(), alike_.clear();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    hashes_.emplace_back(hash_of(shapes[i]), int(i));
    alike_.push_back(int(i));
  }
  std::sort(hashes_.begin(), hashes_.end());
  for (std::size_t i = 1; i < hashes_.size(); ++i) {
    const int before = alike_[std::size_t(hashes_[i - 1].second)], now = hashes_[i].second;
    if (hashes_[i].first == hashes_[i - 1].first &&
        same_shape(shapes[std::size_t(before)], shapes[std::size_t(now)]))
      alike_[std::size_t(now)] = before;
  }
}

/// Uses a stack of its own: trees may be a hundred thousand deep.
AreaProgram AreaPrograms::add(Area area, double level) {
  AreaProgram made{.first = int(steps_.size())};
  todo_.clear();
  if (area.node >= 0) todo_.push_back({.node = area.node, .level = level});
  while (!todo_.empty()) {
    const Task task = todo_.back();
    todo_.pop_back();
    if (task.node >= 0)
      expand(task.node, task.level);
    else if (task.count > 0)
      outline(task.row, task.level, false, task.count);
    else
      step(task.kind);
  }
  made.count = int(steps_.size()) - made.first;
  return made;
}

AreaProgram AreaPrograms::add(Shape shape) {
  outline(added(std::move(shape)), 0.0, false);
  return {int(steps_.size()) - 1, 1};
}

int AreaPrograms::added(Shape shape) {
  added_.push_back(std::move(shape));
  filled_.push_back(-1);
  alike_.push_back(int(alike_.size()));
  return int(filled_.size()) - 1;
}

const Shape& AreaPrograms::shape(const OutlineSource& of) const {
  const std::size_t own = scene_->shapes().size(), index = std::size_t(of.shape);
  if (index >= own) return added_[index - own];
  return of.rim ? scene_->outlined_shape(index) : scene_->shapes()[index];
}

bool AreaPrograms::same(int outline, const AreaPrograms& others, int other) const {
  const OutlineSource &a = outlines_[std::size_t(outline)],
                      &b = others.outlines_[std::size_t(other)];
  if (a.amount != b.amount || a.rim != b.rim || a.count != b.count) return false;
  for (int i = 0; i < a.count; ++i)
    if (!same_shape(shape({a.shape + i, 0.0, false}), others.shape({b.shape + i, 0.0, false})))
      return false;
  return true;
}

/// Those before the first that differs, those after the last one, and in between those at one place in equally many.
void AreaPrograms::find_same(const AreaPrograms& others, std::vector<int>& same_as) const {
  const int count = int(outlines_.size()), more = int(others.outlines_.size()) - count,
            least = std::min(count, count + more);
  same_as.assign(outlines_.size(), -1);
  int first = 0, last = 0;
  while (first < least && same(first, others, first)) same_as[std::size_t(first)] = first, ++first;
  for (; last < least - first && same(count - 1 - last, others, count + more - 1 - last); ++last)
    same_as[std::size_t(count - 1 - last)] = count + more - 1 - last;
  for (int i = first; more == 0 && i < count - last; ++i)
    if (same(i, others, i)) same_as[std::size_t(i)] = i;
}

/// The stack runs backwards: last pushed is done first.
void AreaPrograms::expand(int node, double level) {
  const Node& n = scene_->nodes()[std::size_t(node)];
  const auto visit_next = [&](int at, double v) { todo_.push_back({.node = at, .level = v}); };
  const auto write_after = [&](Kind kind) { todo_.push_back({.kind = kind}); };
  switch (n.op) {
    case Op::shape:
      return leaf(n.a, level);
    case Op::unite:
      if (row(node, level)) return;
      [[fallthrough]];
    case Op::intersect:
      write_after(n.op == Op::unite ? Kind::or_ : Kind::and_);
      visit_next(n.b, level);
      return visit_next(n.a, level);
    case Op::subtract:
      write_after(Kind::and_);
      write_after(Kind::not_);
      visit_next(n.b, -level);
      return visit_next(n.a, level);
    case Op::complement:
      write_after(Kind::not_);
      return visit_next(n.a, -level);
    case Op::offset:
      return visit_next(n.a, level + n.amount);
    case Op::shell: {
      const double k = level + n.amount;
      if (!(k >= 0.0)) return write_after(Kind::nothing);
      write_after(Kind::and_);
      write_after(Kind::not_);
      visit_next(n.a, -k);
      return visit_next(n.a, k);
    }
  }
}

/// Whether the node unites a row of strokes, last and topmost in it, with what is before.
bool AreaPrograms::row(int node, double level) {
  const auto nodes = scene_->nodes();
  const auto stroke = [&](int at) {
    return nodes[std::size_t(at)].op == Op::shape ? nodes[std::size_t(at)].a : -1;
  };
  int first = stroke(nodes[std::size_t(node)].b), count = 1;
  if (first < 0 || !std::isfinite(level)) return false;
  int rest = nodes[std::size_t(node)].a;
  const auto goes_on = [&](int before) {
    return before == first - 1 && before >= 0 &&
           meet(scene_->shapes()[std::size_t(before)], scene_->shapes()[std::size_t(first)]);
  };
  for (; rest >= 0; ++count, --first) {
    const Node& before = nodes[std::size_t(rest)];
    if (!goes_on(before.op == Op::unite ? stroke(before.b) : stroke(rest))) break;
    rest = before.op == Op::unite ? before.a : -1;
  }
  if (count == 1) return false;
  int like = alike_[std::size_t(first)];
  for (int i = 1; i < count; ++i)
    if (alike_[std::size_t(first + i)] != like + i) like = first;
  if (rest >= 0) todo_.push_back({.kind = Kind::or_});
  todo_.push_back({.level = level, .row = like, .count = count});
  if (rest >= 0) todo_.push_back({.node = rest, .level = level});
  return true;
}

void AreaPrograms::outline(int shape, double amount, bool rim, int count) {
  int& known = amount == 0.0 && count == 1 ? filled_[std::size_t(shape)]
                                           : at_level({shape, amount, rim, count});
  if (known < 0) {
    known = int(outlines_.size());
    outlines_.push_back({shape, amount, rim, count});
  }
  steps_.push_back({Kind::outline, known});
}

/// Where the outline's index is, or goes.
int& AreaPrograms::at_level(const OutlineSource& source) {
  if (2 * ++leveled_ > at_levels_.size()) {
    at_levels_.assign(2 * at_levels_.size(), -1);
    leveled_ = 1;
    for (std::size_t i = 0; i < outlines_.size(); ++i)
      if (outlines_[i].amount != 0.0 || outlines_[i].count > 1) at_level(outlines_[i]) = int(i);
  }
  std::size_t i = hash_of(source) & (at_levels_.size() - 1);
  for (; at_levels_[i] >= 0; i = (i + 1) & (at_levels_.size() - 1)) {
    const OutlineSource& other = outlines_[std::size_t(at_levels_[i])];
    if (other.shape == source.shape && other.amount == source.amount && other.rim == source.rim &&
        other.count == source.count) {
      --leveled_;
      break;
    }
  }
  return at_levels_[i];
}

void AreaPrograms::leaf(int index, double level) {
  index = alike_[std::size_t(index)];
  if (level == 0.0) return outline(index, 0.0, false);
  if (!std::isfinite(level)) {  // all of the plane, or nothing
    step(Kind::nothing);
    if (level > 0.0) step(Kind::not_);
    return;
  }
  const Shape& whole = shape({index, 0.0, false});
  if (offset_shape(whole, level)) return outline(index, level, false);
  if (const Band* band = std::get_if<Band>(&whole); band && is_empty(*band)) {
    // Its distance is that to the farther side: positive, but perhaps less than the level.
    const Band sides = *band;
    leaf(added(sides.lower), level);
    leaf(added(sides.upper), level);
    return step(Kind::and_);
  }
  outline(index, 0.0, false);
  outline(index, std::abs(level), true);
  if (level < 0.0) step(Kind::not_);
  step(level < 0.0 ? Kind::and_ : Kind::or_);
}

}  // namespace mien
