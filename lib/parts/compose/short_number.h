#pragma once
// Numbers of composed faces as text.

#include "lib/file/json/json_text.h"

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include <cmath>
#include <string>

namespace mien {

/// To a millionth of a face, which is less than any picture shows: the text stays short.
inline std::string short_number(double value) {
  return json_number(std::round(value * 1e6) / 1e6 + 0.0);
}

/// "[x, y]"
inline std::string short_pair(glm::dvec2 p) {
  return fmt::format("[{}, {}]", short_number(p.x), short_number(p.y));
}

}  // namespace mien
