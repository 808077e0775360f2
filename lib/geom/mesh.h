#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace mien {

/// A surface of triangles: x right, y up, z towards the viewer.
struct Mesh {
  std::vector<glm::dvec3> points;
  std::vector<std::array<int, 3>> triangles;  ///< indices of points
};

}  // namespace mien
