#pragma once
// What becomes of distances when areas combine.
//
//   unite       min(a, b)     exact outside if both are; inside a bound
//   intersect   max(a, b)     exact inside if both are; outside a bound
//   subtract    max(a, −b)    as intersect, with b's inside and outside swapped
//   complement  −a            inside and outside swapped
//   offset      a − amount    outside as a outside; inside exact only if a is exact there and amount >= 0 …
//   shell       |a| − amount  … see combine_exactness
//
// All keep the sign, the outline and the Lipschitz bound 1 of what they are given.

#include <mien/op.h>
#include <mien/shape.h>

#include <algorithm>
#include <cmath>

namespace mien {

/// The distance of the combined area. For one operand give it twice.
inline double combine(Op op, double a, double b, double amount) {
  switch (op) {
    case Op::shape:
      return a;
    case Op::unite:
      return std::min(a, b);
    case Op::intersect:
      return std::max(a, b);
    case Op::subtract:
      return std::max(a, -b);
    case Op::complement:
      return -a;
    case Op::offset:
      return a - amount;
    case Op::shell:
      return std::abs(a) - amount;
  }
  return a;
}

/// What that distance promises. A min is the distance to the nearer of two outlines: outside the
/// union both are its outline, inside pieces of them are hidden. The level set at `amount` of an
/// exact distance is at exactly that distance from everything farther out on the same side, so
/// growing keeps the outside exact and shrinking the inside; the other side has lost the corners it
/// would need.
inline Exactness combine_exactness(Op op, Exactness a, Exactness b, double amount) {
  switch (op) {
    case Op::shape:
      return a;
    case Op::unite:
      return {a.outside && b.outside, false};
    case Op::intersect:
      return {false, a.inside && b.inside};
    case Op::subtract:
      return {false, a.inside && b.outside};
    case Op::complement:
      return {a.inside, a.outside};
    case Op::offset:
      return {a.outside && amount >= 0, a.inside && amount <= 0};
    case Op::shell:
      return {a.outside && a.inside && amount >= 0, false};
  }
  return {false, false};
}

}  // namespace mien
