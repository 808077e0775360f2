#pragma once
// An area's distance inside a disc: the branches that can be nearest there, shape by shape, and how their distances
// combine. near_area-inl.h asks it for many places at once.

#include "render/shade/nearest/feet_area.h"
#include "sdf/distance/feet/branches.h"

#include <span>
#include <vector>

namespace mien {

class NearArea {
 public:
  struct Leaf {
    const PathTree* tree;
    Branches branches;
    BranchFeet feet;
  };

  /// From now on answers are for the disc around `middle`, a place of the picture.
  void narrow(const FeetArea& area, glm::dvec2 middle, double radius);

  /// Some shape has more branches there than sets hold, or none at all: nothing here is of use.
  bool crowded() const;

  std::span<const Node> nodes() const { return nodes_; }  ///< of Op::shape, `b` is the leaf
  std::span<Leaf> leaves() { return {leaves_.data(), count_}; }
  std::size_t leaf_count() const { return count_; }
  /// By node; scratch.
  std::vector<BranchPair>& pairs() { return pairs_; }

  /// Turns distances of sides that cross to negative ones inside, at places from the disc's middle.
  void sign_by_windings(const PathTree& tree, const float* x, const float* y,
                        BranchPair& pair) const;

  /// Feet that were looked for, of one branch at one place each.
  long long feet = 0;

 private:
  const FeetArea* area_ = nullptr;
  glm::dvec2 middle_{0.0};
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;  ///< more than `count_`: memory is kept
  std::size_t count_ = 0;
  std::vector<BranchPair> pairs_;
};

}  // namespace mien
