#pragma once
// Gaze: where an eye's iris stands when the eye looks at a point.
//
// The eye is a ball of radius R about C, seen straight from the front; at rest it looks straight
// ahead, +z, with its iris before its centre. Turned towards the point P its axis is
// ĝ = (P − C)/|P − C|, and the iris, on the ball's surface, appears moved by R (ĝx, ĝy). Two eyes
// that look at one near point so converge by themselves; at a far point their axes are parallel.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace mien {

/// How far the iris moves in the picture for an eye that looks at `target`.
///   centre, radius   the ball [face units]
///   reach            half-axes of the ellipse that the shift is kept in, towards the rest; larger
///                    than the radius counts as the radius
///   ->               shift [face units]
/// For a target behind the eye, the iris goes as far aside as the reach allows. A target at the centre, or
/// one that is not a number, gives no shift.
glm::dvec2 gaze_shift(glm::dvec3 center, double radius, glm::dvec2 reach, glm::dvec3 target);

/// A shift brought into an ellipse about 0, towards 0. Inside it keeps every bit.
glm::dvec2 within_reach(glm::dvec2 shift, glm::dvec2 reach);

/// The axis of an eye whose iris is moved by `shift`: unit, z >= 0.
glm::dvec3 gaze_axis(glm::dvec2 shift, double radius);

}  // namespace mien
