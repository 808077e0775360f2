#include "render/effect/bevel.h"

#include <algorithm>

namespace mien {
namespace {

/// The rectangle's part of the slope v < bevel.
double slope_area(double u0, double u1, double v0, double v1, double side, double bevel) {
  const double end = std::min(v1, bevel);
  if (v0 >= end) return 0;
  std::array<double, 6> at{v0,
                           end,
                           std::clamp(u0, v0, end),
                           std::clamp(u1, v0, end),
                           std::clamp(side - u0, v0, end),
                           std::clamp(side - u1, v0, end)};
  std::sort(at.begin(), at.end());
  const auto width = [&](double v) {
    return std::max(std::min(u1, side - v) - std::max(u0, v), 0.0);
  };
  double area = 0;
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    area += 0.5 * (at[i + 1] - at[i]) * (width(at[i]) + width(at[i + 1]));
  return area;
}

}  // namespace

BevelAreas bevel_areas(double u0, double u1, double v0, double v1, double side, double bevel) {
  BevelAreas areas{(u1 - u0) * (v1 - v0), 0, 0, 0, 0};
  if (u0 >= bevel && v0 >= bevel && u1 <= side - bevel && v1 <= side - bevel) return areas;
  areas.above = slope_area(u0, u1, v0, v1, side, bevel);
  areas.below = slope_area(u0, u1, side - v1, side - v0, side, bevel);
  areas.left = slope_area(v0, v1, u0, u1, side, bevel);
  areas.right = slope_area(v0, v1, side - u1, side - u0, side, bevel);
  areas.flat -= areas.above + areas.below + areas.left + areas.right;
  return areas;
}

}  // namespace mien
