#pragma once
// Shapes made ready to be asked about many squares: relative to an origin, in float, with the slack
// that rounding needs. Everything is computed in double precision and rounded once.

#include <mien/sdf/batch/quad_bezier_frame.h>
#include <mien/sdf/edge/edge.h>

#include <glm/vec2.hpp>
#include <variant>
#include <vector>

namespace mien {

/// What each float form below may be wrong by: kRounding · (|x| + |y| + the form's `size`), where
/// size sums the magnitudes of its constants. Sixteen half-roundings of that; none of the forms has
/// more than ten on any path.
inline constexpr float kClassifyRounding = 0x1p-20f;

/// dot(p, normal) − offset.
struct HalfPlaneSquares {
  float nx, ny, offset, size;
};

/// along − bend·across², along and across the axis from the vertex.
struct ParabolaSquares {
  float x0, y0, ax, ay, bend, size;
};

/// 1 − u² − v², u = dot(p − center, (ux, uy)), v likewise.
struct EllipseSquares {
  float x0, y0, ux, uy, vx, vy;
  float u_slope, v_slope;  ///< 1 / radius
  float bend;              ///< 1 / (smaller radius)²
  float size;
};

/// The distance from a segment of this length and direction, less the half-width. A disc has length
/// 0.
struct SegmentSquares {
  float x0, y0, tx, ty, length, half_width, size;
};

/// The distance from a curve, less a half-width w0 + t (wa2 + t wb).
struct StrokeSquares {
  batch::QuadBezierFrame<float> curve;
  float w0, wa2, wb;  ///< w0 contains the offset
  float widest;       ///< largest half-width
  float keep;         ///< 1 − 2·(largest |dw| per length of spine); at most 0: unknown
  float size;
};

/// The distance from closed curves, its sign by winding.
struct PathSquares {
  Path path;  ///< relative to the origin
  std::vector<QuadBezier> sides;
  float size;
};

/// By the shape's own distance, one square after the other.
struct AnySquares {
  OffsetShape shape;
  glm::dvec2 origin;
};

using ClassifyFrame = std::variant<HalfPlaneSquares, ParabolaSquares, EllipseSquares,
                                   SegmentSquares, StrokeSquares, PathSquares, AnySquares>;

ClassifyFrame classify_frame(const OffsetShape& shape, glm::dvec2 origin);

}  // namespace mien
