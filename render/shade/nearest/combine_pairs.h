#pragma once
// What becomes of branches and ridges when areas combine (sdf/csg/combine.h).

#include <mien/op.h>
#include "sdf/distance/feet/branches.h"

namespace mien {

/// What becomes of pairs when areas combine; `a` may be `to`. For one operand `b` is not read.
void combine_pairs(Op op, const BranchPair& a, const BranchPair& b, float amount, BranchPair& to);

}  // namespace mien
