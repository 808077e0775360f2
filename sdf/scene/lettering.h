#pragma once
// How text becomes outlines, for functions that write into scenes. mien::text provides it in <mien/text_path.h>:
//
//   const Scene points = debug_points(face, mien::shipped_lettering());
//
// An empty Lettering writes nothing.

#include <mien/shape.h>

#include <functional>
#include <string_view>

namespace mien {

struct Lettering {
  /// A line of UTF-8 as one path; `size` is the font's em, `origin` the line's start on the baseline.
  std::function<Path(std::string_view text, double size, glm::dvec2 origin, bool y_up)> path;
  std::function<double(std::string_view text)> length;  ///< of the line, for a size of 1
  double ascent = 0.75, descent = 0.25;  ///< above and below the baseline, for a size of 1
};

}  // namespace mien
