#pragma once
// Pictures of how a picture is drawn, for people who want to see what it costs and why.

#include <mien/api.h>
#include <mien/render.h>

namespace mien {

enum class DebugPicture : unsigned char {
  /// Every piece of outline on black, each outline in its own colour. Ends of pieces are white.
  outlines,
  /// The regions between outlines, each in its own colour.
  regions,
  /// Visible stretches of outline. The more the colour changes across one, the brighter it is; hidden
  /// pieces are dim.
  fragments,
  /// Regions by their looks: those that look alike share a colour. White dots mark varying colours.
  looks,
  /// The signed distance to the layer with the nearest outline: blue inside, orange outside, a darker line
  /// every 10 pixels, white on the outline.
  distance,
  /// The surface's normal where the topmost layer has a relief. x, y and z in −1 … 1 become red, green and
  /// blue in 0 … 255, y up. Everything else is level: (128, 128, 255).
  normals
};

/// 8 bits, whatever `how.depth` is; the share that progress is told stays 0. Errors: a limit by its name; cancelled.
MIEN_API Expected<Image> debug_picture(const Scene& scene, const View& view, DebugPicture which,
                                       const RenderOptions& how = {});

}  // namespace mien
