#include "outline_pen_private.h"

#include "lib/rig/eye/lid.h"
#include "sdf/from_face/figure/shape_private.h"
#include "sdf/shape/curve/path_outline.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace mien {
namespace {

/// An ellipse as quadratic curves, tangent to it at both ends: they leave it by 2e-4 of its radii.
std::vector<QuadBezier> sides_of(const Ellipse& ellipse) {
  constexpr int kSides = 16;
  const glm::dvec2 x = ellipse.radii.x * ellipse.axis;
  const glm::dvec2 y = ellipse.radii.y * glm::dvec2{-ellipse.axis.y, ellipse.axis.x};
  const auto at = [&](double side, double reach) {
    const double angle = 2 * std::numbers::pi * side / kSides;
    return ellipse.center + reach * (std::cos(angle) * x + std::sin(angle) * y);
  };
  const double beyond = 1 / std::cos(std::numbers::pi / kSides);
  std::vector<QuadBezier> sides;
  for (int i = 0; i < kSides; ++i)
    sides.push_back({at(i, 1), at(i + 0.5, beyond), at((i + 1) % kSides, 1)});
  return sides;
}

std::vector<std::vector<QuadBezier>> loops_of(const Figure& figure, const Face& face) {
  std::vector<std::vector<QuadBezier>> loops;
  Shape shape = shape_of(figure, face);
  if (auto* path = std::get_if<Path>(&shape)) {
    if (std::optional<Path> outline = visible_outline(*path)) *path = *std::move(outline);
    for (const Path::Loop& loop : path->loops) loops.push_back(loop.sides);
  }
  if (const auto* disc = std::get_if<Disc>(&shape))
    loops.push_back(sides_of({.center = disc->center, .radii = glm::dvec2{disc->radius}}));
  if (const auto* ellipse = std::get_if<Ellipse>(&shape)) loops.push_back(sides_of(*ellipse));
  return loops;
}

double length_of(const QuadBezier& side) {
  constexpr int kChords = 8;
  double length = 0;
  for (int i = 0; i < kChords; ++i)
    length += glm::length(point(side, (i + 1.0) / kChords) - point(side, double(i) / kChords));
  return length;
}

}  // namespace

std::vector<Shape> outline_pen(const Figure& figure, const Face& face, double thin, double thick) {
  std::vector<Shape> pieces;
  for (const std::vector<QuadBezier>& sides : loops_of(figure, face)) {
    double all = 0, before = 0;
    for (const QuadBezier& side : sides) all += length_of(side);
    if (!(all > 0)) continue;
    for (const QuadBezier& side : sides) {
      const double a = before / all, b = std::min((before += length_of(side)) / all, 1.0);
      // The polar form of 4 s (1 − s).
      const auto width = [&](double s, double t) {
        return std::max(thin + (thick - thin) * 2 * (s + t - 2 * s * t), 0.0);
      };
      pieces.push_back(TaperedStroke{side, {width(a, a), width(a, b), width(b, b)}});
    }
  }
  return pieces;
}

}  // namespace mien
