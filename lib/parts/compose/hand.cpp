#include "lib/parts/compose/hand.h"

#include <mien/face_code.h>

#include "lib/math/degrees.h"
#include "lib/parts/code/keyed_chance.h"

namespace mien {

Hand::Hand(std::uint64_t person, double amplitude, double width)
    : waves_{}, person_(person), amplitude_(amplitude), width_(width) {
  constexpr double kSlowest = 0.7, kFastest = 2.6, kTurn = 360;
  const KeyedChance chance(person);
  std::uint64_t question = 0;
  for (auto& axis : waves_) {
    double sum = 0;
    for (int k = 0; k < kWaves; ++k) {
      const double often = kSlowest + (kFastest - kSlowest) * k / (kWaves - 1);
      const glm::dvec2 way = direction_at(kTurn * chance.share(question++));
      const double weight = 1 / often;
      axis[std::size_t(k)] = {kTurn * often * way, kTurn * chance.share(question++), weight};
      sum += weight;
    }
    for (Wave& wave : axis) wave.weight /= sum;
  }
}

glm::dvec2 Hand::moved(glm::dvec2 p) const {
  glm::dvec2 by{0.0};
  for (int axis = 0; axis < 2; ++axis)
    for (const Wave& wave : waves_[std::size_t(axis)])
      by[axis] +=
          wave.weight * direction_at(wave.turns.x * p.x + wave.turns.y * p.y + wave.phase).y;
  return p + amplitude_ * by;
}

double Hand::thickness(std::string_view line, int at) const {
  const KeyedChance chance(person_ ^ seed_from_word(line));
  return 1 + width_ * chance.bell(std::uint64_t(at));
}

}  // namespace mien
