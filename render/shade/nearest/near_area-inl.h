// What many places see of an area. Included once per instruction set.
#if defined(MIEN_RENDER_SHADE_NEAR_AREA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#undef MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#else
#define MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#endif

#include "lib/base/watch.h"
#include "render/shade/nearest/combine_pairs.h"
#include "render/shade/nearest/near_area.h"
#include "sdf/distance/feet/feet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The feet seen from the disc's middle: first of all.
inline void FindFeetOf(NearArea& area) {
  for (NearArea::Leaf& leaf : area.leaves()) {
    if (leaf.branches.stroke)
      FindMiddleFeet<true>(leaf.branches);
    else
      FindMiddleFeet<false>(leaf.branches);
  }
}

/// Enters a square around (x, y) of half a diagonal r: which branches matter there, by leaf, of those in `from`; of
/// all without one.
inline void EnterSquare(NearArea& area, const NearBranches* from, float x, float y, float r,
                        NearBranches* to) {
  size_t k = 0;
  for (NearArea::Leaf& leaf : area.leaves()) {
    const Branches& b = leaf.branches;
    if (from && from[k].sure) {
      const NearBranches& known = from[k];
      const int i = std::countr_zero(known.local);
      leaf.feet.x[i] = known.foot_x, leaf.feet.y[i] = known.foot_y;
      leaf.feet.t[i] = known.foot + (x - known.x) * known.foot_x + (y - known.y) * known.foot_y;
      to[k++] = known;
      continue;
    }
    const std::uint64_t before = from ? from[k].near : b.all();
    to[k++] = b.stroke ? Narrowed<true>(b, before, x, y, r, leaf.feet)
                       : Narrowed<false>(b, before, x, y, r, leaf.feet);
    area.feet += 3 * b.count;
  }
}

inline void LookAtLeaf(NearArea& area, NearArea::Leaf& leaf, const NearBranches& which, float cx,
                       float cy, const float* x, const float* y, BranchPair& to) {
  area.feet += BranchPair::kPlaces * std::popcount(which.local);
  worked(BranchPair::kPlaces * (4 + 6 * std::popcount(which.local)));
  if (leaf.branches.stroke)
    LookAt<true>(leaf.branches, which.local, leaf.feet, cx, cy, x, y, to);
  else
    LookAt<false>(leaf.branches, which.local, leaf.feet, cx, cy, x, y, to);
  if (leaf.tree) area.sign_by_windings(*leaf.tree, x, y, to);
}

/// What sixteen places of the square around (cx, cy) see, which was entered last.
inline void LookAround(NearArea& area, const NearBranches* which, float cx, float cy,
                       const float* x, const float* y, BranchPair& to) {
  const auto nodes = area.nodes();
  if (nodes.size() == 1) return LookAtLeaf(area, area.leaves()[0], which[0], cx, cy, x, y, to);
  std::vector<BranchPair>& pairs = area.pairs();
  for (size_t k = 0; k < nodes.size(); ++k) {
    const Node& n = nodes[k];
    BranchPair& made = k + 1 == nodes.size() ? to : pairs[k];
    if (n.op == Op::shape)
      LookAtLeaf(area, area.leaves()[size_t(n.b)], which[n.b], cx, cy, x, y, made);
    else
      combine_pairs(n.op, pairs[size_t(n.a)], pairs[size_t(n.b)], float(n.amount), made);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
