#pragma once
// A face with a stroke of three points, a pose and a muscle: what other files are read for.

#include <mien/face_file.h>

namespace mien::fuzz {

inline constexpr char kSmallFace[] = R"({
  "format": "mien-face", "format_version": 1, "name": "small",
  "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up", "unit": "units"},
  "palette": {"ink": "#000000", "paper": "#ffffff"}, "background": "paper",
  "features": [{"name": "mouth", "kind": "polyline", "paint": "ink", "half_width": 0.05,
                "points": [[-0.5, 0], [0, -0.1], [0.5, 0]]}]
})";

inline const Face& small_face() {
  static const Face face = *read_face_text(kSmallFace);
  return face;
}

}  // namespace mien::fuzz
