#pragma once
// How the place of a gradient from a centre varies: planes around many places, in lanes, and which of them are enough.

#include "render/shade/color_row.h"
#include "render/shade/paint.h"

#include <vector>

namespace mien {

/// Middles of squares, and the variance over each along both axes.
struct RadialPlaces {
  std::vector<double> x, y, variance;

  void clear() { x.clear(), y.clear(), variance.clear(); }
  void add(double px, double py, double v) {
    x.push_back(px), y.push_back(py), variance.push_back(v);
  }
};

/// Adds a plane (scaled) for each place, and takes the places: t is the mean over the square to second order. Writes the squares of what
/// level lines bend by there [1/px²].
void add_radial_planes(const PaintField& field, const RampIntegral& ramp, RadialPlaces& at,
                       std::vector<RampPlane>& planes, std::vector<float>& bends_squared);

/// What level lines that bend by 1/px leave of a pixel that is taken for straight, by channel and as a share of the
/// tolerance (docs/derivations/ramps.md).
struct BendRule {
  static constexpr double kLeft = 0.1;  ///< of the range

  BendRule(const RampIntegral& ramp, double tolerance, bool linear);

  Mix dark, light;  ///< of what is laid over black, and over white
  Mix range, least;
  bool linear;
};

/// By how much too much level lines bend, squared, in pixels whose colours are known as if they were straight: beyond
/// 1 they are too bent, beyond n⁴ in n × n cells.
void bend_excesses(const BendRule& rule, std::vector<float>& bends_squared, const ColorRow& colors,
                   std::vector<float>& to);

}  // namespace mien
