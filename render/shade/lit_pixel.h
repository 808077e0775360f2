#pragma once
// A pixel, or a part of one, seen as 4 × 4 cells, and as 16 × 16 where that is not enough.

#include <mien/render/shade/lamp_lanes.h>
#include <mien/render/shade/lit_cells.h>
#include <mien/render/shade/near_feet.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace mien {

/// Keeps its scratch; one per thread.
class LitPixel {
 public:
  /// Where the pixels are asked for: the light and the feet around a tile's middle, and the zone.
  struct Place {
    const LampLanes* lamp;
    NearFeet* feet;  ///< none: nothing rises here
    float shallow, deep;
  };
  /// The mean of a whole pixel whose middle is `at` from the tile's.
  glm::vec3 whole(const Place& place, glm::vec2 at);
  /// That of a part, `centroid` from the pixel's middle.
  glm::vec3 part(const Place& place, glm::vec2 at, float area, glm::vec2 centroid);

 private:
  struct Cell {
    float x, y, side, area;  ///< centroid from the pixel's middle; area in pixels
    glm::vec3 color;
  };
  void see(const Place& place, glm::vec2 at, glm::vec2 from, float side, bool last);
  void see_all(const Place& place, glm::vec2 at);
  void cut(float area, glm::vec2 centroid);

  std::vector<Cell> seen_;
};

}  // namespace mien
