#pragma once
// Families of nasty cases: a figure and a point, drawn from a seed.

#include <mien/cubic_bezier.h>
#include <mien/ellipse.h>
#include <mien/quad_bezier.h>
#include <mien/shape.h>

#include <cstdint>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace mien::accuracy {

/// Numbers that are the same on every machine and standard library, unlike std's distributions.
class Random {
 public:
  explicit Random(uint64_t seed) : bits_(seed) {}
  uint64_t bits() { return bits_(); }
  double unit() { return double(bits_() >> 11) * 0x1p-53; }  ///< [0, 1)
  double between(double a, double b) { return a + (b - a) * unit(); }
  double sign() { return bits_() & 1 ? 1 : -1; }
  bool chance(double p) { return unit() < p; }
  /// 10^u, u uniform: every order of magnitude is equally likely.
  double magnitude(double lo, double hi);
  glm::dvec2 point() {
    const double x = unit();
    return {x, unit()};
  }
  glm::dvec2 direction();

 private:
  std::mt19937_64 bits_;
};

/// What distances are measured to.
using Figure = std::variant<QuadBezier, Ellipse, ParabolaSide, TaperedStroke, CubicBezier>;

struct Case {
  Figure figure;
  glm::dvec2 p;
};

struct Family {
  std::string name;
  Case (*draw)(Random&);
  bool float_exact = true;  ///< coordinates are floats; else only double kernels are judged on it
  bool well_conditioned = true;  ///< the distance is not a small difference of large coordinates
};

/// Every family: quadratic Bézier curves first, the other figures after them.
const std::vector<Family>& families();

/// The families of quadratic Bézier curves alone.
std::vector<Family> bezier_families();

/// The case with every coordinate rounded to float (directions stay as they are).
Case in_floats(const Case& k);

/// `count` cases of a family, the same for the same seed everywhere.
std::vector<Case> cases_of(const Family& family, size_t count, uint64_t seed);

/// The families of the other figures, for families() to list.
std::vector<Family> conic_families();
std::vector<Family> stroke_families();

}  // namespace mien::accuracy
