#pragma once

#include <array>

namespace mien {

/// Distinct real roots, ascending, a multiple one once. count −1: every number is a root.
struct QuarticRoots {
  int count = 0;
  std::array<double, 4> x{};
};

/// The real roots of a x⁴ + b x³ + c x² + d x + e; lower degrees (a = 0, …) are solved too. A NaN
/// or infinite coefficient gives count 0.
///
/// Method and error as solve_cubic's: monotone pieces between the derivative's roots, bracketed
/// Newton, roots within rounding of a critical point are taken as double; |f(x)| <= 4·2⁻⁵²·(sum of
/// |terms|).
QuarticRoots solve_quartic(double a, double b, double c, double d, double e);

}  // namespace mien
