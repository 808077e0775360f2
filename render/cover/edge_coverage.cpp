#include "render/cover/edge_coverage.h"

#include <array>
#include <glm/geometric.hpp>

namespace mien {

double straightened(double d, glm::dvec2 n, double bend) {
  const double nx = std::abs(n.x), ny = std::abs(n.y);
  const double a = std::max(nx, ny), b = std::min(nx, ny);
  // By symmetry take n = (a, b) with a >= b >= 0: the tangent runs along m = (−b, a), steeply up.
  // Distances beyond the square's corner are held at the corner.
  const double x = std::clamp(d, -0.5 * (a + b), 0.5 * (a + b));
  // u.y = −x b + t a within ±1/2; u.x = −x a − t b within ±1/2.
  double lo = (-0.5 + x * b) / a, hi = (0.5 + x * b) / a;
  if (b > 0.0) {
    lo = std::max(lo, (-0.5 - x * a) / b);
    hi = std::min(hi, (0.5 - x * a) / b);
  }
  return d + bend / 6.0 * (lo * lo + lo * hi + hi * hi);
}

namespace {

struct Interval {
  double lo, hi;
  double length() const { return std::max(0.0, hi - lo); }
};

/// Where a x² + b x + c <= 0 within [−1/2, 1/2]: `roots` are the crossings there, `inside` the
/// total length.
struct SideCut {
  std::array<double, 2> roots;
  int count = 0;
  double inside = 0;
};

SideCut cut_side(double a, double b, double c) {
  const auto in_side = [](double lo, double hi) {
    return Interval{std::max(lo, -0.5), std::min(hi, 0.5)}.length();
  };
  SideCut cut;
  const auto root = [&](double x) {
    if (x > -0.5 && x < 0.5) cut.roots[std::size_t(cut.count++)] = x;
    return x;
  };
  const double discriminant = b * b - 4.0 * a * c;
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  if (q == 0.0 || discriminant <= 0.0) {  // no sign change
    cut.inside = (discriminant <= 0.0 && a != 0.0 ? a : c) < 0.0 ? 1.0 : 0.0;
  } else if (a == 0.0) {
    const double x = root(c / q);
    cut.inside = b > 0.0 ? in_side(-0.5, x) : in_side(x, 0.5);
  } else {
    const double x0 = root(q / a), x1 = root(c / q), lo = std::min(x0, x1), hi = std::max(x0, x1);
    cut.inside = a > 0.0 ? in_side(lo, hi) : in_side(-0.5, lo) + in_side(hi, 0.5);
  }
  return cut;
}

}  // namespace

double bent_edge_coverage(double d, glm::dvec2 n, double bend) {
  if (bend == 0.0) return straight_edge_coverage(d, n);
  const glm::dvec2 m{-n.y, n.x};
  std::array<double, 8> crossings;  // of the parabola with the sides, as places along it
  std::size_t count = 0;
  double twice = 0.0;
  for (const int axis : {0, 1})  // sides u[axis] = ±1/2, the other coordinate running
    for (const double s : {-0.5, 0.5}) {
      const double n_run = n[1 - axis], m_run = m[1 - axis], along = m[axis] * s;
      const SideCut cut = cut_side(0.5 * bend * m_run * m_run, n_run + bend * along * m_run,
                                   d + n[axis] * s + 0.5 * bend * along * along);
      twice += 0.5 * cut.inside;
      for (int i = 0; i < cut.count; ++i)
        crossings[count++] = along + m_run * cut.roots[std::size_t(i)];
    }
  constexpr double kRounding =
      1e-15;  // of u: a parabola that touches a side from within counts as within
  for (std::size_t i = 1; i < count;
       ++i)  // at most 8; GCC 12 sees std::sort leave the array, wrongly
    for (std::size_t j = i; j > 0 && crossings[j - 1] > crossings[j]; --j)
      std::swap(crossings[j - 1], crossings[j]);
  for (std::size_t i = 1; i < count; ++i) {
    const double lo = crossings[i - 1], hi = crossings[i], t = 0.5 * (lo + hi);
    const glm::dvec2 u = t * m - (d + 0.5 * bend * t * t) * n;
    if (std::max(std::abs(u.x), std::abs(u.y)) <= 0.5 + kRounding)
      twice -= d * (hi - lo) - bend / 6.0 * (hi * hi * hi - lo * lo * lo);
  }
  return std::clamp(0.5 * twice, 0.0, 1.0);
}

}  // namespace mien
