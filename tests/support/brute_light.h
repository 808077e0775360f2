#pragma once
// Means of a lit surface over parts of pixels by very many places: the judge of render/shade.

#include <mien/render/shade/lit_surface.h>

#include <functional>

namespace mien::test {

struct LitPart {
  double area = 0;
  glm::dvec2 centroid{0.0};
  Mix mean{0.0};
};

class BruteLight {
 public:
  explicit BruteLight(const LitSurface& surface) : surface_(surface) {}

  /// What of pixel (x, y) lies in `zone` and where `keeps` says so, by `places` squared places.
  LitPart part(int zone, int x, int y, int places,
               const std::function<bool(glm::dvec2)>& keeps = {});

  /// The distance at the pixel's middle.
  double middle(int x, int y) const;

 private:
  const LitSurface& surface_;
};

/// By how many levels of 255 two means differ, encoded; `area` scales it.
double levels_apart(const Mix& a, const Mix& b, Blend blend);

}  // namespace mien::test
