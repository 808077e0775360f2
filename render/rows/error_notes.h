#pragma once
// Where bounds of pixels' errors are written while a target is drawn.

#include <mien/view.h>

#include <cstddef>
#include <cstdint>

namespace mien {

struct ErrorNotes {
  PixelRect rect;           ///< of the picture, rows from the top
  float* levels;            ///< of 255
  std::uint8_t* estimated;  ///< 1: some of the pixel's mean is not proven

  std::size_t at(int x, int y) const {
    return std::size_t(y - rect.y) * std::size_t(rect.width) + std::size_t(x - rect.x);
  }
  float& level(int x, int y) const { return levels[at(x, y)]; }
  void estimate(int x, int y) const { estimated[at(x, y)] = 1; }
};

}  // namespace mien
