#pragma once
// The numbers of a face, by slice.

#include <mien/face_model.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <numbers>

namespace mien {

class FaceNumbers {
 public:
  explicit FaceNumbers(const Face& face) : face_(face) {}

  double operator()(int slice, int i = 0) const {
    return face_.vector[std::size_t(face_.model->layout[slice].begin + i)];
  }
  double value_or(int slice, double other) const { return slice < 0 ? other : (*this)(slice); }
  int size(int slice) const { return face_.model->layout[slice].size; }
  glm::dvec2 point(int slice) const { return {(*this)(slice, 0), (*this)(slice, 1)}; }
  /// The direction at an angle in degrees; +x without one.
  glm::dvec2 way(int slice) const {
    if (slice < 0 || (*this)(slice) == 0) return {1.0, 0.0};
    const double angle = (*this)(slice)*std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
  }
  double sign_of_up() const { return face_.model->canvas.y_up ? 1 : -1; }

 private:
  const Face& face_;
};

}  // namespace mien
