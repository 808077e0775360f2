#pragma once
// Left and right are the SUBJECT's own: the left eye is on the right of a picture that faces us.

#include <string>
#include <string_view>

namespace mien {

enum class Side : unsigned char { none, left, right };

constexpr Side other(Side side) {
  return side == Side::left ? Side::right : side == Side::right ? Side::left : Side::none;
}

constexpr std::string_view side_name(Side side) {
  return side == Side::left ? "left" : side == Side::right ? "right" : "";
}

/// The feature "iris" of a side: "iris.left".
inline std::string feature_of_side(std::string_view name, Side side) {
  std::string sided{name};
  if (side != Side::none) sided.append(".").append(side_name(side));
  return sided;
}

/// The control "gaze.x" of a side: "gaze.left.x"; of "blink": "blink.left".
inline std::string control_of_side(std::string_view name, Side side) {
  const std::size_t dot = name.find('.');
  std::string sided = feature_of_side(name.substr(0, dot), side);
  if (dot != std::string_view::npos) sided += name.substr(dot);
  return sided;
}

}  // namespace mien
