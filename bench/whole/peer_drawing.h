#pragma once
// A scene as a rasteriser of paths wants it: a list of fills and strokes in pixels, made once, so
// that a peer is timed on drawing alone.

#include <mien/scene.h>
#include <mien/view.h>
#include "sdf/outline/outline_maker.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mien::bench {

/// One piece of a path: x right, y down from the picture's top left corner.
struct PathStep {
  enum class Kind { move, line, cubic, close } kind;
  glm::dvec2 p[3] = {};
};
using PathSteps = std::vector<PathStep>;

/// Colours along a line, or out of an ellipse's centre. Between two stops a peer mixes as it does:
/// Cairo mixes colours and opacities each for themselves, mien colours times their opacity, so
/// where two stops differ in both, the pictures differ a little between them.
struct PeerGradient {
  glm::dvec2 from, to;  ///< of lines; of ellipses `from` is the centre
  glm::dvec2 radii{};   ///< of ellipses; 0: a line
  glm::dvec2 axis{};    ///< unit; where radii.x points
  Extend extend = Extend::pad;
  std::vector<Stop> stops;  ///< sRGB-encoded
};

struct PeerFigure {
  enum class Kind { fill, stroke, ellipse } kind;
  PathSteps path;                             ///< of fills and strokes
  double width = 0;                           ///< of strokes: round caps and joins
  Ellipse ellipse{};                          ///< of ellipses
  bool even_odd = false;                      ///< of fills
  Color color{};                              ///< sRGB-encoded here
  std::vector<PathSteps> clips;               ///< all of them hold
  std::optional<PeerGradient> gradient = {};  ///< instead of the colour
};

struct PeerDrawing {
  int width = 0, height = 0;
  Color background;                 ///< sRGB-encoded
  std::vector<PeerFigure> figures;  ///< bottom to top
};

/// Nothing if the scene has something that fills and strokes of paths cannot say; `why` says what.
/// Domes (a lid's bulge) are left out: the peer draws no light.
std::optional<PeerDrawing> peer_drawing(const Scene& scene, const View& view, std::string& why);

/// What a peer has for nothing besides the posed scene: the outlines of its tapered strokes, as near as peer_drawing has
/// them. Keeps its scratch.
class GivenOutlines {
 public:
  void fit(const Scene& scene, const View& view);

 private:
  Outlines outlines_;
  OutlineMaker maker_;
};

}  // namespace mien::bench
