#pragma once
// Linear least squares within bounds.

#include <cstddef>
#include <vector>

namespace mien {

/// The x, lo <= x <= hi, that makes |A x − right|² + damping |x|² least.
struct BoundedLeastSquares {
  std::vector<double> columns;  ///< A, column by column
  std::size_t rows = 0;
  std::vector<double> right;   ///< rows numbers
  std::vector<double> lo, hi;  ///< a number for each column, lo <= hi
  double damping = 0;          ///< >= 0
};

/// Active sets (Stark and Parker, "Bounded-variable least-squares", Computational Statistics 10, 1995):
/// variables stand at a bound or are free; free ones are solved for by a QR decomposition (Eigen), the
/// first that would leave its bounds stops there; then the one at a bound that wants to move most is
/// set free. Ends at the optimum, after some tens of solves, but after 20 for each variable at the
/// latest; never outside the bounds.
std::vector<double> solve(const BoundedLeastSquares& problem);

}  // namespace mien
