#pragma once
// How features are painted when one colour isn't enough: gradients, reliefs, groups, effects. As
// everywhere in a face, numbers that can move are slices of the face vector, named by their index.

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mien {

/// Place 0 at the point `from`, 1 at `to`.
struct LinearPaint {
  int from, to;
};

/// Place 0 at the centre, 1 on the ellipse.
struct RadialPaint {
  int center, radii;
  int tilt = -1;  ///< −1: none
};

/// Place 0 so deep inside the outline of a figure, 1 so far outside of it.
struct DistancePaint {
  int inside, outside;  ///< lengths, one of them more than 0
};

struct GradientPaint {
  std::variant<LinearPaint, RadialPaint, DistancePaint> along;
  int places;               ///< slice of the stops' places, one number each
  std::vector<int> colors;  ///< slices, as many
  enum class Extend : unsigned char { pad, repeat, reflect } extend = Extend::pad;
};

/// A hill on a surface: see Dome in sdf/scene/paint.h.
struct FaceDome {
  int center, radii, height;
  int tilt = -1;  ///< −1: none
};

/// The surface over a feature, from the outline of its own figure (not of what it is clipped to):
/// see Relief in sdf/scene/paint.h.
struct FaceRelief {
  enum class Profile : unsigned char { flat, bevel, round, custom } profile = Profile::flat;
  int width = -1, height = -1;        ///< −1: flat
  int table = -1;                     ///< custom: heights in units of `height`
  bool sunk = false;                  ///< a dent: heights count downwards
  int specular = -1, shininess = -1;  ///< −1: as Relief has them
  std::vector<FaceDome> domes;
};

/// What follows a feature's outline at a distance: see sdf/scene/effects.h. Colours are slices.
struct FaceContour {
  int color, half_width;
};
struct FaceGlow {
  int color, reach;
};
struct FaceShadow {
  int color, blur;
  int shift = -1;  ///< −1: right below
};
struct FaceSurroundings {
  std::optional<FaceShadow> shadow;  ///< below the glow, both below the feature
  std::optional<FaceGlow> glow;
  std::optional<FaceContour> contour;  ///< over the feature
};

/// Features that are mixed first and then laid over what is below as one. They stand together.
struct FaceGroup {
  std::string name;
  int opacity = -1;  ///< −1: 1
  int clip = -1;     ///< a feature before the group's first; −1: none
};

/// The lamp: see Light in sdf/scene/paint.h.
struct FaceLight {
  glm::dvec3 direction{-0.45, 0.65, 0.85};
  double ambient = 0.35;
};

}  // namespace mien
