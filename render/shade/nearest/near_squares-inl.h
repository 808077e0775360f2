// Squares within squares: which of an area's nodes are asked there, and what many places see of them. Included once per
// instruction set.
#if defined(MIEN_RENDER_SHADE_NEAR_SQUARES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_NEAR_SQUARES_INL_H_
#undef MIEN_RENDER_SHADE_NEAR_SQUARES_INL_H_
#else
#define MIEN_RENDER_SHADE_NEAR_SQUARES_INL_H_
#endif

#include "render/shade/nearest/combine_pairs.h"
#include "render/shade/nearest/near_area-inl.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

/// Between what a leaf's distance at (x, y) lies. Of a path the key has no sign: it is that of the square before, which
/// no outline lies between, or is looked for where it matters.
inline NearArea::Range RangeOf(NearArea& area, NearArea::Leaf& leaf, const NearNode* from, float x,
                               float y, float r, NearNode& to) {
  const NearBranches& b = to.branches;
  to.side = 0;
  if (leaf.branches.stroke)
    to.side = 1;
  else if (from && from->branches.key > std::hypot(x - from->branches.x, y - from->branches.y))
    to.side = from->side;
  const float d = float(to.side) * b.key;
  if (to.side != 0) return {d, d};
  if (!(b.key > r)) return {-b.key, b.key};
  alignas(64) float px[BranchPair::kPlaces], py[BranchPair::kPlaces];
  std::fill(px, px + BranchPair::kPlaces, x), std::fill(py, py + BranchPair::kPlaces, y);
  BranchPair seen;
  LookAtLeaf(area, leaf, b, x, y, px, py, seen);
  to.side = seen.best.d[0] < 0.0f ? -1 : 1;
  return {seen.best.d[0], seen.best.d[0]};
}

/// Enters a square around (x, y) of half a diagonal r: which nodes are asked there and which branches matter, of those
/// in `from`; of all without one.
inline void EnterSquare(NearArea& area, const NearNode* from, float x, float y, float r,
                        NearNode* to) {
  const auto nodes = area.nodes();
  const auto branches_from = [&](size_t k) { return from ? &from[k].branches : nullptr; };
  if (nodes.size() == 1) {
    NearArea::Leaf& leaf = area.leaves()[0];
    to[0].asks = NearNode::Asks::both;
    if (from && from[0].branches.sure) {
      const NearBranches& known = from[0].branches;
      const int i = std::countr_zero(known.local);
      leaf.feet.x[i] = known.foot_x, leaf.feet.y[i] = known.foot_y;
      leaf.feet.t[i] = known.foot + (x - known.x) * known.foot_x + (y - known.y) * known.foot_y;
      to[0].branches = known;
    } else {
      EnterLeaf(area, leaf, branches_from(0), x, y, r, to[0].branches);
    }
    return;
  }
  worked(10 * std::int64_t(nodes.size()));
  for (size_t k = 0; k < nodes.size(); ++k) {
    to[k].asks = from ? from[k].asks : NearNode::Asks::both;
    if (to[k].asks == NearNode::Asks::nothing || nodes[k].op != Op::shape) continue;
    NearArea::Leaf& leaf = area.leaves()[size_t(nodes[k].b)];
    EnterLeaf(area, leaf, branches_from(k), x, y, r, to[k].branches);
    area.ranges()[k] = RangeOf(area, leaf, from ? &from[k] : nullptr, x, y, r, to[k]);
  }
  area.leave_out(r, to);
}

/// What sixteen places of the square around (cx, cy) see, which was entered last.
inline void LookAround(NearArea& area, const NearNode* which, float cx, float cy, const float* x,
                       const float* y, BranchPair& to) {
  const auto nodes = area.nodes();
  if (nodes.size() == 1)
    return LookAtLeaf(area, area.leaves()[0], which[0].branches, cx, cy, x, y, to);
  std::vector<BranchPair>& pairs = area.pairs();
  const auto answer = [&](int node) -> const BranchPair& {
    return pairs[area.deciding(which, size_t(node))];
  };
  const size_t last = area.deciding(which);
  for (size_t k = 0; k <= last; ++k) {
    const Node& n = nodes[k];
    BranchPair& made = k == last ? to : pairs[k];
    switch (which[k].asks) {
      case NearNode::Asks::both:
        if (n.op == Op::shape)
          LookAtLeaf(area, area.leaves()[size_t(n.b)], which[k].branches, cx, cy, x, y, made);
        else
          combine_pairs(n.op, answer(n.a), answer(n.b), float(n.amount), made);
        break;
      case NearNode::Asks::second:
        if (n.op == Op::subtract)
          combine_pairs(Op::complement, answer(n.b), answer(n.b), 0.0f, made);
        break;
      case NearNode::Asks::first:
      case NearNode::Asks::nothing:
        break;
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
