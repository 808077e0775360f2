#pragma once
// What a figure of a posed face covers, by straight sides: enough to ask what lies where.

#include <mien/box2.h>
#include <mien/face.h>
#include <mien/feature.h>
#include "lib/geom/polygon.h"

#include <vector>

namespace mien {

/// A place of a pen line.
struct PenSample {
  glm::dvec2 at;
  double half_width;
};

struct FlatArea {
  std::vector<Polygon> loops;  ///< of an area
  bool even_odd = false;
  std::vector<PenSample> pen;  ///< of a pen line
  Box2 box;                    ///< around all of it

  bool covers(glm::dvec2 p) const;
};

/// Straight sides for a curve. Of a head's bends, the largest curves there are, they cut off less
/// than 0.001 head widths.
inline constexpr int kSidesOfCurve = 8;

/// A shut opening has no loop. Bands, which only a few early faces have, cover nothing here.
FlatArea flat_area(const Figure& figure, const Face& face);

}  // namespace mien
