#pragma once
#include <glm/vec2.hpp>

namespace mien {

/// An ellipse with its inside. A radius of 0 leaves a segment or a point.
struct Ellipse {
  glm::dvec2 center;
  glm::dvec2 radii;           ///< >= 0, along `axis` and across it
  glm::dvec2 axis{1.0, 0.0};  ///< unit vector along radii.x
};

}  // namespace mien
