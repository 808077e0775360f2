#include <mien/render/shade/lit_mean.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mien {
namespace {

/// By Gauss's two places each way.
Mix gauss_mean(const LitSurface& surface, int zone, glm::dvec2 middle, double side) {
  const double g = side * 0.28867513459481287;
  Mix sum{0.0};
  for (const glm::dvec2 by : {glm::dvec2{-g, -g}, {g, -g}, {-g, g}, {g, g}})
    sum += 0.25 * surface.color(zone, middle + by, surface.outward(middle + by));
  return sum;
}

double largest(const Mix& m) {
  return std::max({std::abs(m.r), std::abs(m.g), std::abs(m.b), std::abs(m.a)});
}

Mix divided(const LitSurface& surface, int zone, glm::dvec2 middle, double side, const Mix& coarse,
            double tolerance, int depth) {
  const double q = 0.25 * side;
  const std::array<glm::dvec2, 4> middles{middle + glm::dvec2{-q, -q}, middle + glm::dvec2{q, -q},
                                          middle + glm::dvec2{-q, q}, middle + glm::dvec2{q, q}};
  std::array<Mix, 4> parts;
  Mix sum{0.0};
  double apart = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    parts[i] = gauss_mean(surface, zone, middles[i], 0.5 * side);
    sum += 0.25 * parts[i];
    apart = std::max(apart, largest(parts[i] - parts[0]));
  }
  // Where the quarters are alike there is no kink; agreement of the means alone may be chance.
  if (depth == 0 || (largest(sum - coarse) < tolerance && apart < 30.0 * tolerance)) return sum;
  sum = Mix{0.0};
  for (std::size_t i = 0; i < 4; ++i)
    sum +=
        0.25 * divided(surface, zone, middles[i], 0.5 * side, parts[i], 2.0 * tolerance, depth - 1);
  return sum;
}

/// Each cell by places × places of a square of its area around its centroid.
Mix mean_of_cells(const LitSurface& surface, int zone, glm::dvec2 corner, const PartCells& cells,
                  int places) {
  Mix sum{0.0};
  double area = 0.0;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    if (cells.area[k] == 0.0f) continue;
    const double step = std::sqrt(double(cells.area[k])) / places;
    const glm::dvec2 middle = corner + 0.5 + glm::dvec2{cells.x[k], cells.y[k]};
    Mix mean{0.0};
    for (int j = 0; j < places; ++j)
      for (int i = 0; i < places; ++i) {
        const glm::dvec2 p = middle + step * (glm::dvec2{i, j} - 0.5 * (places - 1));
        mean += surface.color(zone, p, surface.outward(p));
      }
    sum += (double(cells.area[k]) / (places * places)) * mean, area += double(cells.area[k]);
  }
  return area > 0.0 ? sum / area : surface.color(zone, corner + 0.5, surface.outward(corner + 0.5));
}

}  // namespace

Mix square_mean(const LitSurface& surface, int zone, glm::dvec2 corner, double side,
                double tolerance) {
  const glm::dvec2 middle = corner + 0.5 * side;
  return divided(surface, zone, middle, side, gauss_mean(surface, zone, middle, side), tolerance,
                 5);
}

Mix part_mean(const LitSurface& surface, int zone, glm::dvec2 corner, const PartForm& form,
              double tolerance) {
  constexpr std::pair<int, int> kFiner[] = {{4, 1}, {8, 1}, {16, 1}, {16, 2}, {16, 4}};
  PartCells cells;
  cells_of_form(form, 4, cells);
  float area = 0.0f;
  for (int k = 0; k < cells.count(); ++k) area += cells.area[std::size_t(k)];
  // What is narrow may lie in one column of coarse cells: these agree by chance.
  const std::size_t first = area < 0.4f ? 2 : 0;
  Mix coarse{0.0};
  for (std::size_t i = first; i < std::size(kFiner); ++i) {
    const auto [side, places] = kFiner[i];
    cells_of_form(form, side, cells);
    const Mix fine = mean_of_cells(surface, zone, corner, cells, places);
    if (i > first && largest(fine - coarse) < tolerance) return fine;
    coarse = fine;
  }
  return coarse;
}

}  // namespace mien
