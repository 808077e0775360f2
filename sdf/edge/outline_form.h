#pragma once
// A closed outline as sides of parabola and round ends, made ready for leaves: what a path is, and
// what a stroke of varying width becomes to a tolerance far below a pixel.

#include <mien/lib/geom/box2.h>
#include <mien/sdf/edge/curve_form.h>
#include <mien/sdf/shape/shape.h>

#include <array>
#include <optional>
#include <vector>

namespace mien {

/// A side of a closed outline; the loop's left is one winding number above its right.
struct OutlineSide {
  QuadBezier curve;
  ParabolaForm form;  ///< level 0, no stroke; lo, hi: the side alone
  bool forwards;      ///< the side runs towards the frame's +x
  glm::dvec2 begin, end;
  glm::dvec2 begin_way, end_way;  ///< unit tangents, the way the side runs
  Box2 box;
  int next, before;      ///< the sides that follow and precede in the loop
  int round_after = -1;  ///< the round end that lies between this side and the next, if any
  /// The form's reach with margins of kMargin, /2, /4 … : smaller leaves see less of the parabola
  /// beyond the side's ends.
  static constexpr int kReaches = 6;
  std::array<double, kReaches> reaches;
};

/// An arc of a circle from the end of one side to the begin of the next, turning left.
struct RoundEnd {
  glm::dvec2 center;
  double radius;
  int from, to;  ///< sides
};

struct OutlineForm {
  std::vector<OutlineSide> sides;
  std::vector<RoundEnd> ends;
  Path path;         ///< the same outline, to count windings: round ends are quadratic curves there
  double error = 0;  ///< [px] by which the sides may leave the shape's outline
};

/// Nothing where the shape is no closed outline or a side is too degenerate to say anything.
/// `tolerance`: see OutlineForm::error.
std::optional<OutlineForm> outline_form(const OffsetShape& shape, double tolerance);

/// The outline of the discs of a stroke of varying width as loops of quadratic sides: along its
/// right side, around its end, back along its left and around its begin. Nothing unless both sides
/// run forward all along, so that the winding number counts the discs' envelope sheets.
struct TaperedOutline {
  std::vector<QuadBezier> right, left;  ///< left runs from the end back to the begin
  double begin_radius, end_radius;
};
std::optional<TaperedOutline> tapered_outline(const TaperedStroke& stroke, double offset,
                                              double tolerance);

}  // namespace mien
