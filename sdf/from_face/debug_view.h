#pragma once
// Faces with the muscles or points that move them drawn over them.

#include <mien/face.h>
#include <mien/lettering.h>
#include <mien/scene.h>

#include <span>

namespace mien {

/// Every muscle as lines from its origin to the points it holds, from blue (hue 240°, not pulling) over
/// green to red (hue 0°, full pull); a legend of the scale, and the pull of each group, left and right
///.
///   pulls   of the model's muscles
Scene debug_muscles(const Face& posed, std::span<const double> pulls, const Lettering& letters);

/// Every point of the face vector with its name: filled if the outline passes through it, a ring with
/// lines to its neighbours if it is a handle that the outline bends towards.
Scene debug_points(const Face& posed, const Lettering& letters);

/// The colour of a pull: hue 240° … 0°, full saturation.
Color pull_color(double pull);

}  // namespace mien
