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

/// Active sets (Stark and Parker, "Bounded-variable least-squares", Computational Statistics 10, 1995).
/// Each variable is either fixed at a bound or free. The free ones are solved for by a QR decomposition
/// (Eigen); the first that would leave its bounds is fixed there. Then the fixed variable that is pulled
/// off its bound most strongly is freed. This ends at the optimum, usually after some tens of solves; it
/// stops after 20 per variable at the latest. Variables never leave their bounds.
std::vector<double> solve(const BoundedLeastSquares& problem);

}  // namespace mien
