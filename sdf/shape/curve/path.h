#pragma once
// A path's inside: how often its loops go around a point.

#include <mien/shape.h>

namespace mien {

/// How often the loops wind around p, positive where they turn from +x towards +y. p on a side
/// counts to either of its two sides.
int winding(const Path& path, glm::dvec2 p);
int winding(const Path::Loop& loop, glm::dvec2 p);

/// Whether a winding number is inside.
inline bool is_inside(FillRule rule, int winding_number) {
  return rule == FillRule::nonzero ? winding_number != 0 : winding_number % 2 != 0;
}

/// Whether every side is outline: has inside on one hand and outside on the other all along. Then
/// the path's distance is exact inside too. Conservative: a path whose sides come so close that
/// their control triangles touch, other than at joints, is taken as overlapping.
bool is_simple(const Path& path);

}  // namespace mien
