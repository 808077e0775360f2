#pragma once
// How exact a picture is, pixel by pixel, and said with proof: not measured against anything.
//
//   const ErrorMap map = error_map(scene, {.width = 640, .height = 360});
//   map.worst        // no channel is off by more than so many levels of 255, rounding left out

#include <mien/lib/base/api.h>
#include <mien/lib/base/parallel.h>
#include <mien/render/image.h>
#include <mien/render/view/view.h>
#include <mien/sdf/scene/scene.h>

#include <vector>

namespace mien {

struct ErrorMap {
  int width = 0, height = 0;
  /// Levels of 255, rows from the top: bounds of |pixel − exact mean| before rounding. Where nothing
  /// better is proven a cell of a divided pixel counts with all of its area and any change of colour.
  std::vector<float> levels;
  float worst = 0;

  /// As grey: black 0, white `worst` (or all black).
  Image image() const;
};

/// The bounds of the exact path at a depth. What light on a relief makes of colours is not bounded:
/// only where they are.
MIEN_API ErrorMap error_map(const Scene& scene, const View& view, Depth depth = Depth::u8,
                            const Threads& threads = {});

}  // namespace mien
