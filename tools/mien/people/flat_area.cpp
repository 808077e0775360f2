#include "tools/mien/people/flat_area.h"
#include <mien/face_model.h>
#include "lib/rig/eye/lid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace mien {
namespace {

constexpr int kSidesOfEllipse = 24;
constexpr int kPenSamples = 13;  // of a stroke

class AreaNumbers {
 public:
  explicit AreaNumbers(const Face& face) : face_(face) {}

  double operator()(int slice, int i = 0) const {
    return face_.vector[std::size_t(face_.model->layout[slice].begin + i)];
  }
  glm::dvec2 point(int slice) const { return {(*this)(slice, 0), (*this)(slice, 1)}; }
  int size(int slice) const { return face_.model->layout[slice].size; }

 private:
  const Face& face_;
};

Polygon ellipse_polygon(glm::dvec2 center, glm::dvec2 radii, double degrees) {
  const double tilt = degrees * std::numbers::pi / 180;
  const glm::dvec2 along{std::cos(tilt), std::sin(tilt)}, across{-along.y, along.x};
  Polygon polygon;
  for (int i = 0; i < kSidesOfEllipse; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSidesOfEllipse;
    polygon.push_back(center + radii.x * std::cos(angle) * along +
                      radii.y * std::sin(angle) * across);
  }
  return polygon;
}

Polygon rectangle(glm::dvec2 center, glm::dvec2 radii, double degrees) {
  const double tilt = degrees * std::numbers::pi / 180;
  const glm::dvec2 along{std::cos(tilt), std::sin(tilt)}, across{-along.y, along.x};
  const glm::dvec2 right = radii.x * along, up = radii.y * across;
  return {center - right - up, center + right - up, center + right + up, center - right + up};
}

/// Bends and outline points mean what they do for pictures: between two bends the outline passes
/// half-way.
Polygon loop_polygon(const PathFigure::Loop& loop, const AreaNumbers& n) {
  const std::size_t count = loop.nodes.size();
  const auto node = [&](std::size_t i) { return loop.nodes[i % count]; };
  const auto at = [&](std::size_t i) { return n.point(node(i).point); };
  Polygon polygon;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = i + count - 1;
    if (!node(i).bend) {
      if (!node(i + 1).bend) polygon.push_back(at(i));
      continue;
    }
    const glm::dvec2 first = node(before).bend ? 0.5 * (at(before) + at(i)) : at(before);
    const glm::dvec2 last = node(i + 1).bend ? 0.5 * (at(i) + at(i + 1)) : at(i + 1);
    add_curve({first, at(i), last}, kSidesOfCurve, polygon);
  }
  return polygon;
}

LidPieces edge_pieces(const QuadBezier& edge, int first, const AreaNumbers& n) {
  LidBends bends = lid_bends(edge);
  if (first >= 0)
    for (std::size_t i = 0; i < bends.size(); ++i) bends[i] += n.point(first + int(i));
  return pieces_between(edge.p0, bends, edge.p2);
}

class AreaMaker {
 public:
  AreaMaker(const AreaNumbers& n, FlatArea& area) : n_(n), area_(area) {}

  void operator()(const BandFigure&) {}
  void operator()(const EllipseFigure& f) {
    area_.loops.push_back(
        ellipse_polygon(n_.point(f.center), n_.point(f.radii), f.tilt >= 0 ? n_(f.tilt) : 0.0));
  }
  void operator()(const DiscFigure& f) {
    area_.loops.push_back(ellipse_polygon(n_.point(f.center), glm::dvec2{n_(f.radius)}, 0));
  }
  void operator()(const CutDiscFigure& f) {
    area_.loops.push_back(ellipse_polygon(n_.point(f.center), glm::dvec2{n_(f.radius)}, 0));
  }
  void operator()(const StrokeFigure& f) {
    const QuadBezier spine{n_.point(f.spine[0]), n_.point(f.spine[1]), n_.point(f.spine[2])};
    const bool even = n_.size(f.half_width) == 1;
    for (int i = 0; i < kPenSamples; ++i) {
      const double t = double(i) / (kPenSamples - 1), s = 1 - t;
      const double width = even ? n_(f.half_width)
                                : s * s * n_(f.half_width, 0) + 2 * s * t * n_(f.half_width, 1) +
                                      t * t * n_(f.half_width, 2);
      area_.pen.push_back({point(spine, t), width});
    }
  }
  void operator()(const PolylineFigure& f) {
    const int widths = n_.size(f.half_width);
    for (int i = 0; i < int(f.points.size()); ++i)
      area_.pen.push_back({n_.point(f.points[std::size_t(i)]), n_(f.half_width, i % widths)});
  }
  void operator()(const PathFigure& f) {
    area_.even_odd = f.even_odd;
    for (const PathFigure::Loop& loop : f.loops) area_.loops.push_back(loop_polygon(loop, n_));
  }
  void operator()(const RoundedFigure& f) {
    area_.loops.push_back(
        rectangle(n_.point(f.center), n_.point(f.radii), f.tilt >= 0 ? n_(f.tilt) : 0.0));
  }
  // What these hold is seen in other features, or too small to hide anything.
  void operator()(const AreaFigure&) {}
  void operator()(const ScatterFigure&) {}
  void operator()(const RepeatFigure&) {}
  void operator()(const StripesFigure&) {}
  void operator()(const TextFigure&) {}
  void operator()(const OpeningFigure& f) {
    const glm::dvec2 inner = n_.point(f.inner), outer = n_.point(f.outer);
    const int lower_shifts = f.shifts < 0 ? -1 : f.shifts + OpeningFigure::kLidBends;
    const LidPieces top = edge_pieces({inner, n_.point(f.upper), outer}, f.shifts, n_);
    const LidPieces bottom = edge_pieces({inner, n_.point(f.lower), outer}, lower_shifts, n_);
    if (top == bottom) return;
    Polygon polygon;
    for (const QuadBezier& piece : top) add_curve(piece, 2, polygon);
    for (auto piece = bottom.rbegin(); piece != bottom.rend(); ++piece)
      add_curve(reversed(*piece), 2, polygon);
    area_.loops.push_back(std::move(polygon));
  }

 private:
  const AreaNumbers& n_;
  FlatArea& area_;
};

}  // namespace

bool FlatArea::covers(glm::dvec2 p) const {
  if (!box.contains(p)) return false;
  int turns = 0;
  for (const Polygon& loop : loops) turns += turns_around(loop, p);
  if (even_odd ? turns % 2 != 0 : turns != 0) return true;
  for (std::size_t i = 0; i < pen.size(); ++i) {
    const PenSample &a = pen[i], &b = pen[i + 1 < pen.size() ? i + 1 : i];
    double share = 0;
    const double way = way_to_side(a.at, b.at, p, share);
    if (way <= a.half_width + share * (b.half_width - a.half_width)) return true;
  }
  return false;
}

FlatArea flat_area(const Figure& figure, const Face& face) {
  FlatArea area;
  const AreaNumbers n(face);
  std::visit(AreaMaker(n, area), figure);
  for (const Polygon& loop : area.loops)
    for (const glm::dvec2 p : loop) area.box = around(area.box, p);
  for (const PenSample& sample : area.pen) {
    area.box = around(area.box, sample.at - sample.half_width);
    area.box = around(area.box, sample.at + sample.half_width);
  }
  return area;
}

}  // namespace mien
