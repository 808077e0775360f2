#pragma once
// Patterns: many figures alike that are ONE feature, such as freckles, beads, stripes, hatching.
//
// The face vector holds where a pattern lies and how large a figure is, nothing more. Where each figure stands
// follows from that (sdf/from_face), so that whatever moves those few numbers moves all of them.

#include <cstdint>
#include <vector>

namespace mien {

/// All patterns of a face together have no more figures than this: drawing takes time and memory by the square of those
/// that lie over each other.
inline constexpr int kMostPatternFigures = 4000;

/// A Bézier patch: 2 or 3 rows of 2 or 3 points each. Its place u runs along the rows, v from the first row to
/// the last.
struct PatternPatch {
  std::vector<int> points;  ///< slices, row by row
  int columns = 2;

  int rows() const { return int(points.size()) / columns; }
};

/// What stands at each place: its sizes are slices. Its own direction is that of the pattern there.
struct PatternMark {
  enum class Kind : unsigned char { disc, ellipse, stroke } kind = Kind::disc;
  int size = -1;        ///< the radius, the radii, or the stroke's length
  int half_width = -1;  ///< of a stroke: 1 or 3 numbers
  int tilt = -1;        ///< from the pattern's direction, +x towards +y; −1: 0
};

/// What chance does to figures. All of it is keyed by the figure's number, and mirrors with the pattern.
struct PatternChance {
  std::uint32_t seed = 0;
  double jitter = 0;      ///< 0 … 1: how far they leave their places, in steps
  double vary = 0;        ///< 0 … 1: the smallest is this share smaller
  double sway = 0;        ///< [degrees] how far they are turned, either way
  bool mirrored = false;  ///< the pattern was written for the other side
};

/// Figures strewn over a patch.
struct ScatterFigure {
  PatternPatch patch;
  int columns = 1;       ///< without rows: how many figures in all
  int rows = 0;          ///< 0: strewn evenly without a lattice
  bool stagger = false;  ///< every other row of the lattice is shifted by half a step
  bool round = false;    ///< only in the ellipse that touches the patch's sides
  PatternMark mark;
  PatternChance chance;
};

/// Figures at equal steps along a line.
struct RepeatFigure {
  std::vector<int> points;  ///< at least 2
  bool smooth = false;      ///< a smooth curve through the points instead of straight lines
  int count = 1;
  PatternMark mark;
  PatternChance chance;
};

/// Pen lines along the rows of a patch, from its first row to its last.
struct StripesFigure {
  PatternPatch patch;
  int count = 1;
  int half_width = -1;  ///< 1 or 3 numbers
  PatternChance chance;
};

/// How many figures a pattern has, 1 for other features.
inline int figures_in(const ScatterFigure& f) {
  return f.rows > 0 ? f.columns * f.rows : f.columns;
}
inline int figures_in(const RepeatFigure& f) {
  return f.count;
}
inline int figures_in(const StripesFigure& f) {
  return f.count;
}
template <class Other>
int figures_in(const Other&) {
  return 1;
}

/// Visits every slice of a pattern as (part, index in the layout), in the order of the file format.
template <class Visit>
void for_each_slice(const PatternPatch& patch, Visit&& visit) {
  for (const int point : patch.points) visit("patch", point);
}
template <class Visit>
void for_each_slice(const PatternMark& mark, Visit&& visit) {
  constexpr const char* kSizes[] = {"radius", "radii", "length"};
  visit(kSizes[int(mark.kind)], mark.size);
  if (mark.half_width >= 0) visit("half_width", mark.half_width);
  if (mark.tilt >= 0) visit("tilt", mark.tilt);
}
template <class Visit>
void for_each_slice(const ScatterFigure& f, Visit&& visit) {
  for_each_slice(f.patch, visit), for_each_slice(f.mark, visit);
}
template <class Visit>
void for_each_slice(const RepeatFigure& f, Visit&& visit) {
  for (const int point : f.points) visit("points", point);
  for_each_slice(f.mark, visit);
}
template <class Visit>
void for_each_slice(const StripesFigure& f, Visit&& visit) {
  for_each_slice(f.patch, visit), visit("half_width", f.half_width);
}

}  // namespace mien
