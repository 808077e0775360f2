#pragma once
// The cornea under the lid. An eye is a ball of radius R with a second, smaller and more curved cap
// in front, the cornea, whose rim is the circle that cuts a cap of height h off the ball. A lid
// lies on the ball and gives way where the cornea passes under it.
//
// With the lid point in direction d̂ from the ball's centre and the eye's axis ĝ (both unit),
//
//   u² = (1 − d̂·ĝ) / (1 − cos α) = (1 − d̂·ĝ) · R/h        cos α = 1 − h/R
//
// is 0 on the axis and 1 on the rim: u = sin(θ/2) / sin(α/2), the chord |d̂ − ĝ| in units of the
// rim's own chord, without a root or an arc cosine.
//
//   native   push = bulge · (1 − u²)²  for u < 1, else exactly 0; outwards, along d̂
//   compat   push = bulge · max(0, a − min(1, |d̂ − ĝ|)), a = √(h(2R − h)); along the axis ĝ
//
// The native push is smooth (its slope vanishes on the axis and at the rim), is largest on the axis, and
// scales: R, h and bulge times s give the push times s. The compat push is a cone. It compares the length a
// with a pure number, so it is right for R = 1 only.
//
// Clearance. Let the cornea be the part of a sphere that passes through the rim and stands e above
// the ball on the axis; its distance from the centre is S(c) = k c + √(r² − k² (1 − c²)) with
// c = d̂·ĝ. As long as the ball's centre is inside that sphere (k <= r, that is e <= hR/(R − h): the
// cornea stays under the cone that touches the ball along the rim) S is convex in c, so
// S − R <= e v with v = 1 − u². A lid pushed by e v² on a skin of thickness t clears it if
// t + e v² >= e v, that is if t >= e/4: then the clearance is at least e (v − ½)² >= 0, everywhere,
// for every gaze. So an unpushed lid is drawn on the ball of radius R + bulge/4, and pushed from there.
//
// Source. The compat law is J. Dunlop's, "Eyelid C++ node"; native law and bound are derived here.

#include <mien/eye.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace mien {

/// An eye with a cornea [face units].
struct EyeBody {
  glm::dvec2 center;  ///< in the picture
  double radius;      ///< R > 0
  double cornea;      ///< h: height of the cap that the cornea's rim cuts off the ball; 0 < h <= R
  double bulge;       ///< of the lid on the axis (native), or the cone's steepness (compat)
  BulgeLaw law = BulgeLaw::native;

  bool operator==(const EyeBody&) const = default;
};

/// How far a lid point in direction `d` (unit) is pushed by an eye with axis `g` (unit). 0 outside the
/// cornea, and if there is none (R or h not positive).
double lid_push(const EyeBody& eye, glm::dvec3 d, glm::dvec3 g);

/// The least thickness of a lid that never cuts into the eye: a quarter of the bulge.
inline double least_lid_thickness(const EyeBody& eye) {
  return std::max(0.0, eye.bulge) / 4;
}

/// The radius of the ball that an unpushed lid is drawn on: the eye's plus the lid's least thickness
/// (native).
inline double lid_radius(const EyeBody& eye) {
  return eye.law == BulgeLaw::compat ? eye.radius : eye.radius + least_lid_thickness(eye);
}

/// The direction of an unpushed lid at a point of the picture, from the ball's centre: on the front of its
/// ball or, beside the ball, in the picture's plane.
glm::dvec3 lid_direction(const EyeBody& eye, glm::dvec2 p);

/// The shift in the picture that the push gives a point of a lid's edge at `p`.
glm::dvec2 edge_push(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g);

/// The inverse: where a point of a lid's edge is before the push moves it to `p`. Accurate to a
/// rounding of its distance from the centre (native); the compat law takes the push at `p` instead.
glm::dvec2 standing_place(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g);

/// How far the push raises the lid towards the viewer at a point of the picture. Relief light shades a
/// closed lid by this height. 0 outside the cornea.
double lid_rise(const EyeBody& eye, glm::dvec2 p, glm::dvec3 g);

/// The most that a cornea can stand above the ball: hR/(R − h). Infinite for h = R.
double most_bulge(double radius, double cornea);

/// lid_rise approximated by one smooth hill over an ellipse, height · (1 − ρ²)², for relief light to fall
/// on. The rim is a circle of radius a perpendicular to the axis. It is seen as an ellipse of half-axes a
/// ĝz along the gaze and a across it. The hill's centre is halfway between the rim's and the apex, where
/// lid_rise is highest. It differs from lid_rise by at most 0.05 of the bulge for an eye that looks
/// straight ahead, and 0.17 for one that looks 27° aside (R/h = 4).
struct CorneaDome {
  glm::dvec2 center, radii;
  double height;
  double tilt;  ///< [degrees] of radii.x, along the gaze or across; from +x towards +y, −45 … 45
};
CorneaDome cornea_dome(const EyeBody& eye, glm::dvec3 g);

}  // namespace mien
