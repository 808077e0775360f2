#include <mien/face_model.h>
#include "face_numbers_private.h"
#include "lib/rig/eye/lid.h"
#include "pattern_private.h"
#include "shape_private.h"
#include "smooth_curve_private.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>
#include <vector>

namespace mien {
namespace {

/// side · y >= side · (a q² + b), q = k x + k0, in the shape's own terms: vertex, axis, bend.
/// A frame that does not change along x (or so little that its vertex is nowhere) leaves a level
/// half-plane.
ParabolaSide parabola_side(double k, double k0, double a, double b, double side) {
  const double vertex = -k0 / k;
  if (!std::isfinite(vertex)) return {{0, a * k0 * k0 + b}, {0, side}, 0};
  return {{vertex, b}, {0, side}, side * a * k * k};
}

Shape shape(const BandFigure& f, const FaceNumbers& n) {
  const double k = n(f.frame, 0), k0 = n(f.frame, 1);
  return Band{parabola_side(k, k0, n(f.lower, 0), n(f.lower, 1), 1),
              parabola_side(k, k0, n(f.upper, 0), n(f.upper, 1), -1)};
}

Shape shape(const EllipseFigure& f, const FaceNumbers& n) {
  Ellipse ellipse{.center = n.point(f.center), .radii = n.point(f.radii)};
  ellipse.axis = n.way(f.tilt);
  return ellipse;
}

Shape shape(const DiscFigure& f, const FaceNumbers& n) {
  return Disc{n.point(f.center), n(f.radius)};
}

Shape shape(const CutDiscFigure& f, const FaceNumbers& n) {
  return CutDisc{.center = n.point(f.center),
                 .radius = n(f.radius),
                 .upper = n(f.chords, 0),
                 .lower = n(f.chords, 1),
                 .up = {0, n.sign_of_up()}};
}

Shape shape(const StrokeFigure& f, const FaceNumbers& n) {
  const QuadBezier spine{n.point(f.spine[0]), n.point(f.spine[1]), n.point(f.spine[2])};
  const int w = f.half_width;
  if (n.size(w) == 1) return QuadStroke{spine, n(w)};
  return TaperedStroke{spine, {n(w, 0), n(w, 1), n(w, 2)}};
}

Shape shape(const PolylineFigure& f, const FaceNumbers& n) {
  Polyline line{.points = {}, .half_width = n(f.half_width)};
  for (const int point : f.points) line.points.push_back(n.point(point));
  return line;
}

/// Between two outline points stands a straight side; a bend is the control point of a curve that
/// begins and ends at its neighbours if they are outline points, or half-way to them if they are
/// bends too.
Path::Loop loop_of(const PathFigure::Loop& loop, const FaceNumbers& n) {
  const std::size_t count = loop.nodes.size();
  const auto node = [&](std::size_t i) { return loop.nodes[i % count]; };
  const auto at = [&](std::size_t i) { return n.point(node(i).point); };
  /// The outline point on the way from node i to node i + 1, if i is a bend.
  const auto after = [&](std::size_t i) {
    return node(i + 1).bend ? 0.5 * (at(i) + at(i + 1)) : at(i + 1);
  };
  Path::Loop sides;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i + count - 1;
    if (node(i).bend)
      sides.sides.push_back({node(before).bend ? after(before) : at(before), at(i), after(i)});
    else if (!node(i + 1).bend)
      sides.sides.push_back({at(i), 0.5 * (at(i) + at(i + 1)), at(i + 1)});
  }
  return sides;
}

Shape shape(const PathFigure& f, const FaceNumbers& n) {
  Path path{.loops = {}, .rule = f.even_odd ? FillRule::even_odd : FillRule::nonzero};
  for (const PathFigure::Loop& loop : f.loops) path.loops.push_back(loop_of(loop, n));
  return path;
}

/// Whether the bends of the lid edges that begin at slice `first` are shifted.
bool is_shifted(int first, int count, const FaceNumbers& n) {
  if (first < 0) return false;
  for (int i = 0; i < count; ++i)
    if (n.point(first + i) != glm::dvec2(0)) return true;
  return false;
}

/// The edge of a lid as smooth quadratic pieces between its shifted bends.
LidPieces lid_pieces(const QuadBezier& edge, int first, const FaceNumbers& n) {
  LidBends bends = lid_bends(edge);
  for (int i = 0; i < int(bends.size()); ++i) bends[std::size_t(i)] += n.point(first + i);
  return pieces_between(edge.p0, bends, edge.p2);
}

/// A shut eye, whose lid edges are one curve, has no area and no outline.
Shape shape(const OpeningFigure& f, const FaceNumbers& n) {
  constexpr int kBends = OpeningFigure::kLidBends;
  const glm::dvec2 inner = n.point(f.inner), upper = n.point(f.upper), outer = n.point(f.outer),
                   lower = n.point(f.lower);
  if (!is_shifted(f.shifts, 2 * kBends, n)) {
    if (upper == lower) return Path{};
    return Path{.loops = {{{{inner, upper, outer}, {outer, lower, inner}}}},
                .rule = FillRule::nonzero};
  }
  const LidPieces top = lid_pieces({inner, upper, outer}, f.shifts, n);
  const LidPieces bottom = lid_pieces({inner, lower, outer}, f.shifts + kBends, n);
  if (top == bottom) return Path{};
  Path::Loop loop{{top.begin(), top.end()}};
  for (auto piece = bottom.rbegin(); piece != bottom.rend(); ++piece)
    loop.sides.push_back(reversed(*piece));
  return Path{.loops = {std::move(loop)}, .rule = FillRule::nonzero};
}

/// Whether two figures agree in everything but their numbers.
bool same_structure(const PathFigure& a, const PathFigure& b) {
  const auto same_node = [](const PathFigure::Node& p, const PathFigure::Node& q) {
    return p.bend == q.bend;
  };
  const auto same_loop = [&](const PathFigure::Loop& p, const PathFigure::Loop& q) {
    return std::equal(p.nodes.begin(), p.nodes.end(), q.nodes.begin(), q.nodes.end(), same_node);
  };
  return a.even_odd == b.even_odd &&
         std::equal(a.loops.begin(), a.loops.end(), b.loops.begin(), b.loops.end(), same_loop);
}

/// Areas and patterns say more than their numbers do.
template <class F>
constexpr bool is_of_several(const F&) {
  return std::is_same_v<F, AreaFigure> || std::is_same_v<F, ScatterFigure> ||
         std::is_same_v<F, RepeatFigure> || std::is_same_v<F, StripesFigure>;
}

std::vector<double> numbers_of(const Figure& figure, const FaceNumbers& n) {
  std::vector<double> all;
  for_each_slice(figure, [&](std::string_view, int slice) {
    all.push_back(n.size(slice));
    for (int i = 0; i < n.size(slice); ++i) all.push_back(n(slice, i));
  });
  return all;
}

/// The strokes between the points of a polyline that is smooth or not one width: from point to point the
/// half-width changes evenly.
std::vector<Shape> strokes_of(const PolylineFigure& f, const FaceNumbers& n, double twice_axis) {
  const bool even = n.size(f.half_width) == 1;
  std::vector<glm::dvec2> points;
  std::vector<double> widths;
  for (std::size_t i = 0; i < f.points.size(); ++i)
    if (const glm::dvec2 p = n.point(f.points[i]); points.empty() || p != points.back()) {
      points.push_back(p);
      widths.push_back(n(f.half_width, even ? 0 : int(i)));
    }
  if (points.size() == 1) return {Disc{points[0], widths[0]}};
  const std::vector<QuadBezier> curves =
      f.smooth ? smooth_curve(points, twice_axis) : straight_curve(points);
  const std::size_t per_point = curves.size() / (points.size() - 1);
  std::vector<Shape> pieces;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (even) {
      pieces.push_back(QuadStroke{curves[i], widths[0]});
      continue;
    }
    const std::size_t k = i / per_point;
    const auto width = [&](double t) { return widths[k] + t * (widths[k + 1] - widths[k]); };
    const double from = double(i % per_point) / double(per_point), step = 1 / double(per_point);
    pieces.push_back(
        TaperedStroke{curves[i], {width(from), width(from + 0.5 * step), width(from + step)}});
  }
  return pieces;
}

