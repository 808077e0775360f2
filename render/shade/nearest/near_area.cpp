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
}

bool NearArea::crowded() const {
  return std::any_of(leaves_.begin(), leaves_.begin() + std::ptrdiff_t(count_),
                     [](const Leaf& leaf) { return leaf.branches.crowded; });
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
