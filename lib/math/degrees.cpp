#include "lib/math/degrees.h"

#include <cmath>
#include <numbers>

namespace mien {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

/// 1 − x²/2! + x⁴/4! − …
double cosine_of(double squared) {
  double sum = 1;
  for (int k = 16; k >= 2; k -= 2) sum = 1 - squared / (k * (k - 1)) * sum;
  return sum;
}

/// x − x³/3! + x⁵/5! − …
double sine_of(double x, double squared) {
  double sum = 1;
  for (int k = 17; k >= 3; k -= 2) sum = 1 - squared / (k * (k - 1)) * sum;
  return x * sum;
}

}  // namespace

glm::dvec2 direction_at(double degrees) {
  const double turned = std::remainder(degrees, 360.0);  // −180 … 180
  const double quarters = std::nearbyint(turned / 90);
  const double x = (turned - 90 * quarters) * kRadian;
  const double cosine = cosine_of(x * x), sine = sine_of(x, x * x);
  switch (int(quarters) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

double degrees_of(glm::dvec2 direction) {
  constexpr double kEighth = 45;
  constexpr int kRounds = 3;
  const double x = std::abs(direction.x), y = std::abs(direction.y);
  const double length = std::sqrt(x * x + y * y);
  if (!(length > 0)) return 0;
  double angle = y > x ? 1.5 * kEighth : 0.5 * kEighth;  // of the first quarter
  for (int i = 0; i < kRounds; ++i) {
    const glm::dvec2 at = direction_at(angle);
    const double s = (y * at.x - x * at.y) / length;
    angle += (s + s * s * s / 6) / kRadian;
  }
  if (direction.x < 0) angle = 180 - angle;
  return direction.y < 0 ? -angle : angle;
}

}  // namespace mien
