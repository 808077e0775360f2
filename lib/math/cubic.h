#pragma once
// Real roots of a cubic, as good as its coefficients deserve.

#include <mien/api.h>

#include <array>

namespace mien {

/// Distinct real roots, ascending, a multiple one once. count −1: every number is a root.
struct Roots {
  int count = 0;
  std::array<double, 3> x{};
};

/// The real roots of a x³ + b x² + c x + d; lower degrees (a = 0, …) are solved too, all
/// coefficients 0 give count −1, a NaN or infinite coefficient gives count 0.
///
/// Method. The critical points split the line into at most three monotone pieces. A piece whose
/// ends
///   differ in sign holds one root: Newton from a start that is at most 22 % off (below), inside a
///   bracket that is halved, in the order of the floating-point numbers, whenever Newton is slow.
///   At most kMaxEvaluations evaluations per root, whatever the numbers. At a critical point m with
///   f(m) within rounding of 0 the root is taken as double and given once; at two such points as
///   triple.
/// Start. With r = sqrt(b² − 3ac) the cubic about m is f(m) ± r y² + a y³ exactly, so an outer root
/// is
///   at most min(sqrt(|f(m)|/r), cbrt(|f(m)/a|)) away from m, and a middle root, measured from the
///   nearer end, between 1 and sqrt(3/2) times sqrt(|f(m)|/r).
/// Error. A root found satisfies |f(x)| <= 4·2⁻⁵²·(|a x³| + |b x²| + |c x| + |d|): within 4
/// condition
///   units of a true one. No root is missed or invented whose sign change is larger than that.
///   Coefficients more than 2^1000 below the largest may count as 0.
/// Source. Derived here; tests/lib/math/cubic_test.cpp compares with binary128.
MIEN_API Roots solve_cubic(double a, double b, double c, double d);

/// The same for a x² + b x + c.
MIEN_API Roots solve_quadratic(double a, double b, double c);

struct CubicContract {
  static constexpr int kMaxEvaluations = 200;     ///< per root
  static constexpr double kConditionUnits = 4.0;  ///< of 2⁻⁵²
};

}  // namespace mien
