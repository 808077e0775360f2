#pragma once
// Where a band's two outlines meet, and which of its pieces survive.

#include <mien/shape.h>

#include <array>
#include <glm/vec2.hpp>

namespace mien {

/// Points where the two parabolas of a band cross or touch: at most 4.
struct BandCorners {
  int count = 0;
  std::array<glm::dvec2, 4> point{};
};

BandCorners corners(const Band& band);

/// Whether no point is inside both parabolas. A band that only touches itself in a point is not
/// empty.
bool is_empty(const Band& band);

}  // namespace mien
