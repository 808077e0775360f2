#include "lib/rig/eye/lid.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace mien {

LidBends lid_bends(const QuadBezier& edge) {
  constexpr double n = OpeningFigure::kLidBends;
  LidBends bends;
  for (std::size_t i = 0; i < bends.size(); ++i)
    bends[i] = polar_form(edge, double(i) / n, double(i + 1) / n);
  return bends;
}

LidPieces pieces_between(glm::dvec2 inner, const LidBends& bends, glm::dvec2 outer) {
  LidPieces pieces;
  const std::size_t last = bends.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
    pieces[i] = {i == 0 ? inner : 0.5 * (bends[i - 1] + bends[i]), bends[i],
                 i == last ? outer : 0.5 * (bends[i] + bends[i + 1])};
  return pieces;
}

glm::dvec2 shift_along(std::span<const glm::dvec2, OpeningFigure::kLidBends> shifts, double a,
                       double b) {
  constexpr int n = OpeningFigure::kLidBends;
  const double t = std::clamp(0.5 * (a + b), 0.0, 1.0) * n;
  const int piece = std::min(n - 1, int(t));
  const auto shift = [&](int i) { return shifts[std::size_t(i)]; };
  const glm::dvec2 begin = piece == 0 ? glm::dvec2(0) : 0.5 * (shift(piece - 1) + shift(piece));
  const glm::dvec2 end = piece == n - 1 ? glm::dvec2(0) : 0.5 * (shift(piece) + shift(piece + 1));
  const double u = t - piece;
  return (1 - u) * (1 - u) * begin + 2 * u * (1 - u) * shift(piece) + u * u * end;
}

double nearest_parameter(const QuadBezier& edge, glm::dvec2 p) {
  const auto far = [&](double t) {
    const glm::dvec2 way = point(edge, t) - p;
    return glm::dot(way, way);
  };
  constexpr int kSamples = 64;
  int nearest = 0;
  for (int i = 1; i <= kSamples; ++i)
    if (far(double(i) / kSamples) < far(double(nearest) / kSamples)) nearest = i;
  double lo = std::max(0, nearest - 1) / double(kSamples);
  double hi = std::min(kSamples, nearest + 1) / double(kSamples);
  while (hi - lo > 1e-10) {
    const double third = (hi - lo) / 3;
    if (far(lo + third) <= far(hi - third))
      hi -= third;
    else
      lo += third;
  }
  return 0.5 * (lo + hi);
}

}  // namespace mien
