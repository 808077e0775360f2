#pragma once
// The inner edges of the lips, and what jaw and lips do to them.

#include "lib/rig/mouth/closing.h"
#include "lib/rig/mouth/mouth_numbers.h"

#include <glm/vec2.hpp>

#include <array>
#include <optional>

namespace mien {

/// Two edges between two corners, with y up. Bends are left handle, middle, right handle.
struct LipLine {
  std::array<glm::dvec2, 2> corners{};  ///< left, right
  std::array<glm::dvec2, 3> upper{}, lower{};
  bool has_handles = false;

  LipPair pair(std::size_t bend) const { return {upper[bend], lower[bend]}; }
  void set(std::size_t bend, const LipPair& lips) {
    upper[bend] = lips.upper, lower[bend] = lips.lower;
  }
  friend bool operator==(const LipLine&, const LipLine&) = default;
};

/// The lower edge of the upper teeth, as three bends in a row: the curve runs from halfway to halfway.
struct TeethEdge {
  glm::dvec2 a, b, c;
  double y(double x) const;  ///< level beyond its ends
};

/// The measures of a mouth at rest.
struct MouthMeasures {
  double drop, width, seam;
};

/// Moves both edges. In this order: jaw and width, lifts, the corners of a round mouth, the room for a tongue that
/// shows, the lower lip on the upper teeth, and crossed lips brought together. They are not closed.
void shape_lips(const MouthNumbers& n, const MouthMeasures& measures,
                const std::optional<TeethEdge>& teeth, LipLine& line);

/// Closes all bends.
LipLine closed(LipLine line, double closure, double seam);

/// The length of an edge on one side (0 left, 1 right); without handles half of the whole.
double edge_length(const LipLine& line, bool upper, std::size_t side);

}  // namespace mien
