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

/// Premultiplied at + slope · t for t between `from` and `to`.
struct RampLanes {
  float at[4], slope[4];
  float from, to;
};

/// Lays the ramp's colours over those of four planes; whole vectors of all.
void lay_ramp(const RampLanes& ramp, const float* t, int count, float* r, float* g, float* b,
              float* a);

}  // namespace mien
