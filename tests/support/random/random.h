#pragma once
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <random>

namespace mien::test {

/// Random numbers that are the same on every machine (std::uniform_real_distribution's are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : bits_(seed) {}

  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  bool chance(double p) { return unit() < p; }
  int below(int n) { return static_cast<int>(bits_() % static_cast<std::uint64_t>(n)); }
  double sign() { return chance(0.5) ? -1.0 : 1.0; }
  /// 10^u, u uniform: all sizes alike.
  double size(double lo_exponent, double hi_exponent) {
    return std::pow(10.0, between(lo_exponent, hi_exponent));
  }
  glm::dvec2 point(double lo, double hi) {
    const double x = between(lo, hi);
    return {x, between(lo, hi)};
  }
  glm::dvec2 direction() {
    const double angle = between(0.0, 6.283185307179586);
    return {std::cos(angle), std::sin(angle)};
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace mien::test
