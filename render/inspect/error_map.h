#pragma once
// Error bounds of every pixel of a picture. They are proven, not measured against another picture.
//
//   const Expected<ErrorMap> map = error_map(scene, {.width = 640, .height = 360});
//   map->worst       // no channel is off by more than this many levels of 255, before rounding

#include <mien/api.h>
#include <mien/render.h>

#include <cstdint>
#include <vector>

namespace mien {

struct ErrorMap {
  int width = 0, height = 0;
  /// Bounds of |pixel − exact mean| before rounding, for the way the picture is drawn; in levels of 255, rows
  /// from the top. They add the outlines' tolerance along their length and the possible error of their
  /// order, each times the change of colour, and what the means of gradients neglect.
  std::vector<float> levels;
  /// 1 where light, or a gradient along a distance, takes part: what its mean is off by is measured, not proven, and not
  /// in `levels`.
  std::vector<std::uint8_t> estimated;
  float worst = 0;

  long long estimated_pixels() const;

  /// The bounds as grey, from black for 0 to white for `worst`; all black if that is 0. What is estimated is half blue.
  Image image() const;
};

/// The bounds of the picture that render() draws so; the share that progress is told stays 0. Errors: a limit by its
/// name; cancelled.
MIEN_API Expected<ErrorMap> error_map(const Scene& scene, const View& view,
                                      const RenderOptions& how = {});

}  // namespace mien
