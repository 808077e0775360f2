#pragma once
// Small turns of the head: parallax of feature depth, with foreshortening.
//
// The front of the head is half an ellipsoid. A point (x, y) of the face lies on it and is turned with it
// about a pivot: by the pitch about the horizontal axis, then by the yaw about the vertical one, so that eyes stay level,
// then by the roll in the picture. (Of a head without a skull the pitch comes after the yaw.) It is seen straight from the
// front again. What looks alike from every side (the
// outline of a head, of hair) is not foreshortened, only shifted by its depth and rolled. A plate,
// such as a pair of glasses, stands level at one depth and turns as one rigid body: straight lines on it stay
// straight. Sizes are foreshortened as the surface at their place is. Meant for up to about 30°; beyond that, features slide
// round the edge.
//
// A head with a skull is not round: seen from the side it is longer. The half-width of an ellipsoid of half-axes a and c
// turned by the yaw is √(a² cos² + c² sin²), and what that is more than a is added on the side that turns away, above the
// ear. On the other side the cheekbone stands out between a hollow temple and a narrower jaw.
//
// A head that comes nearer is seen larger, about the same pivot: places, sizes and lengths grow alike.
//
// Positive yaw turns the face to the picture's right (the subject's left), positive pitch upwards,
// positive roll tilts it from +x towards up. ±yaw are mirror images, bit for bit, on a canvas
// symmetric about x = 0.
//
// Source. Turning the head with the mouse: S. Lee, "Face Rendering in GLSL"; this form for drawn
// features is mien's own.

#include <mien/face.h>
#include <mien/head_turn.h>

#include <glm/vec2.hpp>

#include <span>

namespace mien {

/// A turn, ready to be applied to points.
class Turn {
 public:
  /// Angles in degrees; `y_up`: larger y is higher; `nearer`: how much larger the head is seen.
  Turn(const HeadTurn& head, double yaw, double pitch, double roll, bool y_up, double nearer = 0);

  /// Where a point `depth` above the surface is seen.
  glm::dvec2 surface(glm::dvec2 p, double depth) const;
  /// Where a point of an outline, at `depth` from the head's middle, is seen.
  glm::dvec2 flat(glm::dvec2 p, double depth) const;
  /// Where a point of the shoulders is seen.
  glm::dvec2 body(glm::dvec2 p) const;
  /// Where a point of a plate, at `depth` from the head's middle, is seen.
  glm::dvec2 plate(glm::dvec2 p, double depth) const;
  /// The foreshortening of a plate, sideways and upwards, before the roll, times the growth.
  glm::dvec2 plate_foreshortening() const;
  /// The foreshortening of the surface at a point, sideways and upwards, before the roll, times the growth; 0
  /// where it is turned away.
  glm::dvec2 foreshortening(glm::dvec2 p) const;
  /// An offset in the picture, rolled.
  glm::dvec2 rolled(glm::dvec2 way) const;
  /// What lengths are multiplied with that no turn changes.
  double growth() const { return growth_; }
  /// How far angles turn, from +x towards +y [degrees].
  double tilt() const { return up_ * roll_degrees_; }

 private:
  glm::dvec2 turned(glm::dvec3 from_pivot) const;
  glm::dvec2 rolled_up(glm::dvec2 p) const;
  double height(glm::dvec2 p) const;
  double outline_shift(glm::dvec2 p) const;

  const HeadTurn& head_;
  double up_, roll_degrees_, growth_;
  glm::dvec2 yaw_, pitch_, roll_, body_yaw_;  ///< cosine and sine
  double middle_;                             ///< how far the head's middle is above the pivot
  double lean_ = 0;    ///< how far outlines lean with the head's upright axis, a share
  double longer_ = 0;  ///< how much wider the skull is seen, a share of its half-width
};

/// Lets the model's head turn act on `vector`. At rest it changes nothing.
void turn_head(const FaceModel& model, std::span<const double> values, FaceVector& vector);

}  // namespace mien
