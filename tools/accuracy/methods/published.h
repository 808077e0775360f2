#pragma once
// Methods that others have published, written here from what they published, to stand beside mien's kernels:
// docs/solvers.md.

#include "tools/accuracy/solver.h"

namespace mien::accuracy {

/// Each in float and in double. They promise nothing, so they have no bar; an error is counted in the roundings of the
/// arithmetic, as for mien's own.
std::vector<Solver> published_methods();

}  // namespace mien::accuracy
