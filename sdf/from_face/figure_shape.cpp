#include <mien/face_model.h>
#include "figure_shape_private.h"
#include "lib/rig/eye/lid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

namespace mien {
namespace {

/// The numbers of a face by slice.
class FigureNumbers {
 public:
  explicit FigureNumbers(const Face& face) : face_(face) {}

  double operator()(int slice, int i = 0) const {
    return face_.vector[std::size_t(face_.model->layout[slice].begin + i)];
  }
  int size(int slice) const { return face_.model->layout[slice].size; }
  glm::dvec2 point(int slice) const { return {(*this)(slice, 0), (*this)(slice, 1)}; }
  double sign_of_up() const { return face_.model->canvas.y_up ? 1 : -1; }

 private:
  const Face& face_;
};

/// side · y >= side · (a q² + b), q = k x + k0, in the shape's own terms: vertex, axis, bend.
/// A frame that does not change along x (or so little that its vertex is nowhere) leaves a level
/// half-plane.
ParabolaSide parabola_side(double k, double k0, double a, double b, double side) {
  const double vertex = -k0 / k;
  if (!std::isfinite(vertex)) return {{0, a * k0 * k0 + b}, {0, side}, 0};
  return {{vertex, b}, {0, side}, side * a * k * k};
}

Shape shape(const BandFigure& f, const FigureNumbers& n) {
  const double k = n(f.frame, 0), k0 = n(f.frame, 1);
  return Band{parabola_side(k, k0, n(f.lower, 0), n(f.lower, 1), 1),
              parabola_side(k, k0, n(f.upper, 0), n(f.upper, 1), -1)};
}

Shape shape(const EllipseFigure& f, const FigureNumbers& n) {
  Ellipse ellipse{.center = n.point(f.center), .radii = n.point(f.radii)};
  if (f.tilt >= 0 && n(f.tilt) != 0) {
    const double angle = n(f.tilt) * std::numbers::pi / 180;
    ellipse.axis = {std::cos(angle), std::sin(angle)};
  }
  return ellipse;
}

Shape shape(const DiscFigure& f, const FigureNumbers& n) {
  return Disc{n.point(f.center), n(f.radius)};
}

Shape shape(const CutDiscFigure& f, const FigureNumbers& n) {
  return CutDisc{.center = n.point(f.center),
                 .radius = n(f.radius),
                 .upper = n(f.chords, 0),
                 .lower = n(f.chords, 1),
                 .up = {0, n.sign_of_up()}};
}

Shape shape(const StrokeFigure& f, const FigureNumbers& n) {
  const QuadBezier spine{n.point(f.spine[0]), n.point(f.spine[1]), n.point(f.spine[2])};
  const int w = f.half_width;
  if (n.size(w) == 1) return QuadStroke{spine, n(w)};
  return TaperedStroke{spine, {n(w, 0), n(w, 1), n(w, 2)}};
}

Shape shape(const PolylineFigure& f, const FigureNumbers& n) {
  Polyline line{.points = {}, .half_width = n(f.half_width)};
  for (const int point : f.points) line.points.push_back(n.point(point));
  return line;
}

/// Between two outline points stands a straight side; a bend is the control point of a curve that
/// begins and ends at its neighbours if they are outline points, or half-way to them if they are
/// bends too.
Path::Loop loop_of(const PathFigure::Loop& loop, const FigureNumbers& n) {
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

Shape shape(const PathFigure& f, const FigureNumbers& n) {
  Path path{.loops = {}, .rule = f.even_odd ? FillRule::even_odd : FillRule::nonzero};
  for (const PathFigure::Loop& loop : f.loops) path.loops.push_back(loop_of(loop, n));
  return path;
}

/// Whether the bends of the lid edges that begin at slice `first` are shifted.
bool is_shifted(int first, int count, const FigureNumbers& n) {
  if (first < 0) return false;
  for (int i = 0; i < count; ++i)
    if (n.point(first + i) != glm::dvec2(0)) return true;
  return false;
}

/// The edge of a lid as smooth quadratic pieces between its shifted bends.
LidPieces lid_pieces(const QuadBezier& edge, int first, const FigureNumbers& n) {
  LidBends bends = lid_bends(edge);
  for (int i = 0; i < int(bends.size()); ++i) bends[std::size_t(i)] += n.point(first + i);
  return pieces_between(edge.p0, bends, edge.p2);
}

/// A shut eye, whose lid edges are one curve, has no area and no outline.
Shape shape(const OpeningFigure& f, const FigureNumbers& n) {
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

std::vector<double> numbers_of(const Figure& figure, const FigureNumbers& n) {
  std::vector<double> all;
  for_each_slice(figure, [&](std::string_view, int slice) {
    all.push_back(n.size(slice));
    for (int i = 0; i < n.size(slice); ++i) all.push_back(n(slice, i));
  });
  return all;
}

/// The centripetal Catmull-Rom curve through the points (C. Yuksel, S. Schaefer, J. Keyser, 2011: no
/// cusps, no loops within a segment), each segment as two quadratic pieces with its tangents at both
/// ends. A point on the axis goes on to its own mirror image, so that both halves meet smoothly.
std::vector<Shape> smooth_pieces(const PolylineFigure& f, const FigureNumbers& n,
                                 double twice_axis) {
  std::vector<glm::dvec2> points;
  for (const int point : f.points)
    if (const glm::dvec2 p = n.point(point); points.empty() || p != points.back())
      points.push_back(p);
  const auto mirrored = [&](glm::dvec2 p) { return glm::dvec2{twice_axis - p.x, p.y}; };
  const auto knot = [](glm::dvec2 a, glm::dvec2 b) {
    return std::sqrt(std::hypot(b.x - a.x, b.y - a.y));
  };
  /// The derivative by knot at the middle one of three points.
  const auto tangent = [&](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    const double ab = knot(a, b), bc = knot(b, c);
    return (bc / ab * (b - a) + ab / bc * (c - b)) / (ab + bc);
  };
  const auto tangent_at = [&](std::size_t i) {
    const bool first = i == 0, last = i + 1 == points.size();
    const glm::dvec2 here = points[i];
    if (!first && !last) return tangent(points[i - 1], here, points[i + 1]);
    const glm::dvec2 next = first ? points[1] : points[i - 1];
    const double away = first ? 1 : -1;
    if (mirrored(here) == here && next.x != here.x)
      return away * tangent(mirrored(next), here, next);
    return away * (next - here) / knot(here, next);
  };
  std::vector<Shape> pieces;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double quarter = 0.25 * knot(points[i], points[i + 1]);
    const glm::dvec2 leave = points[i] + quarter * tangent_at(i);
    const glm::dvec2 arrive = points[i + 1] - quarter * tangent_at(i + 1);
    const glm::dvec2 middle = 0.5 * (leave + arrive);
    pieces.push_back(QuadStroke{{points[i], leave, middle}, n(f.half_width)});
    pieces.push_back(QuadStroke{{middle, arrive, points[i + 1]}, n(f.half_width)});
  }
  if (pieces.empty()) pieces.push_back(Disc{points[0], n(f.half_width)});
  return pieces;
}

}  // namespace

/// Widths are quadratic in the parameter, so those of a piece are too (by the polar form).
std::vector<Shape> pieces_of(const Figure& figure, const Face& face) {
  const FigureNumbers n(face);
  if (const auto* line = std::get_if<PolylineFigure>(&figure))
    return line->smooth && line->points.size() > 1
               ? smooth_pieces(*line, n, face.model->canvas.twice_axis())
               : std::vector<Shape>{};
  const auto* f = std::get_if<StrokeFigure>(&figure);
  if (!f || !is_shifted(f->shifts, OpeningFigure::kLidBends, n)) return {};
  const LidPieces spines =
      lid_pieces({n.point(f->spine[0]), n.point(f->spine[1]), n.point(f->spine[2])}, f->shifts, n);
  const int w = f->half_width;
  const bool even = n.size(w) == 1;
  const auto width = [&](double a, double b) {
    const double w0 = n(w, 0), w1 = even ? w0 : n(w, 1), w2 = even ? w0 : n(w, 2);
    return (1 - a) * (1 - b) * w0 + bend_share(a, b) * w1 + a * b * w2;
  };
  std::vector<Shape> pieces;
  constexpr double count = OpeningFigure::kLidBends;
  for (std::size_t i = 0; i < spines.size(); ++i) {
    const double a = double(i) / count, b = double(i + 1) / count;
    if (even)
      pieces.push_back(QuadStroke{spines[i], n(w)});
    else
      pieces.push_back(TaperedStroke{spines[i], {width(a, a), width(a, b), width(b, b)}});
  }
  return pieces;
}

Shape shape_of(const Figure& figure, const Face& face) {
  return std::visit([n = FigureNumbers(face)](const auto& f) { return shape(f, n); }, figure);
}

bool same_figure(const Figure& a, const Figure& b, const Face& face) {
  if (a.index() != b.index()) return false;
  if (const auto* path = std::get_if<PathFigure>(&a);
      path && !same_structure(*path, std::get<PathFigure>(b)))
    return false;
  if (const auto* line = std::get_if<PolylineFigure>(&a);
      line && line->smooth != std::get_if<PolylineFigure>(&b)->smooth)
    return false;
  return numbers_of(a, FigureNumbers(face)) == numbers_of(b, FigureNumbers(face));
}

}  // namespace mien
