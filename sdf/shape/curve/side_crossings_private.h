#pragma once
// Where two sides of paths cross.

#include <mien/quad_bezier.h>

#include <array>

namespace mien {

/// Parameters of one point on both sides.
struct SideCrossing {
  double a, b;
};

/// Two parabolas have four points in common at most.
struct SideCrossings {
  int count = 0;
  std::array<SideCrossing, 4> at;
};

/// Points that two sides have in common, up to `tolerance`: all in which they cross, and some in which they touch.
/// None where they are one line or one parabola. A side that is straight has p1 halfway, and no other is a line.
///
/// Method. Put into the implicit form of one side, the other is a polynomial of its parameter, of degree 4 at most. In
///   Bernstein's form it has no root where its coefficients have one sign, so halving leaves a few short intervals.
///   Newton's method for both parameters starts in their middles.
SideCrossings side_crossings(const QuadBezier& a, const QuadBezier& b, double tolerance);

}  // namespace mien
