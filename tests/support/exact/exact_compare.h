#pragma once
// Pictures against the exact one.

#include <mien/image.h>
#include <mien/render.h>

#include <glm/vec4.hpp>
#include <span>
#include <string>

#include "tests/support/exact/exact_truth.h"

namespace mien::test {

struct ExactError {
  long over = 0;      ///< pixels off by more than allowed, over all images
  double worst = 0;   ///< the largest error, in shares of what is allowed
  std::string where;  ///< of that one
};

/// A picture that is to be judged. Throws std::runtime_error with the error's words where the scene is refused.
Image drawn_image(const Scene& scene, const View& view, Depth depth, RenderStats* stats = nullptr);

/// The levels of pixel (x, y) of a picture of 8 or 16 bits: straight, as they are stored.
glm::dvec4 drawn_levels(const Image& image, int x, int y);

/// How far colours of 0 … top are apart, seen: premultiplied, so that colours that can hardly be
/// seen hardly count, and opacities as they are.
double apart(const glm::dvec4& drawn, const glm::dvec4& exact, double top);

/// Compares pixels of 8- and 16-bit images of one picture with the truth, one in `every`: they may
/// be `allowed` levels apart, the truth not rounded.
ExactError compare_exactly(std::span<const Image> images, const ExactTruth& truth,
                           std::span<const double> allowed, int every = 1);

}  // namespace mien::test
