#pragma once
// A named run of numbers in the face vector, and what kind of numbers they are.

#include <mien/api.h>

#include <span>
#include <string>
#include <string_view>

namespace mien {

/// What a slice's numbers mean; decides their unit, their range, their rule, and what a mirror does
/// to them.
enum class SliceKind : unsigned char {
  point,     ///< x, y
  shift,     ///< x, y of a way: added to a point
  length,    ///< one or more lengths >= 0: radii, half-widths
  ratio,     ///< one or more plain numbers >= 0: chord distances in radii
  angle,     ///< degrees, counted from +x towards +y
  frame,     ///< k, k0 of q = k·x + k0: the seed's frame of a parabola
  parabola,  ///< a, b of y = a·q² + b
  color      ///< linear red, green, blue, and opacity
};

/// What becomes of a number that a pose has pushed out of its range [lo, hi].
enum class Rule : unsigned char {
  free,   ///< it may go anywhere
  clamp,  ///< the nearer end
  wrap    ///< counted on from the other end; hi itself becomes lo
};

struct Slice {
  std::string name;  ///< "brow.left/spine/1": feature, part, index
  SliceKind kind = SliceKind::point;
  int begin = 0;  ///< of its numbers in the face vector
  int size = 0;
  double lo = 0, hi = 0;  ///< range of every number; infinite where free
  Rule rule = Rule::free;
};

/// Kind in words: "point", "length", …
MIEN_API std::string_view kind_name(SliceKind kind);

/// Unit of a slice's numbers; `length_unit` is the canvas's.
MIEN_API std::string unit_name(SliceKind kind, std::string_view length_unit);

/// Names of the numbers of a slice: "x" "y", "r" "g" "b" "a", else "0" "1" …
MIEN_API std::string component_name(SliceKind kind, int index);

/// Mirrors a slice's numbers about the line x = twice_axis / 2, in place.
MIEN_API void mirror_values(SliceKind kind, std::span<double> values, double twice_axis);

/// The same for differences of such numbers.
MIEN_API void mirror_differences(SliceKind kind, std::span<double> values, double twice_axis);

}  // namespace mien
