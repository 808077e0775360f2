#pragma once
// Face files as text, made by tests, and what reading them says.

#include <mien/face_file.h>

#include <string>

namespace mien::test {

/// A small face whose features, and whatever is to stand behind them, are given.
inline std::string face_with(const std::string& features, const std::string& rest = "") {
  return R"({"format": "mien-face", "format_version": 1, "canvas": {"x": [-1, 1], "y": [-1, 1], "y_axis": "up"},
"palette": {"skin": "#f7db9c", "black": [0, 0, 0]}, "background": "skin",
"features": [)" +
         features + "]" + rest + "}";
}

inline std::string said(const std::string& text, const FaceLimits& limits = {}) {
  const Expected<Face> face = read_face_text(text, "f", limits);
  return face ? "a face" : sentence(face.error());
}

}  // namespace mien::test
