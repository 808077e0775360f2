#pragma once
// How long solvers take.

#include <vector>

#include "tools/accuracy/solver.h"

namespace mien::accuracy {

/// Nanoseconds per distance on quadratic curves, in calls of 256 points, a tile of 16 x 16 around each case's point, a
/// 1024th of the curve's size apart: the best of five runs over some cases. 0 where the solver takes none together.
double ns_per_point(const Solver& solver, const std::vector<Case>& cases);

}  // namespace mien::accuracy
