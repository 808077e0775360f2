#pragma once
// Light on a relief, word for word as sdf/scene/paint.h defines it, at one place.

#include <mien/scene.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "tests/support/exact/exact_distance.h"

namespace mien::test {

/// How far apart distances are asked for whose difference is a slope: that is off by half of it times
/// the curvature, and by rounding, 10^-15 of the face over it.
inline constexpr double kSlopeStep = 1e-6;  // [px]

/// The steepest direction in which the distance of `area` grows and how much [per face unit].
glm::dvec2 distance_slope(const ExactDistance& distance, Area area, glm::dvec2 p, double step);

/// How much the surface rises at p per length along x and y of the face, `step` in face units.
glm::dvec2 surface_slope(const ExactDistance& distance, const Relief& relief, glm::dvec2 p,
                         double step);

/// What the law of Light makes of a straight colour in linear light; `slope`: x right, y UP.
glm::dvec3 lit(const glm::dvec3& color, glm::dvec2 slope, const Light& light, const Relief& relief);

/// Which clamps of the law hold there, by bits: where these change, colours have a kink.
unsigned clamps(const glm::dvec3& color, glm::dvec2 slope, const Light& light,
                const Relief& relief);

}  // namespace mien::test
