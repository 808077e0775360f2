#pragma once
// Where a function that cannot change fast changes sign: none is missed but pairs closer together
// than asked for.

#include <functional>
#include <vector>

namespace mien::test {

/// Adds to `out` where f changes sign between a and b; f changes by at most `lipschitz` per unit.
/// Two changes within `shortest` may be missed together.
void find_roots(const std::function<double(double)>& f, double lipschitz, double a, double b,
                double shortest, std::vector<double>& out);

}  // namespace mien::test
