#include "render/shade/nearest/near_area.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

void NearArea::narrow(const FeetArea& area, glm::dvec2 middle, double radius) {
  area_ = &area, middle_ = middle, count_ = 0;
  const auto& all = area.area()->nodes();
  if (all.size() == 1)
    nodes_.assign(all.begin(), all.end());
  else
    area.area()->narrow(middle - area.center(), radius, nodes_);
  for (Node& n : nodes_) {
    if (n.op != Op::shape) continue;
    n.b = int(count_);
    if (count_ == leaves_.size()) leaves_.emplace_back();
    Leaf& leaf = leaves_[count_++];
    const ShapeSpines& spines = area.shapes()[std::size_t(n.a)];
    worked(30 * std::int64_t(spines.list.spines.size()));
    leaf.tree = spines.tree ? &*spines.tree : nullptr;
    gather_branches(spines.list, middle, radius, leaf.branches);
    if (spines.slow) leaf.branches.crowded = true;
  }
  pairs_.resize(nodes_.size() > 1 ? nodes_.size() : 0);
  ranges_.resize(pairs_.size()), needed_.resize(pairs_.size());
}

bool NearArea::crowded() const {
  return std::any_of(leaves_.begin(), leaves_.begin() + std::ptrdiff_t(count_),
                     [](const Leaf& leaf) { return leaf.branches.crowded; });
}

NearArea::Range NearArea::decide(const Node& n, float change, NearNode::Asks& asks) const {
  using Asks = NearNode::Asks;
  const auto negative = [](Range v) { return Range{-v.most, -v.least}; };
  Range a = ranges_[std::size_t(n.a)], b = ranges_[std::size_t(n.b)];
  const float amount = float(n.amount);
  if (n.op == Op::complement) return negative(a);
  if (n.op == Op::offset) return {a.least - amount, a.most - amount};
  if (n.op == Op::shell) return {-amount, std::max(std::abs(a.least), std::abs(a.most)) - amount};
  if (n.op == Op::subtract) b = negative(b);
  // The lesser one counts.
  const bool turned = n.op != Op::unite;
  if (turned) a = negative(a), b = negative(b);
  if (asks == Asks::both)
    asks = a.least > b.most + change   ? Asks::second
           : b.least > a.most + change ? Asks::first
                                       : Asks::both;
  const Range to = asks == Asks::first ? a
                   : asks == Asks::second
                       ? b
                       : Range{std::min(a.least, b.least), std::min(a.most, b.most)};
  return turned ? negative(to) : to;
}

void NearArea::leave_out(float r, NearNode* nodes) {
  using Asks = NearNode::Asks;
  // [of r] Distances change by at most one per length, so 2 would do; a ridge that is left out lies a quarter of r
  // outside of the square.
  constexpr float kChange = 2.5f, kFloats = 0.02f;
  const float change = kChange * r + kFloats;
  std::fill(needed_.begin(), needed_.end(), 0);
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (nodes_[k].op != Op::shape && nodes[k].asks != Asks::nothing)
      ranges_[k] = decide(nodes_[k], change, nodes[k].asks);
  needed_[nodes_.size() - 1] = 1;
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const Node& n = nodes_[k];
    if (!needed_[k]) nodes[k].asks = Asks::nothing;
    if (!needed_[k] || n.op == Op::shape) continue;
    if (nodes[k].asks != Asks::second) needed_[std::size_t(n.a)] = 1;
    if (nodes[k].asks != Asks::first) needed_[std::size_t(n.b)] = 1;
  }
}

std::size_t NearArea::deciding(const NearNode* nodes, std::size_t node) const {
  // Operands lie before their operators, so this ends. Leaves ask nobody.
  for (;;) {
    const Node& n = nodes_[node];
    if (n.op == Op::shape) return node;
    if (nodes[node].asks == NearNode::Asks::first)
      node = std::size_t(n.a);
    else if (nodes[node].asks == NearNode::Asks::second && n.op != Op::subtract)
      node = std::size_t(n.b);
    else
      return node;
  }
}

void NearArea::sign_by_windings(const PathTree& tree, const float* x, const float* y,
                                BranchPair& pair) const {
  worked(30 * BranchPair::kPlaces);
  // No side lies within a place's distance of it, so places there have its winding number.
  glm::dvec2 known{0.0};
  double around = 0.0;
  bool inside = false;
  for (int i = 0; i < BranchPair::kPlaces; ++i) {
    const glm::dvec2 p{x[i], y[i]};
    if (!(glm::distance(p, known) < around)) {
      constexpr double kFloats = 1e-3;  // [px] more than distances of floats are off by
      inside = tree.inside(middle_ - area_->center() + p);
      known = p, around = std::abs(double(pair.best.d[i])) - kFloats;
    }
    for (BranchPair::Values* v : {&pair.best, &pair.beyond}) {
      if ((v->d[i] < 0.0f) == inside) continue;
      v->d[i] = -v->d[i], v->nx[i] = -v->nx[i], v->ny[i] = -v->ny[i];
    }
  }
}

}  // namespace mien
