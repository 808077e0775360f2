#pragma once
// What people are told apart by, taken from a recipe once so that many can be compared.

#include "lib/parts/library/part_library.h"
#include "lib/picture/oklch.h"

#include <array>

namespace mien {

struct Recipe;

struct Appearance {
  std::array<int, 6>
      parts;  ///< permanent numbers of hair, beard, glasses, headwear, eyes, nose; −1: none
  Oklch skin;
  std::array<Oklch, 3> colors;    ///< of hair, cloth and backdrop
  double age;                     ///< [years]
  std::array<double, 5> numbers;  ///< jaw, size of the eyes, chin, lips, thickness of the brows
};

/// Of a complete recipe, as one from a seed or a code is.
Appearance appearance_of(const Recipe& recipe);

/// How different two people look, about 1 for other hair. A distance: 0 for equals, symmetric, and no
/// longer than a way round.
double difference(const Appearance& one, const Appearance& other);

}  // namespace mien
