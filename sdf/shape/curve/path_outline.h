#pragma once
// The outline of a path whose loops overlap.

#include <mien/shape.h>

#include <optional>

namespace mien {

/// The outline of a path filled by the nonzero rule, as far as it is seen: loops that do not cross, with the inside to
/// their left, of the pieces of its sides that have the inside on one hand and the outside on the other. They enclose
/// what the path does. Distances to the path, offsets and feet are meant from here.
///
/// None where the path itself is that: all sides of it are outline; it is filled by the even-odd rule, by which sides
/// that cross are; it has no inside; or its sides meet more than kMostMeetings times.
///
/// Method. Sides are cut where they meet: where they cross, and at ends of one on another. Places nearer to each other
///   than a tolerance, 2⁻⁴² of the largest coordinate, are one. Winding numbers beside the middles of the pieces tell
///   which are outline; between two meetings of a loop one is enough. If what is left is not closed everywhere, as
///   where sides run within a few tolerances of each other, it is done again with a larger one, of 2⁻²⁶ at most.
std::optional<Path> visible_outline(const Path& path);

/// Ends on sides and crossings of a path.
inline constexpr std::size_t kMostMeetings = 1 << 12;

}  // namespace mien
