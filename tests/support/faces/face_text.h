#pragma once
// Face files as text, made by tests, and what reading them says.

#include <mien/face_file.h>

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
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

/// A face file that is refused.
struct BadFace {
  std::string text;  ///< with a ^ where the error is to be reported
  std::string said;  ///< after its line and column
};

/// "f:LINE:COLUMN" of the ^ in a text, which is taken out.
inline std::string take_mark(std::string& text) {
  const std::size_t at = text.find('^');
  if (at == std::string::npos) throw std::runtime_error("no mark in " + text);
  text.erase(at, 1);
  std::size_t line = 1, column = 1;
  for (std::size_t i = 0; i < at; ++i)
    if (text[i] == '\n')
      ++line, column = 1;
    else if ((text[i] & 0xC0) != 0x80)
      ++column;
  return "f:" + std::to_string(line) + ":" + std::to_string(column);
}

inline void expect_refused(std::span<const BadFace> table) {
  for (BadFace bad : table) {
    const std::string place = take_mark(bad.text);
    EXPECT_EQ(said(bad.text), place + bad.said) << bad.text;
  }
}

}  // namespace mien::test
