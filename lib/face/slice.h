#pragma once
// Slices: named runs of numbers in the face vector, each of one kind.

#include <mien/api.h>

#include <span>
#include <string>
#include <string_view>

namespace mien {

/// The meaning of a slice's numbers. It decides their unit, range and rule, and how a mirror changes
/// them.
enum class SliceKind : unsigned char {
  point,     ///< x, y
  shift,     ///< x, y of an offset that is added to a point
  length,    ///< one or more lengths >= 0: radii, half-widths
  ratio,     ///< one or more plain numbers >= 0: chord distances in radii
  angle,     ///< degrees, counted from +x towards +y
  frame,     ///< k, k0 of q = k·x + k0: the seed's frame of a parabola
  parabola,  ///< a, b of y = a·q² + b
  color      ///< linear red, green, blue, and opacity
};

/// What happens to a number that a pose has moved out of its range [lo, hi].
enum class Rule : unsigned char {
  free,   ///< nothing
  clamp,  ///< it becomes the nearer end
  wrap    ///< it continues from the other end; hi itself becomes lo
};

/// What the numbers of a kind can be.
struct SliceRange {
  double lo, hi;  ///< of every number; infinite if free
  Rule rule;
};
MIEN_API SliceRange range_of(SliceKind kind);

struct Slice {
  std::string_view name;  ///< "brow.left/spine/1": feature, part, index; its layout keeps it
  SliceKind kind = SliceKind::point;
  int begin = 0;  ///< its first number in the face vector
  int size = 0;

  SliceRange range() const { return range_of(kind); }
};

/// The name of a kind: "point", "length", …
MIEN_API std::string_view kind_name(SliceKind kind);

/// The unit of a slice's numbers; `length_unit` is the canvas's.
MIEN_API std::string unit_name(SliceKind kind, std::string_view length_unit);

/// The name of a number in a slice: "x" "y", "r" "g" "b" "a", or "0" "1" …
MIEN_API std::string component_name(SliceKind kind, int index);

/// Mirrors a slice's numbers about the line x = twice_axis / 2, in place.
MIEN_API void mirror_values(SliceKind kind, std::span<double> values, double twice_axis);

/// The same for differences of such numbers.
MIEN_API void mirror_differences(SliceKind kind, std::span<double> values, double twice_axis);

}  // namespace mien
