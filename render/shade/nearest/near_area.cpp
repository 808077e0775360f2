#include "render/shade/nearest/near_area.h"
#include "lib/base/watch.h"
#include "sdf/csg/combine.h"

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
    prune(all, middle - area.center(), radius, nodes_);
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
}

bool NearArea::crowded() const {
  return std::any_of(leaves_.begin(), leaves_.begin() + std::ptrdiff_t(count_),
                     [](const Leaf& leaf) { return leaf.branches.crowded; });
}

/// What of a tree decides somewhere in a disc: of two operands one alone, where the other is farther by more than both
/// can change.
void NearArea::prune(std::span<const Node> nodes, glm::dvec2 middle, double radius,
                     std::vector<Node>& to) {
  constexpr int kUnused = -4, kNeeded = -3, kOnlyA = -2, kOnlyB = -1;
  worked(60 * std::int64_t(nodes.size()));
  const AreaDistance& area = *area_->area();
  const double change = 2.0 * radius + 1e-3;
  const std::size_t count = nodes.size();
  values_.resize(count), place_.assign(count, kUnused);
  for (std::size_t i = 0; i < count; ++i) {
    const Node& n = nodes[i];
    values_[i] = n.op == Op::shape ? area.of_shape(std::size_t(n.a), middle)
                                   : combine(n.op, values_[std::size_t(n.a)],
                                             values_[std::size_t(n.b)], n.amount);
  }
  place_[count - 1] = kNeeded;
  for (std::size_t i = count; i-- > 0;) {
    const Node& n = nodes[i];
    if (place_[i] == kUnused || n.op == Op::shape) continue;
    const bool binary = n.op == Op::unite || n.op == Op::intersect || n.op == Op::subtract;
    const double sign = n.op == Op::unite ? -1.0 : 1.0;  // the larger one counts
    const double a = sign * values_[std::size_t(n.a)], b = n.op == Op::subtract
                                                               ? -values_[std::size_t(n.b)]
                                                               : sign * values_[std::size_t(n.b)];
    place_[i] = binary && a > b + change ? kOnlyA : binary && b > a + change ? kOnlyB : kNeeded;
    if (place_[i] != kOnlyB) place_[std::size_t(n.a)] = kNeeded;
    if (binary && place_[i] != kOnlyA) place_[std::size_t(n.b)] = kNeeded;
  }
  to.clear();
  for (std::size_t i = 0; i < count; ++i) {
    Node n = nodes[i];
    const int how = place_[i];
    if (how == kUnused) continue;
    if (n.op != Op::shape) {
      const int a = place_[std::size_t(n.a)], b = place_[std::size_t(n.b)];
      const int only = how == kOnlyA ? a : how == kOnlyB ? b : -1;
      if (only >= 0 && !(how == kOnlyB && n.op == Op::subtract)) {
        place_[i] = only;
        continue;
      }
      n.a = only >= 0 ? only : a, n.b = only >= 0 ? only : b;
      if (only >= 0) n.op = Op::complement;
    }
    place_[i] = int(to.size());
    to.push_back(n);
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
