#pragma once
// How lines of text become outlines, for faces that have text in them. mien::text gives it by <mien/face_letters.h>:
//
//   const auto face = mien::read_face("jersey.face.json", {}, nullptr, mien::shipped_letters());
//
// Without letters a face with text in it is refused.

#include <mien/expected.h>
#include <mien/quad_bezier.h>

#include <functional>
#include <string_view>
#include <vector>

namespace mien {

/// A line of text whose capitals are 1 high, y up. Its middle is at the origin: halfway along the line, halfway up its
/// capitals.
struct TextOutline {
  std::vector<std::vector<QuadBezier>> loops;  ///< closed, filled by the nonzero rule
  double width = 0;                            ///< of the line
};

/// The outline of UTF-8, or a sentence why there is none.
using Letters = std::function<Expected<TextOutline>(std::string_view text)>;

}  // namespace mien
