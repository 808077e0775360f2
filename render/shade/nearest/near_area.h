#pragma once
// An area's distance inside a disc: the branches that can be nearest there, shape by shape, and how their distances
// combine. near_area-inl.h asks it for many places at once.

#include "render/shade/nearest/feet_area.h"
#include "sdf/distance/feet/branches.h"

#include <span>
#include <vector>

namespace mien {

/// A node of the area's tree, as it is asked in a square.
struct NearNode {
  /// Of an operator's operands the first or second alone where the other is farther all over the square.
  enum class Asks : unsigned char { both, first, second, nothing };
  Asks asks = Asks::both;
  /// Of a leaf, where its key was measured: 1 outside, −1 inside, 0 not known.
  signed char side = 0;
  NearBranches branches;  ///< of a leaf
};

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
  /// By node; scratch.
  std::vector<BranchPair>& pairs() { return pairs_; }

  /// A node's distances in a square lie between these.
  struct Range {
    float least, most;
  };
  std::vector<Range>& ranges() { return ranges_; }
  /// Leaves out of nodes whatever is farther than another all over a square of half a diagonal r, by the ranges() of
  /// their distances at its middle.
  void leave_out(float r, NearNode* nodes);
  /// The node whose distance this one's is all over the square: a leaf, or what has two operands there.
  std::size_t deciding(const NearNode* nodes, std::size_t node) const;
  std::size_t deciding(const NearNode* nodes) const { return deciding(nodes, nodes_.size() - 1); }

  /// Turns distances of sides that cross to negative ones inside, at places from the disc's middle.
  void sign_by_windings(const PathTree& tree, const float* x, const float* y,
                        BranchPair& pair) const;

  /// Feet that were looked for, of one branch at one place each.
  long long feet = 0;

 private:
  /// The range of an operator's distance, by those of its operands; and which of these may be nearest, if two are asked.
  /// `change`: how much they may change by within the square.
  Range decide(const Node& node, float change, NearNode::Asks& asks) const;

  const FeetArea* area_ = nullptr;
  glm::dvec2 middle_{0.0};
  std::vector<Node> nodes_;
  std::vector<Leaf> leaves_;  ///< more than `count_`: memory is kept
  std::size_t count_ = 0;
  std::vector<BranchPair> pairs_;
  std::vector<Range> ranges_;
  std::vector<char> needed_;
};

}  // namespace mien
