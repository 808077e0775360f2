#include "render/shade/light/lit_mean.h"
#include "lib/base/watch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mien {
namespace {

/// By Gauss's two places each way.
Mix gauss_mean(const LitSurface& surface, const LitPiece& piece, glm::dvec2 middle, double side) {
  const double g = side * 0.28867513459481287;
  Mix sum{0.0};
  for (const glm::dvec2 by : {glm::dvec2{-g, -g}, {g, -g}, {-g, g}, {g, g}})
    sum += 0.25 * surface.color(piece, middle + by, surface.outward(middle + by));
  return sum;
}

Mix divided(const LitSurface& surface, const LitPiece& piece, glm::dvec2 middle, double side,
            const Mix& coarse, double tolerance, int depth) {
  worked(1500);
  const double q = 0.25 * side;
  const std::array<glm::dvec2, 4> middles{middle + glm::dvec2{-q, -q}, middle + glm::dvec2{q, -q},
                                          middle + glm::dvec2{-q, q}, middle + glm::dvec2{q, q}};
  std::array<Mix, 4> parts;
  Mix sum{0.0};
  double apart = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    parts[i] = gauss_mean(surface, piece, middles[i], 0.5 * side);
    sum += 0.25 * parts[i];
    apart = std::max(apart, largest(parts[i] - parts[0]));
  }
  // If the quarters are alike there is no kink; the means alone may agree by chance.
  if (depth == 0 || (largest(sum - coarse) < tolerance && apart < 30.0 * tolerance)) return sum;
  sum = Mix{0.0};
  for (std::size_t i = 0; i < 4; ++i)
    sum += 0.25 *
           divided(surface, piece, middles[i], 0.5 * side, parts[i], 2.0 * tolerance, depth - 1);
  return sum;
}

/// How often quarters are quartered at most. What is left after that are ridges through a 256th of a pixel, and 1400
/// places, or 5000 in a part: so a pixel with any number of branches takes some milliseconds.
constexpr int kOfSquares = 3, kOfCells = 0;

Mix mean_of(const LitSurface& surface, const LitPiece& piece, glm::dvec2 middle, double side,
            double tolerance, int depth) {
  return divided(surface, piece, middle, side, gauss_mean(surface, piece, middle, side), tolerance,
                 depth);
}

/// Each cell as a square of its area around its centroid: by its middle, or divided until it is right.
Mix mean_of_cells(const LitSurface& surface, const LitPiece& piece, glm::dvec2 corner,
                  const PartCells& cells, double tolerance) {
  Mix sum{0.0};
  double area = 0.0;
  for (std::size_t k = 0; k < std::size_t(cells.count()); ++k) {
    const auto own = double(cells.area[k]);
    if (own == 0.0) continue;
    const glm::dvec2 middle = corner + 0.5 + glm::dvec2{cells.x[k], cells.y[k]};
    const double side = std::sqrt(own);
    const Mix mean = tolerance > 0.0 ? mean_of(surface, piece, middle, side, tolerance, kOfCells)
                                     : surface.color(piece, middle, surface.outward(middle));
    sum += own * mean, area += own;
  }
  return area > 0.0 ? sum / area
                    : surface.color(piece, corner + 0.5, surface.outward(corner + 0.5));
}

}  // namespace

Mix square_mean(const LitSurface& surface, const LitPiece& piece, glm::dvec2 corner, double side,
                double tolerance) {
  return mean_of(surface, piece, corner + 0.5 * side, side, tolerance, kOfSquares);
}

Mix part_mean(const LitSurface& surface, const LitPiece& piece, glm::dvec2 corner,
              const PartForm& form, double tolerance) {
  PartCells cells;
  cells_of_form(form, 4, cells);
  float area = 0.0f;
  for (int k = 0; k < cells.count(); ++k) area += cells.area[std::size_t(k)];
  // Something narrow may lie in one column of coarse cells, and a ridge between two columns. Means then agree by
  // chance, so three must.
  Mix coarse{0.0};
  int agree = -1;
  for (int side = area < 0.4f ? 16 : 4; side <= PartCells::kMostSide; side *= 2) {
    cells_of_form(form, side, cells);
    const Mix fine = mean_of_cells(surface, piece, corner, cells, 0.0);
    agree = agree >= 0 && largest(fine - coarse) < tolerance ? agree + 1 : 0;
    if (agree == 2) return fine;
    coarse = fine;
  }
  cells_of_form(form, 16, cells);
  return mean_of_cells(surface, piece, corner, cells, tolerance);
}

}  // namespace mien
