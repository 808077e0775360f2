#pragma once
// A feature's paint, with the numbers it has in a face, as a scene's.

#include <mien/face.h>
#include <mien/face_paint.h>
#include <mien/feature.h>
#include <mien/scene.h>
#include <mien/scene_effects.h>

#include <optional>

namespace mien {

/// The colour in a slice.
Color color_of(const Face& face, int slice);

/// `own` is the area of the feature's figure, not clipped: what its gradients and relief count from.
Paint paint_of(const Feature& feature, const Face& face, Area own);

/// What follows a feature's outline.
struct Surroundings {
  struct Contour {
    Color color;
    FaceContour::By by;
    double thin, thick;  ///< half-widths; without a law the first counts
  };
  std::optional<SoftShadow> shadow;
  Index<Feature> shadow_on;  ///< none: it falls on all that is below
  std::optional<Glow> glow;
  std::optional<Contour> contour;
};
Surroundings surroundings_of(const Feature& feature, const Face& face);

/// What a slice of one number holds, at most 1; 1 without a slice.
double opacity_of(const Face& face, int slice);

}  // namespace mien
