#include "lib/geom/polygon.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

double crossed(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

int turns_around(const Polygon& outline, glm::dvec2 p) {
  worked(2 * std::int64_t(outline.size()));
  int turns = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const double left = crossed(b - a, p - a);
    if (b.y > a.y && left > 0) ++turns;
    if (b.y < a.y && left < 0) --turns;
  }
  return turns;
}

double way_to_side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p, double& share) {
  const glm::dvec2 along = b - a;
  const double square = glm::dot(along, along);
  share = square > 0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + share * along);
}

double way_to_outline(const Polygon& outline, glm::dvec2 p) {
  worked(4 * std::int64_t(outline.size()));
  double square = std::numeric_limits<double>::infinity();
  glm::dvec2 a = outline.empty() ? glm::dvec2{0} : outline.back();
  for (const glm::dvec2 b : outline) {  // as way_to_side does, but with a single square root
    const glm::dvec2 along = b - a, from = p - a;
    const double length = glm::dot(along, along), reach = glm::dot(from, along);
    const double share = reach <= 0 ? 0.0 : reach >= length ? 1.0 : reach / length;
    const glm::dvec2 way = from - share * along;
    square = std::min(square, glm::dot(way, way));
    a = b;
  }
  return std::sqrt(square);
}

double depth_inside(const Polygon& outline, glm::dvec2 p) {
  const double way = way_to_outline(outline, p);
  return turns_around(outline, p) != 0 ? way : -way;
}

double signed_area(const Polygon& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    twice += crossed(outline[i], outline[i + 1 < outline.size() ? i + 1 : 0]);
  return 0.5 * twice;
}

void add_curve(const QuadBezier& curve, int pieces, Polygon& to) {
  for (int i = 0; i < pieces; ++i) to.push_back(point(curve, double(i) / pieces));
}

}  // namespace mien
