#pragma once
// The ellipse's outline: how far p is from it, and where it is nearest.

#include <mien/api.h>
#include <mien/ellipse.h>

#include <glm/vec2.hpp>

namespace mien {

struct NearestOnEllipse {
  double distance;   ///< signed, negative inside; +infinity for a NaN or infinite coordinate
  glm::dvec2 point;  ///< on the outline; of two or more equally near ones, any
};

/// Method. By symmetry in the first quadrant, by the robust form of the foot's secular equation
/// (see
///   ellipse.cpp), then two Newton steps on the outline itself; the distance is the residual along
///   the outline's normal there. Exact circles, radius 0 and every ratio of the radii included.
/// Error. At most 4·2⁻⁵²·(|p − center| + the larger radius).
/// Source. Derived here, after Eberly's formulation of the problem; checked against binary128 in
///   tests/sdf/shape/round/ellipse_test.cpp.
MIEN_API NearestOnEllipse nearest(const Ellipse& ellipse, glm::dvec2 p);
MIEN_API double distance(const Ellipse& ellipse, glm::dvec2 p);

struct EllipseContract {
  static constexpr double kError = 4.0 * 0x1p-52;
};

}  // namespace mien
