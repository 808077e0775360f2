#pragma once
// A gradient along a distance in steps of one colour each, for SVG has no such gradient.
//
// Steps that lie side by side would show hairlines where their antialiased edges meet. So each step is laid over the
// ones before it, from the outermost inwards or the other way round, with the colour that gives the wanted one
// together with what is below: with premultiplied colours, p over m' = m for p = m − (1 − a) m', where its opacity a
// follows from the same for opacities. Where no such colours exist in either direction, steps lie side by side.

#include "render/blend/ramp.h"
#include "render/svg/area_boundary.h"

#include <vector>

namespace mien {

/// The most that a channel changes by from step to step.
inline constexpr double kBandStep = 1.0 / 40;

/// What one step covers of the layer, beside the layer's own area, and its colour.
struct DistanceBand {
  std::vector<AreaLevel> within;
  Mix mix{0.0};
};

struct DistanceBands {
  std::vector<DistanceBand> bands;  ///< bottom to top
  double opacity = 1;               ///< of all together
};

/// Beyond its ends the gradient stays as it is there.
DistanceBands distance_bands(const DistanceGradient& along, const Ramp& ramp);

}  // namespace mien
