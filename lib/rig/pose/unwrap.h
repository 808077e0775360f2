#pragma once
// Unwrapping: every feature of a face travels to its place in a flat chart.
//
// Features that hang together (one clips the other, or they share a point) are one piece. The pieces lie in
// the chart's cells, row by row in drawing order, over the whole canvas, each made as small as its cell.
// Pieces with a band in them stay. With m the middle of the piece, c that of its cell and s its scale, a
// point p travels to c + s (p − m). At progress v it is at p + v (c + s (p − m) − p), and sizes have gone
// as far from themselves to s times themselves. All is linear in v, so w = 0 is the face, bit for bit, and
// w = 1 the whole chart.
//
//   linear    v = w
//   delayed   v = (w − r)/(1 − r), kept within 0 … 1, r = (z − d0)/(d1 − d0) the point's share of the
//             face's depth, from the deepest d0 to the nearest d1: the deep features leave first
//   sine      the sine of 90° times that: they brake
//
// The points and sizes of a feature's gradient and relief travel with it. Its surface flattens: heights are
// multiplied by 1 − v, so the normals, (−slope, 1) made unit, turn to face the viewer, and the chart is lit
// like a sheet of paper.
//
// For r → 1 the delayed progress is 0 until w = 1, and then 1: the last point arrives too.
//
// Source. S. Lee, "Face Rendering in GLSL", where the deepest point never moves; the chart by pieces
// is mien's own.

#include <mien/face.h>
#include <mien/unwrap_mode.h>

#include <glm/vec2.hpp>

#include <vector>

namespace mien {

/// How far a point at the share r of the depth has travelled at w; both 0 … 1. Rises with w.
double unwrap_progress(UnwrapMode mode, double w, double r);

/// Where everything in one face goes. Made once, from its rest.
class UnwrapChart {
 public:
  explicit UnwrapChart(const Face& rest);

  /// Moves `vector`. At w = 0, or a w that is not a number, nothing changes; above 1, w counts as 1.
  void act(UnwrapMode mode, double w, FaceVector& vector) const;

 private:
  void share_depths();

  struct Traveller {
    int begin = 0, size = 0;  ///< numbers in the vector
    bool point = false;       ///< else sizes
    glm::dvec2 from{}, to{};  ///< middles of the piece and of its cell
    double scale = 1;         ///< 0: flattened
    double share = 0;         ///< of the depth, 0 … 1; while the chart is made, the depth itself
  };
  std::vector<Traveller> travellers_;
};

}  // namespace mien
