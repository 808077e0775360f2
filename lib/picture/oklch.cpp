#include "lib/picture/oklch.h"
#include "lib/math/degrees.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace mien {
namespace {

glm::dvec3 linear_of(const glm::dvec3& lab) {
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z);
  const double m = cube(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z);
  const double s = cube(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The encoded channel, 0 … 255, of linear light: the power 5/12 of a number x is the fifth power of the cube root of
/// √√x, which Newton's steps find. The C library's power may differ by a last bit, and so by a level, elsewhere.
int level_of(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  double encoded = linear * 12.92;
  if (linear > 0.0031308) {
    constexpr int kRounds = 12;  // from 1 down to 0.6, the root of the least, and six to spare
    const double x = std::sqrt(std::sqrt(linear));
    double root = 1;
    for (int i = 0; i < kRounds; ++i) root -= (root - x / (root * root)) / 3;
    const double squared = root * root;
    encoded = 1.055 * (squared * squared * root) - 0.055;
  }
  return int(std::lround(255 * encoded));
}

bool is_shown(const glm::dvec3& linear) {
  constexpr double kSlack = 1e-4;
  return std::min({linear.x, linear.y, linear.z}) >= -kSlack &&
         std::max({linear.x, linear.y, linear.z}) <= 1 + kSlack;
}

}  // namespace

glm::dvec3 Oklch::lab() const {
  const glm::dvec2 way = chroma * direction_at(hue);
  return {lightness, way.x, way.y};
}

Oklch Oklch::from_lab(glm::dvec3 lab) {
  return {lab.x, std::sqrt(lab.y * lab.y + lab.z * lab.z), degrees_of({lab.y, lab.z})};
}

Oklch Oklch::from_linear(glm::dvec3 c) {
  const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
  const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
  const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
  return from_lab({0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
                   1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
                   0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s});
}

double apart(const Oklch& a, const Oklch& b) {
  return glm::distance(a.lab(), b.lab());
}

std::string hex_of(const Oklch& color, double alpha) {
  const glm::dvec3 lab =
      Oklch{std::clamp(color.lightness, 0.0, 1.0), color.chroma, color.hue}.lab();
  glm::dvec3 linear = linear_of(lab);
  double lo = 0.0, hi = 1.0;  // shares of the chroma: lo can be shown, hi cannot
  for (int i = 0; i < 20 && (i > 0 || !is_shown(linear)); ++i) {
    const double share = 0.5 * (lo + hi);
    (is_shown(linear_of({lab.x, share * lab.y, share * lab.z})) ? lo : hi) = share;
    linear = linear_of({lab.x, lo * lab.y, lo * lab.z});
  }
  std::string text = "#";
  for (int i = 0; i < 3; ++i) text += fmt::format("{:02x}", level_of(linear[i]));
  if (alpha < 1) text += fmt::format("{:02x}", int(std::lround(255 * std::clamp(alpha, 0.0, 1.0))));
  return text;
}

}  // namespace mien
