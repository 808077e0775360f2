#pragma once
// A feature's paint as a scene's, with the numbers that a face gives it.

#include <mien/face.h>
#include <mien/face_paint.h>
#include <mien/feature.h>
#include <mien/scene.h>
#include <mien/scene_effects.h>

#include <optional>

namespace mien {

/// The colour in a slice.
Color color_of(const Face& face, int slice);

/// `own`: the area of the feature's figure, not clipped. Gradients and relief are measured from it.
Paint paint_of(const Feature& feature, const Face& face, Area own);

/// The effects that follow a feature's outline.
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

/// The opacity in a slice of one number, at most 1; 1 without a slice.
double opacity_of(const Face& face, int slice);

}  // namespace mien
