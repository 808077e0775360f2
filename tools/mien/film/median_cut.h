#pragma once
// Groups of colours by how they look.

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace mien::command {

struct CountedColor {
  glm::vec3 lab;         ///< OKLab
  float count;           ///< how often it is there
  std::uint32_t packed;  ///< the caller's
};

/// Up to `most` colours out of many, such that the sum over all of count times the squared distance to the nearest chosen one
/// is small. `colors` come back in another order.
std::vector<CountedColor> chosen_colors(std::vector<CountedColor>& colors, int most);

}  // namespace mien::command
