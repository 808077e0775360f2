#pragma once
// What random scenes are thrown with: numbers, shapes, gradients, areas; the same on every machine.

#include <mien/scene.h>

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace mien::test {

/// Numbers out of a seed. Scenes of pictures from (-1, -1) to (1, 1).
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}

  double unit() { return double(random_() >> 11) * 0x1p-53; }
  double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
  int below(int n) { return int(unit() * n); }
  bool chance(double p) { return unit() < p; }
  glm::dvec2 place() {
    const double x = between(-1, 1);
    return {x, between(-1, 1)};
  }
  glm::dvec2 way() {
    const double angle = between(0, 6.283185307179586);
    return {std::cos(angle), std::sin(angle)};
  }
  Color color(double translucent) {
    const double r = unit(), g = unit(), b = unit();
    return {r * r, g * g, b * b, chance(translucent) ? unit() : 1.0};
  }

 private:
  std::mt19937_64 random_;
};

/// A shape of any kind, as large as the picture or much smaller.
Shape random_shape(Dice& dice);

/// A gradient of any kind; its distances are those to one of two areas.
Gradient random_gradient(Dice& dice, Area own, Area other);

/// Adds an area made of one or two of those there are, or none.
void combine_randomly(Dice& dice, SceneBuilder& build, std::vector<Area>& areas);

/// One of them.
Area any_of(Dice& dice, const std::vector<Area>& areas);

}  // namespace mien::test
