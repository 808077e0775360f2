#pragma once
// Outlines as pieces: closed loops of quadratic curves, each monotone in x and in y, on the grid of
// the whole picture's pixels (y down).
//
// An outline is what one winding number counts: it is inside where the sum over its loops is not 0,
// or odd (see FillRule). Neighbouring pieces share their vertex bit for bit, so loops are closed
// exactly and no rounding can open them.

#include <mien/shape.h>

#include <cmath>
#include <vector>

namespace mien {

/// Where two pieces of a loop meet. Coordinates are multiples of 2⁻²⁰ px.
struct OutlineVertex {
  double x, y;
  int in, out;  ///< the pieces that arrive and leave along the loop
};

/// The curve (x, y)(t) = (x0, y0) + t (2 (ax, ay) + t (bx, by)), t in [0, 1], from (x0, y0) to
/// (x1, y1). It runs down the picture: y0 <= y1, x0 < x1 where y0 == y1; its control point
/// (x0 + ax, y0 + ay) lies in the box of its ends, so x and y are monotone. A straight piece has
/// bx = by = 0 exactly.
struct OutlinePiece {
  double x0, y0, ax, ay, bx, by, x1, y1;
  int top, bottom;  ///< vertices: (x0, y0) and (x1, y1)
  int outline;      ///< whose winding number it changes
  int turn;         ///< winding number to its right minus that to its left: +1 or −1
};

/// Every vertex belongs to exactly two pieces (`in` and `out`), every piece to one loop.
struct Outlines {
  std::vector<OutlineVertex> vertices;
  std::vector<OutlinePiece> pieces;
  std::vector<FillRule> rules;  ///< by outline
  /// [px] Where outlines are cut. Except for level pieces, what runs along these sides stands for what lies beyond.
  double left = -HUGE_VAL, right = HUGE_VAL;

  void clear() { vertices.clear(), pieces.clear(), rules.clear(); }
};

}  // namespace mien
