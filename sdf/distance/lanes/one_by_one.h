#pragma once
// Batches by a kernel where it applies, and by scalar distances one after the other where it does not.

#include "sdf/distance/spans.h"

#include <glm/vec2.hpp>
#include <optional>
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

/// d[i] = the distance from (x[i], y[i]) to the figure, by the kernel. Figures for which the kernel promises
/// nothing have no frame; they are measured one by one.
template <class Figure, class Frame, class T, class Kernel>
void distances_by(Kernel* kernel, const std::optional<Frame>& frame, const Figure& figure,
                  std::span<const T> x, std::span<const T> y, std::span<T> d) {
  fit_spans(x, y, d);
  if (!frame) return distances_one_by_one(figure, x, y, d);
  kernel(figure, *frame, x.data(), y.data(), d.size(), d.data());
}

}  // namespace mien::batch
