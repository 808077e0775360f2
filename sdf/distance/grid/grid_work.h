#pragma once
// distances_on_grid, saying how many of its tiles were certified: for tests and benches.

#include <mien/quad_bezier.h>

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

namespace mien::batch {

struct Grid {
  glm::dvec2 origin;
  double step;
  std::size_t columns, rows;
};

/// As the public function; returns how many tiles of 16 × 16 points (or less, at the border) needed no
/// root.
std::size_t distances_on_grid(const QuadBezier& curve, const Grid& grid, std::span<float> d);

}  // namespace mien::batch
