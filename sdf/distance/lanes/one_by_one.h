#pragma once
// Batches that are scalar distances one after the other: where no kernel is worth it, or none
// applies.

#include <glm/vec2.hpp>
#include <span>

namespace mien::batch {

/// d[i] = distance(figure, (x[i], y[i])), computed in double precision.
template <class Figure, class T>
void distances_one_by_one(const Figure& figure, std::span<const T> x, std::span<const T> y,
                          std::span<T> d) {
  for (size_t i = 0; i < d.size(); ++i) {
    d[i] = T(distance(figure, glm::dvec2{double(x[i]), double(y[i])}));
  }
}

}  // namespace mien::batch
