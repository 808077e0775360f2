#pragma once
// The law of a point that muscles hold, for a unit mass:
//
//   p'' = k (p0 − p) − d p' + Σ c unit(o − p) (|p − o| − L),   c = weight · strength · e,   L = |p0 − o| − stroke · e
//
// with the point p, its rest p0, the stiffness k and damping d of the face, and for each muscle its
// origin o and pull e in [0, 1]. The force without damping is −∇E of the energy
//
//   E(p) = k/2 |p − p0|² + Σ c/2 (|p − o| − L)²
//
// so a point left to itself keeps losing E + |p'|²/2 and comes to rest at a local minimum of E. A number n
// that muscles hold has the same law along its own line, where it is linear:
//
//   n'' = k (n0 − n) − d n' + Σ c (stroke · e − (n − n0))
//
// Where L < 0 (a stroke longer than the muscle), E has the tip of a cone at o: on every side of it a force
// of size c |L| points towards o. At o itself the force is the smallest that the tip allows: none if the
// other forces together are no larger than c |L| (the point sticks there), else their excess over it.
// Elsewhere the law is exactly that of P. Mandel's facemotion.js.

#include <mien/face_model.h>

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// One muscle's spring on a point, at a pull.
struct MuscleSpring {
  glm::dvec2 origin;
  double stiffness;    ///< c [1/s²], > 0
  double free_length;  ///< L
  Side side;
};

/// A point with all its springs, at given pulls.
struct MusclePointLaw {
  glm::dvec2 rest;
  double stiffness, damping;
  bool on_axis;  ///< moves up and down only
  std::vector<MuscleSpring> springs;
};

/// A number with all its springs, as one: n'' = pull − stiffness · n − damping · n', n counted from rest.
struct MuscleNumberLaw {
  double stiffness, damping;
  double pull;
};

/// The law of `point` for a face at rest and a pull of each muscle. `law` is overwritten.
void muscle_law(const FaceModel& model, const FaceVector& rest, const MusclePoint& point,
                std::span<const double> pulls, MusclePointLaw& law);
MuscleNumberLaw muscle_law(const FaceModel& model, const MuscleNumber& number,
                           std::span<const double> pulls);

/// The energy of a point at `p`, and the force on it, without damping. Mirrored laws have mirrored forces,
/// to the bit: the forces of each side are added up first, left and right last.
double muscle_energy(const MusclePointLaw& law, glm::dvec2 p);
glm::dvec2 muscle_force(const MusclePointLaw& law, glm::dvec2 p);

/// The second derivatives of the energy, −∂force. At a tip they leave out the part across the tip's own
/// spring, which is infinite.
struct MuscleStiffness {
  double xx, xy, yy;
};
MuscleStiffness muscle_stiffness(const MusclePointLaw& law, glm::dvec2 p);

}  // namespace mien
