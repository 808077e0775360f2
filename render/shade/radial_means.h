#pragma once
// The places along a radial gradient of a pixel's cells, in lanes.

namespace mien {

/// A radial gradient around places: t = |U (p − center)|, with U's columns (ax, ay) and (bx, by).
struct RadialCells {
  double x, y;  ///< what the places are seen from
  double center_x, center_y;
  double ax, ay, bx, by;
  double trace;     ///< tr UᵀU
  double variance;  ///< of the area that each place stands for
};

/// Mean t at (x + dx, y + dy), as PaintField::mean: sqrt(|q|² + variance (trace − |∇t|²)), in doubles. Reads and writes
/// whole vectors.
void radial_means(const RadialCells& radial, const float* dx, const float* dy, int count, float* t);

}  // namespace mien
