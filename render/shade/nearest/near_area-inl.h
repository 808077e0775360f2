// What many places see of an area's leaves. Included once per instruction set.
#if defined(MIEN_RENDER_SHADE_NEAR_AREA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#undef MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#else
#define MIEN_RENDER_SHADE_NEAR_AREA_INL_H_
#endif

#include "lib/base/watch.h"
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

inline void EnterLeaf(NearArea& area, NearArea::Leaf& leaf, const NearBranches* from, float x,
                      float y, float r, NearBranches& to) {
  const Branches& b = leaf.branches;
  const std::uint64_t before = from ? from->near : b.all();
  to = b.stroke ? Narrowed<true>(b, before, x, y, r, leaf.feet)
                : Narrowed<false>(b, before, x, y, r, leaf.feet);
  area.feet += 3 * b.count;
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

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
