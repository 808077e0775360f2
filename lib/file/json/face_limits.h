#pragma once
// How much a face file may ask for.

#include <cstddef>

namespace mien {

/// Limits of what a face file may ask for. Exceeding one is an error that names it.
struct FaceLimits {
  std::size_t bytes = 64u << 20;    ///< of text
  int nesting = 64;                 ///< of arrays and objects; of features clipped to features
  std::size_t values = 2'000'000;   ///< JSON values of any kind in the text
  std::size_t numbers = 1'000'000;  ///< in the face vector
  std::size_t features = 100'000;   ///< drawn or not, left and right counted
  double magnitude = 1e9;           ///< of any number
};

}  // namespace mien
