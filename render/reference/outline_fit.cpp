#include "outline_fit_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {

// Slopes and second differences over the nine places are exact for a quadratic. A distance's slope has
// length 1, and its second derivatives are bend times the direction along the outline, twice.
OutlineFit fit_outline(const NineDistances& d, double half) {
  const double left = d[0] + d[3] + d[6], right = d[2] + d[5] + d[8], top = d[0] + d[1] + d[2],
               bottom = d[6] + d[7] + d[8], middle = d[1] + d[4] + d[7], waist = d[3] + d[4] + d[5];
  OutlineFit fit;
  const glm::dvec2 slope{right - left, bottom - top};
  const double length = glm::length(slope);
  if (!(length > 0.0)) {
    fit.off = HUGE_VAL;
    return fit;
  }
  fit.normal = slope / length;
  const glm::dvec2 t = fit.along();
  const double up = 1.0 / (half * half);
  const double xx = (left - 2.0 * middle + right) / 3.0, yy = (top - 2.0 * waist + bottom) / 3.0,
               xy = 0.25 * (d[0] - d[2] - d[6] + d[8]);
  fit.bend = up * (xx * t.x * t.x + 2.0 * xy * t.x * t.y + yy * t.y * t.y);
  // The mean of dot(along, p)² over the nine places is 2/3 h².
  fit.at = (left + middle + right) / 9.0 - fit.bend * half * half / 3.0;
  for (int i = 0; i < 9; ++i) {
    const glm::dvec2 p{half * (i % 3 - 1), half * (i / 3 - 1)};
    const double s = glm::dot(t, p);
    const double form = fit.at + glm::dot(fit.normal, p) + 0.5 * fit.bend * s * s;
    fit.off = std::max(fit.off, std::abs(d[std::size_t(i)] - form));
  }
  if (!(fit.off < HUGE_VAL)) fit.off = HUGE_VAL;
  return fit;
}

double allowed_off(const OutlineFit& fit, double half, double tolerance) {
  return tolerance + std::min(2.0 * fit.bend * fit.bend * half * half, 0.02) * half;
}

Chord chord_in_square(glm::dvec2 normal, double offset, double half) {
  const glm::dvec2 along{-normal.y, normal.x}, foot = -offset * normal;
  Chord chord{-HUGE_VAL, HUGE_VAL};
  for (int k = 0; k < 2; ++k) {
    if (along[k] == 0.0) {
      if (std::abs(foot[k]) > half) return {};
      continue;
    }
    const double a = (-half - foot[k]) / along[k], b = (half - foot[k]) / along[k];
    chord.from = std::max(chord.from, std::min(a, b));
    chord.to = std::min(chord.to, std::max(a, b));
  }
  if (!(chord.from < chord.to)) return {};
  return chord;
}

}  // namespace mien
