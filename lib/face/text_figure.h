#pragma once
// A line of text as a figure: its outline was made once, when the face was read.

#include <mien/letters.h>

#include <memory>
#include <string>

namespace mien {

/// A longer text is no line on a face; outlines take memory and time.
inline constexpr int kMostSignsOfText = 60, kMostSignsOfFace = 2000;

struct TextFigure {
  int center;  ///< the middle of the line, halfway up its capitals
  int height;  ///< of its capitals
  int tilt;    ///< angle of the line; 0 if the file has none: the head may roll
  std::string text;
  std::shared_ptr<const TextOutline> outline;
};

template <class Visit>
void for_each_slice(const TextFigure& f, Visit&& visit) {
  visit("center", f.center), visit("height", f.height), visit("tilt", f.tilt);
}

}  // namespace mien
