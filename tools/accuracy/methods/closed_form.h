#pragma once
// The closed form of most shaders: Cardano where the cubic has one root, the cosine of a third of an angle where it has
// three. As published, without care for curves that are straight, which divide by zero.
//
// Sources. R. W. D. Nickalls, "A new approach to solving the cubic: Cardan's solution revealed", The Mathematical
// Gazette 77 (1993), 354–359; for distances, I. Quilez, "Quadratic Bézier – distance 2D", 2018. Written from the
// formulas.

#include "tools/accuracy/methods/foot.h"

#include <numbers>

namespace mien::accuracy {

template <class T>
T closed_form(const QuadBezier& curve, T x, T y) {
  const FootEquation<T> f(curve, x, y);
  const T a = f.c2 / f.c3, b = f.c1 / f.c3, c = f.c0 / f.c3, third = a / 3;
  const T p = b - a * third, q = (2 * third * third - b) * third + c;
  const T disc = q * q / 4 + p * p * p / 27;
  if (disc >= 0) {
    const T root = std::sqrt(disc);
    return std::sqrt(f.square(std::cbrt(-q / 2 + root) + std::cbrt(-q / 2 - root) - third));
  }
  const T r = std::sqrt(-p / 3), angle = std::acos(-q / (2 * r * r * r)) / 3;
  const auto square_of = [&](int turn) {
    return f.square(2 * r * std::cos(angle - T(2 * turn) * std::numbers::pi_v<T> / 3) - third);
  };
  return std::sqrt(std::min({square_of(0), square_of(1), square_of(2)}));
}

}  // namespace mien::accuracy
