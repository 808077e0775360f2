#pragma once
// Paints that vary from place to place, made ready to draw: on the grid of the picture's pixels.

#include "render/blend/lit.h"
#include "render/blend/ramp.h"
#include "render/shade/nearest/area_distance.h"
#include "render/shade/ramp/integral.h"

#include <optional>
#include <vector>

namespace mien {

/// The place t along a gradient, as a function of the point.
struct PaintField {
  enum class Kind : unsigned char {
    linear,   ///< dot(p, across) + shift
    radial,   ///< |unit · (p − center)|
    distance  ///< (distance − from) · scale
  } kind = Kind::linear;
  glm::dvec2 across{0.0};
  double shift = 0;
  glm::dvec2 center{0.0};
  glm::dmat2 unit{0.0};  ///< takes the ellipse to the unit circle
  int distance = -1;     ///< index into PaintTable::distances
  double from = 0, scale = 0;
  double per_pixel = 0;  ///< t changes by at most this much per pixel

  /// t of a point; for Kind::distance give the distance there.
  double at(glm::dvec2 p, double d) const;
  /// How t varies around p along a line.
  RampPlane plane(glm::dvec2 p) const { return {at(p, 0.0), across.x, across.y}; }
};

/// A ramp between two kinks: at + slope · t, for t from `from` to `to`.
struct RampSegment {
  Mix at{0.0}, slope{0.0};
  double from = 0, to = 0;
};

/// A surface over a layer, in pixels.
struct GridRelief {
  struct GridDome {
    glm::dvec2 center;
    glm::dmat2 unit;    ///< takes the ellipse to the unit circle
    double height;      ///< [px]
    double max_radius;  ///< [px]
  };
  int distance = -1;  ///< index into PaintTable::distances; −1: none
  bool own = true;    ///< that distance is the layer's own area's
  Profile profile = Profile::flat;
  double width = 1, height = 0;  ///< [px]
  std::vector<double> table;
  std::vector<GridDome> domes;
  Lamp lamp;
};

/// A gradient, a relief, or both.
struct GridPaint {
  Mix color{0.0};            ///< without a gradient
  std::optional<Ramp> ramp;  ///< with one
  PaintField field;
  std::optional<GridRelief> relief;

  double least_opacity() const { return ramp ? ramp->least_opacity() : color.a; }
};

}  // namespace mien