/// Of what is one shape: none.
template <class Other>
std::vector<Shape> pieces(const Other&, const Face&) {
  return {};
}

std::vector<Shape> pieces(const PolylineFigure& line, const Face& face) {
  const FaceNumbers n(face);
  const bool one_shape = !line.smooth && n.size(line.half_width) == 1;
  if (one_shape || line.points.size() < 2) return {};
  return strokes_of(line, n, face.model->canvas.twice_axis());
}

std::vector<Shape> pieces(const ScatterFigure& f, const Face& face) {
  return pattern_shapes(f, face);
}
std::vector<Shape> pieces(const RepeatFigure& f, const Face& face) {
  return pattern_shapes(f, face);
}
std::vector<Shape> pieces(const StripesFigure& f, const Face& face) {
  return pattern_shapes(f, face);
}

/// Widths are quadratic in the parameter, so those of a piece are too (by the polar form).
std::vector<Shape> pieces(const StrokeFigure& f, const Face& face) {
  const FaceNumbers n(face);
  if (!is_shifted(f.shifts, OpeningFigure::kLidBends, n)) return {};
  const LidPieces spines =
      lid_pieces({n.point(f.spine[0]), n.point(f.spine[1]), n.point(f.spine[2])}, f.shifts, n);
  const int w = f.half_width;
  const bool even = n.size(w) == 1;
  const auto width = [&](double a, double b) {
    const double w0 = n(w, 0), w1 = even ? w0 : n(w, 1), w2 = even ? w0 : n(w, 2);
    return (1 - a) * (1 - b) * w0 + bend_share(a, b) * w1 + a * b * w2;
  };
  std::vector<Shape> made;
  constexpr double count = OpeningFigure::kLidBends;
  for (std::size_t i = 0; i < spines.size(); ++i) {
    const double a = double(i) / count, b = double(i + 1) / count;
    if (even)
      made.push_back(QuadStroke{spines[i], n(w)});
    else
      made.push_back(TaperedStroke{spines[i], {width(a, a), width(a, b), width(b, b)}});
  }
  return made;
}

