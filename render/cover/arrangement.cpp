#include <mien/render/cover/arrangement.h>

#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Shoelace, from the first corner: no cancellation against the origin.
double area_of(std::span<const glm::dvec2> p) {
  double twice = 0.0;
  for (std::size_t i = 2; i < p.size(); ++i) {
    const glm::dvec2 a = p[i - 1] - p[0], b = p[i] - p[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

}  // namespace

/// Appends the parts of a convex polygon on either side of a line to the next generation.
void Arrangement::split(const Polygon& polygon, const Cut& cut, std::uint32_t bit) {
  const glm::dvec2* p = points_.data() + polygon.first;
  const std::size_t n = polygon.count;
  side_.resize(n);
  bool any_in = false, any_out = false;
  for (std::size_t i = 0; i < n; ++i) {
    side_[i] = cut.d + glm::dot(p[i], cut.normal);
    any_in |= side_[i] < 0.0;
    any_out |= side_[i] > 0.0;
  }
  for (const bool inner : {true, false}) {
    if (inner ? !any_in : (!any_out && any_in)) continue;
    const auto first = std::uint32_t(next_points_.size());
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = i + 1 < n ? i + 1 : 0;
      const double si = side_[i], sj = side_[j];
      if (inner ? si <= 0.0 : si >= 0.0) next_points_.push_back(p[i]);
      if ((si < 0.0 && sj > 0.0) || (si > 0.0 && sj < 0.0))
        next_points_.push_back(p[i] + (p[j] - p[i]) * (si / (si - sj)));
    }
    const auto count = std::uint32_t(next_points_.size()) - first;
    if (count >= 3)
      next_polygons_.push_back({polygon.inside | (inner ? bit : 0u), first, count});
    else
      next_points_.resize(first);
  }
}

std::span<const Arrangement::Piece> Arrangement::cut(std::span<const Cut> cuts) {
  points_.assign({{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  polygons_.assign({{0u, 0u, 4u}});
  std::uint32_t bit = 1;  // kMaxCuts of them fit
  for (const Cut& c : cuts) {
    next_points_.clear();
    next_polygons_.clear();
    for (const Polygon& polygon : polygons_) split(polygon, c, bit);
    points_.swap(next_points_);
    polygons_.swap(next_polygons_);
    bit <<= 1;
  }
  pieces_.clear();
  for (const Polygon& polygon : polygons_)
    pieces_.push_back({area_of({points_.data() + polygon.first, polygon.count}), polygon.inside});
  return pieces_;
}

}  // namespace mien
