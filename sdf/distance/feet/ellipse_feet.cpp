// The two feet on an ellipse, one place at a time.
//
// With (x, y) in the first quadrant of the longer radius a and the shorter b, F = a² − b², A = a x and C = b y, the
// nearest foot is in that quadrant, at the only θ with A / cos θ − C / sin θ = F: the left side rises from −∞ to +∞.
// The other minimum lies across the longer axis, at (a sin φ, −b cos φ) with A / sin φ + C / cos φ = F, where the left
// side falls: left of its least value, at tan³ φ = A / C. There is none where that value is over F, outside of the
// evolute.

#include "lib/math/norm.h"
#include "lib/math/unit_zeros.h"
#include "sdf/distance/feet/foot_pieces_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mien {
namespace {

/// In the frame of the longer radius: the place, in the first quadrant.
struct SeenEllipse {
  double a, b, x, y;

  double focal() const { return (a - b) * (a + b); }
  /// (E − p) · E' and its slope at the angle with this cosine and sine, over how fast it turns with the parameter.
  ValueSlope slope(double c, double s, double turn) const {
    const glm::dvec2 q{a * c - x, b * s - y}, g{-a * s, b * c};
    return {glm::dot(q, g), turn * (glm::dot(g, g) - q.x * a * c - q.y * b * s)};
  }
};

/// A direction by u, the tangent of half its angle.
glm::dvec2 direction_of(double u) {
  return glm::dvec2{(1.0 - u) * (1.0 + u), 2.0 * u} / (1.0 + u * u);
}

/// By Halley's method: the C library's is not the same everywhere.
double cube_root(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  double y = std::ldexp(1.0, exponent / 3);
  for (int i = 0; i < 6; ++i) {
    const double cube = y * y * y;
    y *= (cube + 2.0 * x) / (2.0 * cube + x);
  }
  return y;
}

/// (cos θ, sin θ) of the nearest foot.
glm::dvec2 near_side(const SeenEllipse& e) {
  const auto f = [&](double u) {
    const glm::dvec2 at = direction_of(u);
    return e.slope(at.x, at.y, 2.0 / (1.0 + u * u));
  };
  if (e.b * e.y == 0.0 && !(e.a * e.x < e.focal())) return {1.0, 0.0};
  const double first = f(0.0).value, last = f(1.0).value;
  if (!(last > 0.0)) return {0.0, 1.0};
  return direction_of(unit_zero_between(f, 0.0, 1.0, std::min(first, -1e-300), last));
}

/// (cos θ, sin θ) of the other one, sin θ < 0; (0, 0): there is none.
glm::dvec2 far_side(const SeenEllipse& e) {
  const double focal = e.focal(), ax = e.a * e.x, by = e.b * e.y;
  if (!(ax < focal - by)) return {0.0, 0.0};
  if (ax == 0.0) return {0.0, -1.0};
  const auto f = [&](double u) {
    const glm::dvec2 at = direction_of(u);
    return e.slope(at.y, -at.x, 2.0 / (1.0 + u * u));
  };
  const double steep = cube_root(by / ax), shallow = 1.0 / std::sqrt(1.0 + steep * steep);
  const double most = shallow / (1.0 + shallow * steep);
  const double sine = ax / (focal - by);
  const double least = sine / (1.0 + std::sqrt((1.0 - sine) * (1.0 + sine)));
  const double first = f(least).value, last = f(most).value;
  if (!(last > 0.0) || !(least < most)) return {0.0, 0.0};
  const double u = first < 0.0 ? unit_zero_between(f, least, most, first, last) : least;
  const glm::dvec2 at = direction_of(u);
  return {at.y, -at.x};
}

}  // namespace

Feet nearest_feet(const Ellipse& ellipse, glm::dvec2 p) {
  const glm::dvec2 off = p - ellipse.center, axis = ellipse.axis, r = ellipse.radii;
  const glm::dvec2 local{glm::dot(off, axis), axis.x * off.y - axis.y * off.x};
  const double size = (r.x + r.y) + (std::abs(local.x) + std::abs(local.y));
  if (!std::isfinite(size)) return {};
  const double k = size > 0.0 ? std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000)) : 1.0;
  const bool tall = r.x < r.y;
  SeenEllipse seen{k * r.x, k * r.y, k * std::abs(local.x), k * std::abs(local.y)};
  if (tall) std::swap(seen.a, seen.b), std::swap(seen.x, seen.y);
  double hand = 1.0;
  const auto foot_on = [&](glm::dvec2 at, bool is_far) {
    if (tall) std::swap(at.x, at.y);
    const double c = std::copysign(1.0, local.x) * at.x, s = std::copysign(1.0, local.y) * at.y;
    const glm::dvec2 radii = k * r, rim{radii.x * c, radii.y * s};
    const FootFigures found =
        foot_figures(rim - k * local, {-radii.x * s, radii.y * c}, -0.5 * rim, 0.0, 0.0);
    if (!is_far) hand = found.hand;
    const glm::dvec2 n = hand * found.normal, across{-axis.y, axis.x};
    return Foot{0, angle_of(c, s), hand * found.r / k, n.x * axis + n.y * across + 0.0,
                hand * found.bend * k};
  };
  Feet feet{foot_on(near_side(seen), false), {}};
  const glm::dvec2 other = far_side(seen);
  if (other != glm::dvec2{0.0}) feet.next = foot_on(other, true);
  return feet;
}

}  // namespace mien
