#pragma once
// Where face units land in pixels. Changing anything here changes the picture.

#include <mien/api.h>
#include <mien/map.h>
#include <mien/scene.h>

#include <glm/vec3.hpp>
#include <optional>

namespace mien {

enum class Fit {
  meet,  ///< the whole canvas, centred, background beyond it
  slice  ///< the whole picture covered, the canvas cut off where it is longer
};

/// Colours are mixed where edges cover part of a pixel, and where paints are translucent.
enum class Blend {
  linear,  ///< in linear light: what a lens would do
  srgb     ///< in encoded values: what most drawing programs do
};

/// A rectangle of whole pixels, x right and y down from the picture's top left corner.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct View {
  int width = 512, height = 512;  ///< [px] of the whole picture, 1 … kMaxSide
  Fit fit = Fit::meet;
  Blend blend = Blend::linear;
  std::optional<Color>
      background;  ///< instead of the scene's; alpha 0 leaves the picture transparent
  std::optional<PixelRect>
      region;  ///< draw this part of the picture only; same bytes as in the whole
  std::optional<glm::dvec3>
      light;  ///< where the lamp is, instead of the scene's: x right, y up, z > 0 to the viewer
  bool dither = true;  ///< gradients and lit surfaces of 8 and 16 bits only: see store_dithered

  static constexpr int kMaxSide = 1 << 20;
};

/// The similarity that `view` means for a canvas.
MIEN_API Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, const View& view);

/// The rectangle that will be drawn: the region as far as it lies in the picture, or everything.
MIEN_API PixelRect drawn_rect(const View& view);

}  // namespace mien
