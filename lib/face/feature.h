#pragma once
// What a face draws, as plain data. Every number is a slice of the face vector, given here by its index in
// the layout. So whatever moves the vector moves the feature, and two features may share a point.

#include <mien/index.h>
#include <mien/pattern.h>
#include <mien/side.h>
#include <mien/text_figure.h>

#include <string_view>
#include <variant>
#include <vector>

namespace mien {

/// Between two parabolas: lower.a q² + lower.b <= y <= upper.a q² + upper.b, with q = k x + k0.
struct BandFigure {
  int frame, lower, upper;
};

struct EllipseFigure {
  int center, radii;
  int tilt;  ///< angle of radii.x; −1: none
};

struct DiscFigure {
  int center, radius;
};

/// A disc cut by two level chords, `chords` = (upper, lower) radii above and below its centre.
struct CutDiscFigure {
  int center, radius, chords;
};

/// A pen line along a quadratic Bézier; half_width holds one number, or three (Bernstein coefficients).
/// A line along the edge of a lid bends with the edge: `shifts` is the first of that edge's slices
/// (OpeningFigure), −1: none.
struct StrokeFigure {
  int spine[3];
  int half_width;
  int shifts = -1;
};

/// A pen line through points, with round caps and joins.
struct PolylineFigure {
  std::vector<int> points;  ///< at least 1
  int half_width;           ///< one number, or one for each point
  bool smooth = false;      ///< a smooth curve through the points instead of straight lines
};

/// Closed outlines through and towards points.
struct PathFigure {
  struct Node {
    int point;
    bool bend;  ///< the outline bends towards it (a control point) instead of passing through it
  };
  struct Loop {
    std::vector<Node>
        nodes;  ///< at least 3; between two bends in a row the outline passes their midpoint
  };
  std::vector<Loop> loops;
  bool even_odd = false;
};

/// A rectangle with round corners.
struct RoundedFigure {
  int center, radii;  ///< half its width and height
  int corner;         ///< the radius of its corners; at most the smaller of `radii` counts
  int tilt;           ///< angle of radii.x; −1: none
};

struct Feature;

/// The areas of EARLIER features, clips and all: inside all of `all`, any of `any` and none of `minus`. `grow` is how far
/// its outline lies outside of what these make: of a union that is the offset of the whole, without seams.
struct AreaFigure {
  std::vector<Index<Feature>> all, any, minus;  ///< `all` or `any` is not empty
  int grow = -1;                                ///< slice; −1: its outline is theirs
};

/// The opening of an eye: the area between the lid edges inner → upper → outer and outer → lower →
/// inner, two quadratic Béziers that share the canthi (the eye's corners) exactly.
///
/// A lid that the cornea pushes needs more than one bend. Each edge is then divided into kLidBends parts of
/// equal parameter length, a smooth chain of bends whose outline passes halfway between two, and each bend
/// has a shift. `shifts` is the first of 2 · kLidBends consecutive slices: those of the upper edge from
/// inner to outer, then those of the lower edge from inner to outer; −1: none. While all are 0 the edges are
/// the two plain curves.
struct OpeningFigure {
  static constexpr int kLidBends = 8;
  int inner, upper, outer, lower;
  int shifts = -1;
};

struct FaceGroup;
struct FaceRelief;
struct FaceSurroundings;
struct GradientPaint;

using Figure = std::variant<BandFigure, EllipseFigure, DiscFigure, CutDiscFigure, StrokeFigure,
                            PolylineFigure, PathFigure, OpeningFigure, RoundedFigure, AreaFigure,
                            ScatterFigure, RepeatFigure, StripesFigure, TextFigure>;

/// Where a feature is drawn: inside the area of an EARLIER one, or outside of it.
struct FeatureClip {
  Index<Feature> feature;
  bool outside = false;
};

/// Something to draw or, without paint, an area that other features are clipped to.
struct Feature {
  std::string_view name;  ///< "iris.left"; the model's names keep it
  Side side = Side::none;
  Figure figure;
  int paint = -1;                        ///< slice of its colour; −1: not drawn
  std::vector<FeatureClip> clips;        ///< it is drawn where all of them let it
  Index<GradientPaint> gradient;         ///< with one, `paint` is −1
  Index<FaceRelief> relief;              ///< none: not lit
  Index<FaceSurroundings> surroundings;  ///< what is drawn around it
  int feather = -1;        ///< slice: how far inside its outline it is full; −1: at once
  int opacity = -1;        ///< slice of what multiplies the paint's opacity; −1: 1
  Index<FaceGroup> group;  ///< drawn with its group

  bool painted() const { return paint >= 0 || gradient; }
};

/// Visits every slice of a figure as (part, index in the layout), in the order of the file format.
template <class Visit>
void for_each_slice(const BandFigure& f, Visit&& visit) {
  visit("frame", f.frame), visit("lower", f.lower), visit("upper", f.upper);
}
template <class Visit>
void for_each_slice(const EllipseFigure& f, Visit&& visit) {
  visit("center", f.center), visit("radii", f.radii);
  if (f.tilt >= 0) visit("tilt", f.tilt);
}
template <class Visit>
void for_each_slice(const DiscFigure& f, Visit&& visit) {
  visit("center", f.center), visit("radius", f.radius);
}
template <class Visit>
void for_each_slice(const CutDiscFigure& f, Visit&& visit) {
  visit("center", f.center), visit("radius", f.radius), visit("chords", f.chords);
}
template <class Visit>
void for_each_slice(const StrokeFigure& f, Visit&& visit) {
  for (const int point : f.spine) visit("spine", point);
  visit("half_width", f.half_width);
}
template <class Visit>
void for_each_slice(const PolylineFigure& f, Visit&& visit) {
  for (const int point : f.points) visit("points", point);
  visit("half_width", f.half_width);
}
template <class Visit>
void for_each_slice(const PathFigure& f, Visit&& visit) {
  for (const PathFigure::Loop& loop : f.loops)
    for (const PathFigure::Node& node : loop.nodes) visit("points", node.point);
}
template <class Visit>
void for_each_slice(const OpeningFigure& f, Visit&& visit) {
  visit("inner", f.inner), visit("upper", f.upper), visit("outer", f.outer),
      visit("lower", f.lower);
  if (f.shifts >= 0)
    for (int i = 0; i < 2 * OpeningFigure::kLidBends; ++i)
      visit(i < OpeningFigure::kLidBends ? "upper_shift" : "lower_shift", f.shifts + i);
}
template <class Visit>
void for_each_slice(const RoundedFigure& f, Visit&& visit) {
  visit("center", f.center), visit("radii", f.radii), visit("corner", f.corner);
  if (f.tilt >= 0) visit("tilt", f.tilt);
}
/// Its other numbers are those of other features.
template <class Visit>
void for_each_slice(const AreaFigure& f, Visit&& visit) {
  if (f.grow >= 0) visit("grow", f.grow);
}
template <class Visit>
void for_each_slice(const Figure& figure, Visit&& visit) {
  std::visit([&](const auto& f) { for_each_slice(f, visit); }, figure);
}

}  // namespace mien