/// With corners of radius `corner` around it this core is the rectangle; it may be a line or a point.
Shape shape(const RoundedFigure& f, const FaceNumbers& n) {
  const glm::dvec2 radii = n.point(f.radii), x = n.way(f.tilt), y{-x.y, x.x};
  const double corner = std::min({n(f.corner), radii.x, radii.y});
  const glm::dvec2 center = n.point(f.center);
  const glm::dvec2 right = (radii.x - corner) * x, up = (radii.y - corner) * y;
  if (radii.x == corner || radii.y == corner)
    return Line{center - right - up, center + right + up, 0};
  const glm::dvec2 corners[] = {center - right - up, center + right - up, center + right + up,
                                center - right + up};
  Path::Loop loop;
  for (int i = 0; i < 4; ++i) {
    const glm::dvec2 a = corners[i], b = corners[(i + 1) % 4];
    loop.sides.push_back({a, 0.5 * (a + b), b});
  }
  return Path{{std::move(loop)}, FillRule::nonzero};
}

/// Letters stand upright in the picture wherever y points, and are never mirrored.
Shape shape(const TextFigure& f, const FaceNumbers& n) {
  Path path;
  const glm::dvec2 center = n.point(f.center), x = n(f.height) * n.way(f.tilt),
                   y = n.sign_of_up() * glm::dvec2{-x.y, x.x};
  if (x == glm::dvec2{0.0}) return path;
  const auto place = [&](glm::dvec2 p) { return center + p.x * x + p.y * y; };
  for (const std::vector<QuadBezier>& loop : f.outline->loops) {
    Path::Loop& made = path.loops.emplace_back();
    for (const QuadBezier& side : loop)
      made.sides.push_back({place(side.p0), place(side.p1), place(side.p2)});
  }
  return path;
}

/// What is made of several shapes is none.
template <class Several>
Shape shape(const Several&, const FaceNumbers&) {
  return Path{};
}

}  // namespace

std::vector<Shape> pieces_of(const Figure& figure, const Face& face) {
  return std::visit([&](const auto& f) { return pieces(f, face); }, figure);
}

double corner_of(const RoundedFigure& figure, const Face& face) {
  const FaceNumbers n(face);
  return std::min({n(figure.corner), n(figure.radii, 0), n(figure.radii, 1)});
}

Shape shape_of(const Figure& figure, const Face& face) {
  return std::visit([n = FaceNumbers(face)](const auto& f) { return shape(f, n); }, figure);
}

bool same_figure(const Figure& a, const Figure& b, const Face& face) {
  if (a.index() != b.index() || std::visit([](const auto& f) { return is_of_several(f); }, a))
    return false;
  if (const auto* path = std::get_if<PathFigure>(&a);
      path && !same_structure(*path, std::get<PathFigure>(b)))
    return false;
  if (const auto* line = std::get_if<PolylineFigure>(&a);
      line && line->smooth != std::get_if<PolylineFigure>(&b)->smooth)
    return false;
  if (const auto* text = std::get_if<TextFigure>(&a);
      text && text->text != std::get_if<TextFigure>(&b)->text)
    return false;
  return numbers_of(a, FaceNumbers(face)) == numbers_of(b, FaceNumbers(face));
}

}  // namespace mien
