#pragma once
// Real roots of a cubic, as accurate as its coefficients allow.

#include <mien/api.h>

#include <array>

namespace mien {

/// The distinct real roots, ascending; a multiple root counts once. count −1: every number is a root.
struct Roots {
  int count = 0;
  std::array<double, 3> x{};
};

/// The real roots of a x³ + b x² + c x + d. Lower degrees (a = 0, …) are solved too. If all
/// coefficients are 0, count is −1; if one is NaN or infinite, count is 0.
///
/// Method. The critical points split the line into at most three monotone intervals. An interval whose
///   ends differ in sign holds one root. Newton's method finds it from a start that is at most 22 % off
///   (see Start), inside a bracket. Whenever Newton is slow the bracket is bisected, by the order of the
///   floating-point numbers. No root takes more than kMaxEvaluations evaluations. If f(m) is within
///   rounding of 0 at a critical point m, the root is taken as double and returned once; at two such
///   points it is taken as triple.
/// Start. With r = sqrt(b² − 3ac) the cubic about m is exactly f(m) ± r y² + a y³. An outer root is
///   therefore at most min(sqrt(|f(m)|/r), cbrt(|f(m)/a|)) away from m. A middle root, measured from the
///   nearer end, is between 1 and sqrt(3/2) times sqrt(|f(m)|/r) away.
/// Error. Every root returned satisfies |f(x)| <= 4·2⁻⁵²·(|a x³| + |b x²| + |c x| + |d|), that is, it is
///   within 4 condition units of a true root. No root with a larger sign change is missed or invented.
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
