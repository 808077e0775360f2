#pragma once
// What is a shape's outline? Answered to a tolerance, in pixels, as pieces (outlines.h).
//
//   OutlineMaker maker;
//   maker.begin({grid_from_face, window, 1.0 / 800}, outlines);
//   const int head = maker.fill(shape);        // {distance <= 0}
//   const int line = maker.rim(shape, 0.01);   // {|distance| <= 0.01}
//
// Only single shapes are asked for: offsets of combinations are pushed down to shapes by
// AreaProgram (area_program.h), which asks for fills, rims and their combinations.

#include <mien/box2.h>
#include <mien/map.h>
#include "sdf/outline/area_program.h"
#include "sdf/outline/curve/side_list.h"
#include "sdf/outline/outline_loop.h"
#include "sdf/outline/outlines.h"

#include <optional>

namespace mien {

struct OutlineFrame {
  Map<GridSpace, FaceSpace> grid_from_face;
  /// [px] Inside it outlines are correct; beyond it they may be anything that leaves the winding numbers inside as
  /// they are.
  Box2 window;
  double tolerance;  ///< [px] how far a piece may leave the outline
};

/// Writes outlines one after the other; keeps its scratch. One per thread.
class OutlineMaker {
 public:
  /// Clears `to`, which must stay where it is until `finish`.
  void begin(const OutlineFrame& frame, Outlines& to);

  /// The outline of {distance(shape) <= 0}; its index. Shapes without area give an outline without
  /// pieces.
  int fill(const Shape& shape);

  /// What programs ask for: fills of shapes or of their offsets, of rows of strokes, or rims; its index.
  int add(const AreaPrograms& programs, const OutlineSource& source);

  /// The outline of {|distance(shape)| <= half_width} [face units, > 0], the ribbon along the shape's
  /// own outline; its index. A stroke that overlaps itself has no such outline: ask for its wider
  /// fill without its narrower one (offset_shape). A band without common points has no outline.
  int rim(const Shape& shape, double half_width);

  /// Nothing is added afterwards.
  void finish() { loop_.finish(); }

 private:
  struct Filler;
  struct Recorder;
  void ribbons(const Shape& shape, double width);

  Map<GridSpace, FaceSpace> map_;
  double scale_ = 1.0;
  OutlineLoop loop_;
  SideList list_;
  std::vector<glm::dvec2> points_;
  std::vector<QuadBezier> sides_;
};

/// {distance(shape) <= amount} as another shape, where there is one: discs, strokes, half-planes … grow by that
/// much. None where there is not (paths, ellipses, parabolas, …): then it is the fill united with the rim of that
/// half-width, or less the rim where `amount` < 0.
std::optional<Shape> offset_shape(const Shape& shape, double amount);

/// A stroke as a tapered one. None of another shape.
std::optional<TaperedStroke> tapered(const Shape& shape);

}  // namespace mien
