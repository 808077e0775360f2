#include "tests/support/exact/exact_compare.h"

#include <fmt/format.h>

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace mien::test {
namespace {

glm::dvec4 seen(const glm::dvec4& straight, double top) {
  return {glm::dvec3(straight) * (straight.a / top), straight.a};
}

}  // namespace

Image drawn_image(const Scene& scene, const View& view, Depth depth, RenderStats* stats) {
  auto image = render(scene, view, {.depth = depth}, stats);
  if (!image) throw std::runtime_error(image.error().what);
  return *std::move(image);
}

glm::dvec4 drawn_levels(const Image& image, int x, int y) {
  glm::dvec4 drawn;
  for (int k = 0; k < 4; ++k)
    drawn[k] = image.depth == Depth::u16
                   ? reinterpret_cast<const std::uint16_t*>(image.row(y))[4 * x + k]
                   : image.row(y)[4 * x + k];
  return drawn;
}

double apart(const glm::dvec4& drawn, const glm::dvec4& exact, double top) {
  return largest(seen(drawn, top) - seen(exact, top));
}

ExactError compare_exactly(std::span<const Image> images, const ExactTruth& truth,
                           std::span<const double> allowed, int every) {
  ExactError error;
  for (int y = 0; y < images[0].height; ++y)
    for (int x = y % every; x < images[0].width; x += every) {
      const glm::dvec4 exact = truth.levels(x, y, 1);
      for (std::size_t i = 0; i < images.size(); ++i) {
        const int top = images[i].depth == Depth::u16 ? 65535 : 255;
        const glm::dvec4 t = double(top) * exact, drawn = drawn_levels(images[i], x, y);
        const double off = apart(drawn, t, top) / allowed[i];
        if (off > 1) ++error.over;
        if (!(off > error.worst)) continue;
        error.worst = off;
        error.where = fmt::format("({}, {}) of {}: truth {} {} {} {}, drawn {} {} {} {}", x, y, top,
                                  t.r, t.g, t.b, t.a, drawn.r, drawn.g, drawn.b, drawn.a);
      }
    }
  return error;
}

}  // namespace mien::test
