#pragma once
// The view: where face units land in pixels. Changing anything here changes the picture.

#include <mien/api.h>
#include <mien/map.h>
#include <mien/scene.h>

#include <glm/vec3.hpp>
#include <optional>

namespace mien {

enum class Fit {
  meet,  ///< the whole canvas, centred, with background around it
  slice  ///< the canvas covers the whole picture and is cropped where it is longer
};

/// The space in which colours are mixed: where edges cover part of a pixel, and where paints are translucent.
enum class Blend {
  linear,  ///< in linear light, as a lens does
  srgb     ///< in encoded values, as most drawing programs do
};

/// A rectangle of whole pixels; x points right and y down from the picture's top left corner.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

struct View {
  int width = 512, height = 512;  ///< [px] of the whole picture, 1 … kMaxSide
  Fit fit = Fit::meet;
  Blend blend = Blend::linear;
  /// Replaces the scene's; alpha 0 leaves the picture transparent.
  std::optional<Color> background = {};
  /// Draws only this part of the picture, with the same bytes as in the whole.
  std::optional<PixelRect> region = {};
  /// Replaces the scene's direction to the lamp: x right, y up, z > 0 to the viewer.
  std::optional<glm::dvec3> light = {};
  /// [px] The least width of lines (sdf/scene/legible.h): thinner ones are drawn wider, up to three times, or fade, as does
  /// what has hardly an area. For small pictures; 0: all as it is.
  double legible = 0;  ///< 0 … kMostLegible
  bool dither = true;  ///< dithers gradients and lit surfaces at 8 and 16 bits: see store_dithered

  static constexpr int kMaxSide = 1 << 20;
  static constexpr double kMostLegible = 16;
};

/// The similarity that maps a canvas into the view.
MIEN_API Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, const View& view);
/// The same into a picture of that size [px], which need not be whole.
MIEN_API Map<PixelSpace, FaceSpace> pixel_from_face(const Canvas& canvas, glm::dvec2 size, Fit fit);

/// The rectangle that will be drawn: the part of the region inside the picture, or everything.
MIEN_API PixelRect drawn_rect(const View& view);

}  // namespace mien
