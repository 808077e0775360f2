#pragma once
// How exact a picture is, pixel by pixel, and said with proof: not measured against anything.
//
//   const ErrorMap map = error_map(scene, {.width = 640, .height = 360});
//   map.worst        // no channel is off by more than so many levels of 255, rounding left out

#include <mien/api.h>
#include <mien/image.h>
#include <mien/parallel.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <vector>

namespace mien {

struct ErrorMap {
  int width = 0, height = 0;
  /// Levels of 255, rows from the top: bounds of |pixel − exact mean| before rounding, of the way the
  /// picture is drawn: outlines' tolerance along their length and what their order may be off by, each
  /// times the change of colour; what means of gradients neglect.
  std::vector<float> levels;
  bool unproven = false;  ///< some paints' means are estimates: light, gradients along a distance
  float worst = 0;

  /// As grey: black 0, white `worst` (or all black).
  Image image() const;
};

/// The bounds of the picture that render() draws at a depth.
MIEN_API ErrorMap error_map(const Scene& scene, const View& view, Depth depth = Depth::u8,
                            const Threads& threads = {});

}  // namespace mien
