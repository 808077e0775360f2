#pragma once
// A mouth's points in a face vector, seen with y up.

#include <mien/face_model.h>
#include "lib/rig/mouth/lip_line.h"

namespace mien {

class MouthVector {
 public:
  MouthVector(const FaceModel& model, FaceVector& vector)
      : model_(model), up_(model.canvas.y_up ? 1 : -1), now_(vector) {}

  glm::dvec2 get(int slice) const { return get(now_, slice); }
  glm::dvec2 get(const FaceVector& v, int slice) const {
    const double* at = &v[std::size_t(model_.layout[slice].begin)];
    return {at[0], up_ * at[1]};
  }
  /// A place of the face, with y up.
  glm::dvec2 seen(glm::dvec2 place) const { return {place.x, up_ * place.y}; }
  void put(int slice, glm::dvec2 p) {
    double* at = numbers(slice);
    at[0] = p.x, at[1] = up_ * p.y;
  }
  void add(int slice, glm::dvec2 way) { put(slice, get(slice) + way); }
  void put(const MouthPoint& point, glm::dvec2 p) {
    put(point.slice, p);
    if (point.twin >= 0) put(point.twin, p);
  }
  double* numbers(int slice) { return &now_[std::size_t(model_.layout[slice].begin)]; }
  const double* numbers(const FaceVector& v, int slice) const {
    return &v[std::size_t(model_.layout[slice].begin)];
  }
  int size(int slice) const { return model_.layout[slice].size; }

  /// Both edges as they stand in a vector of the face.
  LipLine line(const Mouth& mouth, const FaceVector& v) const {
    LipLine line{.has_handles = mouth.has_handles};
    for (std::size_t s = 0; s < 2; ++s) line.corners[s] = place(v, mouth.corners[s]);
    for (std::size_t bend = 0; bend < 3; ++bend) {
      line.upper[bend] = place(v, mouth.upper[bend]);
      line.lower[bend] = place(v, mouth.lower[bend]);
    }
    return line;
  }
  LipLine line(const Mouth& mouth) const { return line(mouth, now_); }
  void put(const Mouth& mouth, const LipLine& line) {
    for (std::size_t s = 0; s < 2; ++s) put(mouth.corners[s], line.corners[s]);
    for (std::size_t bend = 0; bend < 3; ++bend) {
      if (mouth.upper[bend].slice < 0) continue;
      put(mouth.upper[bend], line.upper[bend]);
      put(mouth.lower[bend], line.lower[bend]);
    }
  }

 private:
  /// The middle of both copies, where somebody has moved one alone.
  glm::dvec2 place(const FaceVector& v, const MouthPoint& point) const {
    if (point.slice < 0) return {};
    const glm::dvec2 p = get(v, point.slice);
    if (point.twin < 0) return p;
    const glm::dvec2 q = get(v, point.twin);
    return p == q ? p : 0.5 * (p + q);
  }

  const FaceModel& model_;
  const double up_;
  FaceVector& now_;
};

}  // namespace mien
