#include <mien/render/cover/edge_coverage.h>

namespace mien {

double straightened(double d, glm::dvec2 n, double bend) {
  const double nx = std::abs(n.x), ny = std::abs(n.y);
  const double a = std::max(nx, ny), b = std::min(nx, ny);
  // By symmetry take n = (a, b) with a >= b >= 0: the tangent runs along m = (−b, a), steeply up. Distances
  // beyond the square's corner are held at the corner.
  const double x = std::clamp(d, -0.5 * (a + b), 0.5 * (a + b));
  // u.y = −x b + t a within ±1/2; u.x = −x a − t b within ±1/2.
  double lo = (-0.5 + x * b) / a, hi = (0.5 + x * b) / a;
  if (b > 0.0) {
    lo = std::max(lo, (-0.5 - x * a) / b);
    hi = std::min(hi, (0.5 - x * a) / b);
  }
  return d + bend / 6.0 * (lo * lo + lo * hi + hi * hi);
}

}  // namespace mien
