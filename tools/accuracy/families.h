#pragma once
// Families of nasty cases: a curve and a point, drawn from a seed.

#include <mien/lib/geom/quad_bezier.h>

#include <cstdint>
#include <random>
#include <string>
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
  /// 10^u, u uniform: every order of magnitude alike.
  double magnitude(double lo, double hi);
  glm::dvec2 point() {
    const double x = unit();
    return {x, unit()};
  }
  glm::dvec2 direction();

 private:
  std::mt19937_64 bits_;
};

struct BezierCase {
  QuadBezier curve;
  glm::dvec2 p;
};

struct BezierFamily {
  std::string name;
  BezierCase (*draw)(Random&);
  bool float_exact =
      true;  ///< all coordinates are floats; else only double kernels are judged on it
  bool well_conditioned = true;  ///< the distance is not a small difference of large coordinates
};

const std::vector<BezierFamily>& bezier_families();

/// The case with every coordinate rounded to float.
BezierCase in_floats(const BezierCase& k);

/// `count` cases of a family, the same for the same seed everywhere.
std::vector<BezierCase> cases_of(const BezierFamily& family, size_t count, uint64_t seed);

}  // namespace mien::accuracy
