#pragma once
// How a rectangle lies on the bevelled border of a square tile.

#include <array>

namespace mien {

/// Areas of the rectangle [u0, u1] × [v0, v1] inside a tile [0, side]² (v down): on its flat middle,
/// and on the mitred slopes above, left, right and below, which are `bevel` wide, at most side/2.
///
/// Derivation.  The slope above is v < bevel, v < u < side − v: at height v its part of the rectangle
///   is min(u1, side − v) − max(u0, v), which is linear in v between u0, u1, side − u0 and side − u1,
///   so its integral is a sum of trapezia. The others are the same, turned. What is left is flat.
/// Error.  Rounding alone.
struct BevelAreas {
  double flat, above, left, right, below;
};
BevelAreas bevel_areas(double u0, double u1, double v0, double v1, double side, double bevel);

}  // namespace mien
