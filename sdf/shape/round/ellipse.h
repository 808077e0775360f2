#pragma once
// Distance from a point to an ellipse, and the nearest point of its outline.

#include <mien/api.h>
#include <mien/ellipse.h>

#include <glm/vec2.hpp>

namespace mien {

struct NearestOnEllipse {
  double distance;   ///< signed, negative inside; +infinity for a NaN or infinite coordinate
  glm::dvec2 point;  ///< on the outline; any of them where several are equally near
};

/// Method. Symmetry reduces the problem to the first quadrant. The foot's secular equation is solved in
///   its robust form (see ellipse.cpp) and refined by two Newton steps on the outline itself. The
///   distance is the residual along the outline's normal. Circles, radius 0 and every ratio of the
///   radii are included.
/// Error. At most 4·2⁻⁵²·(|p − center| + the larger radius).
/// Source. Derived here, after Eberly's formulation of the problem; checked against binary128 in
///   tests/sdf/shape/round/ellipse_test.cpp.
MIEN_API NearestOnEllipse nearest(const Ellipse& ellipse, glm::dvec2 p);
MIEN_API double distance(const Ellipse& ellipse, glm::dvec2 p);

struct EllipseContract {
  static constexpr double kError = 4.0 * 0x1p-52;
};

}  // namespace mien
