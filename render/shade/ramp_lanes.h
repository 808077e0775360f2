#pragma once
// Ramps between two kinks at many places at once: t there, and its colour.

namespace mien {

/// A radial gradient's places: q = (qx, qy) + (from + i) (sx, sy) in the frame where its t is |q|; the rows of that
/// frame's matrix are (ax, bx) and (ay, by).
struct RadialLanes {
  float qx, qy, sx, sy;
  float ax, ay, bx, by;
  float trace;     ///< tr UᵀU
  float variance;  ///< of the area that each place stands for
  int from;
};

/// Mean t of `count` places: sqrt(|q|² + variance (trace − |∇t|²)); writes whole vectors.
void radial_places(const RadialLanes& radial, int count, float* t);

/// A radial gradient around places: t = |U (p − center)|, with U's columns (ax, ay) and (bx, by).
struct RadialCells {
  double x, y;  ///< what the places are seen from
  double center_x, center_y;
  double ax, ay, bx, by;
  double trace;     ///< tr UᵀU
  double variance;  ///< of the area that each place stands for
};

/// The same at (x + dx, y + dy), in doubles; reads and writes whole vectors.
void radial_means(const RadialCells& radial, const float* dx, const float* dy, int count, float* t);

/// Premultiplied at + slope · t for t between `from` and `to`.
struct RampLanes {
  float at[4], slope[4];
  float from, to;
};

/// Lays the ramp's colours over those of four planes; whole vectors of all.
void lay_ramp(const RampLanes& ramp, const float* t, int count, float* r, float* g, float* b,
              float* a);

}  // namespace mien
