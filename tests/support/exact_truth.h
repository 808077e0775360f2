#pragma once
// The exact picture of any scene, to about 1e-6 of a pixel's area: what 16-bit pictures and pictures
// blended in linear light are judged by.
//
// Along a horizontal line every layer is a set of spans. Their ends are where Scene::distance
// changes sign: found by halving, missing none longer than kShortest, since that distance is
// 1-Lipschitz (a stretch shorter than twice |d| at its middle has no end). Between two ends the
// visible colour is smooth, but for a gradient's kinks, which are found in the same way; there
// Gauss's rule integrates it. Across the lines the integral is adaptive, from 72 lines a pixel on, and finer where layers come or go: what is
// thinner than kThinnest and lies level may fall between them.
//
// It shares no code with the renderer but the scene's own distances, which have truths of their own
// in tests/sdf. Reliefs are left out: what they are lit to is no mean over an area.

#include <mien/render/image.h>
#include <mien/render/view/view.h>
#include <mien/sdf/scene/scene.h>

#include <functional>
#include <glm/vec4.hpp>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace mien::test {

class ExactTruth {
 public:
  static constexpr double kShortest = 1e-3;      ///< [px] spans that may be missed
  static constexpr double kThinnest = 1.0 / 32;  ///< [px] level layers that may be

  /// `tolerance`: what a pixel's mean may be off in the blending space. The scene must outlive this.
  ExactTruth(const Scene& scene, const View& view, double tolerance = 1e-6);

  /// The mean over pixel (x, y): premultiplied, in the blending space.
  glm::dvec4 pixel(int x, int y) const;
  /// The same in levels of `top`: encoded, straight, not rounded.
  glm::dvec4 levels(int x, int y, int top) const;

 private:
  /// A layer that can be seen in a pixel; `whole`: it covers it.
  struct Seen {
    int layer;
    bool whole;
  };
  struct Square {
    std::vector<Seen> seen;                                  ///< bottom to top
    double x, y;                                             ///< its left and upper edge [px]
    mutable std::unordered_map<double, std::size_t> orders;  ///< of lines strips share
  };

  Square square(int x, int y) const;
  /// The integral over a strip by three lines, and whether the layers lie in one order along them.
  struct Rows {
    glm::dvec4 sum;
    std::size_t order;
    bool alike;
  };
  Rows rows(const Square& square, double top, double bottom) const;
  std::size_t order_along(const Square& square, const std::vector<double>& ends, double y) const;
  glm::dvec4 refined(const Square& square, double top, double bottom, const Rows& coarse,
                     int depth) const;
  std::vector<double> ends_of(const Square& square, double y) const;
  glm::dvec4 line(const Square& square, double y, std::size_t& order) const;
  glm::dvec4 span(const Square& square, double a, double b, double y) const;
  glm::dvec4 refined_span(const Square& square, double a, double b, double y, glm::dvec4 coarse,
                          int depth) const;
  bool plain(const Square& square) const;
  bool jumps(const Square& square) const;
  glm::dvec4 color(const Square& square, glm::dvec2 p) const;
  glm::dvec4 paint(const Layer& layer, glm::dvec2 p) const;
  double place(const Gradient& gradient, glm::dvec2 p) const;
  void find_kinks(const Gradient& gradient, const Square& square, double y,
                  std::vector<double>& out) const;
  glm::dvec2 face(double x, double y) const;
  glm::dvec4 blended(const Color& color, double opacity) const;

  const Scene& scene_;
  View view_;
  double tolerance_, unit_;  ///< [face units] per pixel
};

/// Where f changes sign between a and b; f changes by at most `lipschitz` per unit.
void find_roots(const std::function<double(double)>& f, double lipschitz, double a, double b,
                double shortest, std::vector<double>& out);

struct ExactError {
  long over = 0;      ///< pixels off by more than allowed, over all images
  std::string where;  ///< one of them
};

/// Compares pixels of 8- and 16-bit images of one picture with the truth, one in `every`: no channel
/// may be off by more than `allowed` levels, the truth not rounded.
ExactError compare_exactly(std::span<const Image> images, const ExactTruth& truth,
                           std::span<const double> allowed, int every = 1);

}  // namespace mien::test
