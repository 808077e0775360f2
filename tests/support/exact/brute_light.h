#pragma once
// Means of a lit surface over parts of pixels by very many places: the judge of render/shade.

#include "render/cover/part_form.h"
#include "render/shade/light/lit_surface.h"

#include <array>
#include <functional>
#include <vector>

namespace mien::test {

struct LitPart {
  double area = 0;
  glm::dvec2 centroid{0.0};
  Mix mean{0.0};
};

/// A part's form by rows of places: each stretch of them ends upright.
struct CountedForm {
  PartEntry left;
  std::vector<PartStretch> stretches;
  PartForm form() const { return {left, stretches}; }
};

class BruteLight {
 public:
  explicit BruteLight(const LitSurface& surface) : surface_(surface) {}

  /// What of pixel (x, y) lies in `zone` and where `keeps` says so, by `places` squared places.
  LitPart part(int zone, int x, int y, int places,
               const std::function<bool(glm::dvec2)>& keeps = {});

  /// That part's form, by 64 rows.
  CountedForm form(int zone, int x, int y, const std::function<bool(glm::dvec2)>& keeps = {}) const;

  /// The distance at the pixel's middle.
  double middle(int x, int y) const;

 private:
  const LitSurface& surface_;
};

/// By how many levels of 255 two means differ, encoded; `area` scales it.
double levels_apart(const Mix& a, const Mix& b, Blend blend);

}  // namespace mien::test
