#pragma once
// Similarities whose types name the spaces that they map from and to.

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

namespace mien {

struct FaceSpace;   ///< the face file's own units and y direction, as its canvas defines them
struct PixelSpace;  ///< 1 = pixel, y down, origin at the CENTRE of the whole picture: mirror images
                    ///< about the middle of the picture have exactly opposite coordinates
struct GridSpace;  ///< 1 = pixel, y down, origin at the TOP LEFT corner of the whole picture: pixel
                   ///< (x, y) is the square from (x, y) to (x + 1, y + 1)

/// Maps points of From to points of To. Names read from right to left: pixel_from_face.
/// Invariant: it is a similarity, so `linear` is a rotation, possibly mirrored, times a positive scale.
template <class To, class From>
struct Map {
  glm::dmat2 linear{1.0};  ///< columns, as GLM has them
  glm::dvec2 shift{0.0};

  glm::dvec2 operator()(glm::dvec2 p) const { return linear * p + shift; }
  /// Maps a direction (a difference of points).
  glm::dvec2 direction(glm::dvec2 v) const { return linear * v; }
  /// The length in To of a unit length in From.
  double scale() const { return std::hypot(linear[0].x, linear[0].y); }
  /// Whether the map turns left into right.
  bool mirrors() const { return linear[0].x * linear[1].y - linear[0].y * linear[1].x < 0; }
};

/// (a_from_b * b_from_c) is a_from_c. If the inner spaces differ it does not compile.
template <class A, class B, class C>
Map<A, C> operator*(const Map<A, B>& a_from_b, const Map<B, C>& b_from_c) {
  return {a_from_b.linear * b_from_c.linear, a_from_b.linear * b_from_c.shift + a_from_b.shift};
}

/// The inverse map.
template <class A, class B>
Map<B, A> inverse(const Map<A, B>& a_from_b) {
  const glm::dmat2 m = a_from_b.linear;
  const double det = m[0].x * m[1].y - m[0].y * m[1].x;
  const glm::dmat2 back{m[1].y / det, -m[0].y / det, -m[1].x / det, m[0].x / det};
  return {back, -(back * a_from_b.shift)};
}

}  // namespace mien
