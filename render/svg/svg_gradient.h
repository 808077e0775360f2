#pragma once
// Linear and radial gradients as SVG's linearGradient and radialGradient.
//
// What differs. SVG counts a gradient's place from 0 to 1, so the way from the first to the last stop becomes all of
// it. SVG mixes straight colours between stops, mien premultiplied ones: between stops of different opacity and colour
// more stops are put in, until the two agree to kStraightError. A transparent stop takes the colour of the stop
// beside it, with one for each side where they differ.

#include <mien/map.h>
#include "render/blend/ramp.h"

#include <string>
#include <vector>

namespace mien {

/// [of a channel] by which mixing straight colours may differ from mixing premultiplied ones.
inline constexpr double kStraightError = 1.0 / 1024;

/// A stop of SVG: its colour is straight, and beside it as SVG mixes.
struct SvgStop {
  double at;
  Mix straight;  ///< .a: the opacity
};

/// A ramp from t = `from` to `to`, from < to.
struct SvgRamp {
  double from, to;
  Extend extend;
  std::vector<SvgStop> stops;  ///< by t
};

/// As along a line, where t is any number.
SvgRamp ramp_along_line(const Ramp& ramp);
/// As from a centre, where t begins with 0: `from` is 0.
SvgRamp ramp_from_center(const Ramp& ramp);

/// A paint server and what it is called by, or one colour where the gradient has no extent.
struct SvgPaint {
  std::string definition;  ///< an element; empty: `fill` is a colour
  std::string fill;        ///< attributes
};

SvgPaint svg_paint(const LinearGradient& along, const Ramp& ramp,
                   const Map<GridSpace, FaceSpace>& map, const std::string& id);
SvgPaint svg_paint(const RadialGradient& along, const Ramp& ramp,
                   const Map<GridSpace, FaceSpace>& map, const std::string& id);
/// One colour.
SvgPaint svg_paint(const Mix& mix);

}  // namespace mien
