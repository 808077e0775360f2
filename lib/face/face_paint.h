#pragma once
// Paints of features beyond a single colour: gradients, reliefs, groups, effects. As everywhere in a face,
// numbers that can move are slices of the face vector, referred to by their index.

#include <mien/index.h>
#include <mien/mix_mode.h>

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace mien {

struct Feature;

/// Place 0 at the point `from`, 1 at `to`.
struct LinearPaint {
  int from, to;
};

/// Place 0 at the centre, 1 on the ellipse.
struct RadialPaint {
  int center, radii;
  int tilt = -1;  ///< −1: none
};

/// Place 0 at the depth `inside` within a figure's outline, 1 at the distance `outside` from it.
struct DistancePaint {
  int inside, outside;  ///< lengths, one of them more than 0
};

struct GradientPaint {
  std::variant<LinearPaint, RadialPaint, DistancePaint> along;
  int places;               ///< slice of the stops' places, one number each
  std::vector<int> colors;  ///< slices, as many
  enum class Extend : unsigned char { pad, repeat, reflect } extend = Extend::pad;
};

/// A hill on a surface; see Dome in sdf/scene/paint.h.
struct FaceDome {
  int center, radii, height;
  int tilt = -1;  ///< −1: none
};

/// The surface over a feature; see Relief in sdf/scene/paint.h. It starts at the outline of the feature's
/// own figure, not of what the feature is clipped to.
struct FaceRelief {
  enum class Profile : unsigned char { flat, bevel, round, custom } profile = Profile::flat;
  int width = -1, height = -1;        ///< −1: flat
  int table = -1;                     ///< custom: heights in units of `height`
  bool sunk = false;                  ///< a dent: heights count downwards
  int specular = -1, shininess = -1;  ///< −1: the default of Relief
  std::vector<FaceDome> domes;
};

/// Effects that follow a feature's outline at a distance; see sdf/scene/effects.h. Colours are slices.
struct FaceContour {
  int color;
  int half_width;  ///< one number; if it varies two: the thin and the thick half-width
  enum class By : unsigned char { none, angle, along } by = By::none;  ///< what it varies by
};
struct FaceGlow {
  int color, reach;
};
struct FaceShadow {
  int color, blur;
  int shift = -1;     ///< −1: right below
  Index<Feature> on;  ///< an earlier feature: the shadow falls on its area only
};
struct FaceSurroundings {
  std::optional<FaceShadow> shadow;  ///< below the glow, both below the feature
  std::optional<FaceGlow> glow;
  std::optional<FaceContour> contour;  ///< over the feature
};

/// Consecutive features that are composited first; the result is then mixed with what is below.
struct FaceGroup {
  std::string name;
  MixMode mix = MixMode::normal;
  int opacity = -1;     ///< −1: 1
  Index<Feature> clip;  ///< a feature before the group's first
};

/// The lamp; see Light in sdf/scene/paint.h.
struct FaceLight {
  glm::dvec3 direction{-0.45, 0.65, 0.85};
  double ambient = 0.35;
};

}  // namespace mien
