#pragma once
// Faces with what moves them drawn over them.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/scene.h>

#include <span>

namespace mien {

/// Every muscle as lines from its origin to the points it holds, from blue (hue 240°, not pulling) over
/// green to red (hue 0°, full pull); a legend of the scale, and the pull of each group, left and right
/// (M11).
///   pulls   of the model's muscles
MIEN_API Scene debug_muscles(const Face& posed, std::span<const double> pulls);

/// Every point of the face vector with its name: filled if the outline passes through it, a ring with
/// lines to its neighbours if it is a handle that the outline bends towards.
MIEN_API Scene debug_points(const Face& posed);

/// The colour of a pull: hue 240° … 0°, full saturation.
MIEN_API Color pull_color(double pull);

}  // namespace mien
