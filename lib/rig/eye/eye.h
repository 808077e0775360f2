#pragma once
// Eyes at work: lids follow the gaze, blink, carry what rides on them, and give way to the cornea.

#include <mien/face.h>
#include "lib/rig/eye/bulge.h"
#include "lib/rig/eye/lid.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace mien {

/// The pushes that are contained in the lids of one eye as they are drawn, upper then lower, for what they were found
/// of. Finding them takes a root a bend, and faces in motion ask for the same ones frame by frame.
struct DrawnPushes {
  EyeBody body{};
  std::array<LidBends, 2> drawn{};
  std::array<LidBends, 2> pushes{}, again{};  ///< by the root; and by the law at the place it tells
};

/// Lets every eye of the model act on `vector`.
///   rest     the vector at rest
///   values   of the model's channels, in range
///   memory   what was found for the pose before; of the same face, or empty
///
/// In this order, for each eye: the lids' middles follow the gaze by their shares; lids that poses have
/// crossed are uncrossed; the blink closes them where the bias puts them; crease and riders follow the lids; the
/// cornea pushes the edges. The face at rest is drawn with its bulge. So an edge is shifted by the present
/// push less the push at rest, and the latter closes with the lids: at rest every shift is 0, and shut lids
/// are one curve.
void pose_eyes(const FaceModel& model, const FaceVector& rest, std::span<const double> values,
               FaceVector& vector, std::vector<DrawnPushes>& memory);

/// Writes the slices of an eye's dome for a gaze.
void put_dome(const FaceModel& model, const Eye& eye, glm::dvec2 gaze, FaceVector& vector);

/// An eye's body, by the numbers of a vector.
EyeBody eye_body(const FaceModel& model, const Eye& eye, const FaceVector& vector);

/// The shift of an eye's iris from its rest, by the channels' values.
glm::dvec2 gaze_of(const Eye& eye, std::span<const double> values);

/// The values of an eye's gaze channels with which it looks at `target`; see gaze_shift.
glm::dvec2 look_at(const FaceModel& model, const Eye& eye, const FaceVector& vector,
                   glm::dvec3 target);

}  // namespace mien
