#pragma once
// A scene as an SVG picture: paths of lines and parabolas that leave the outlines by a stated tolerance at most.
//
//   const auto svg = mien::svg_text(scene, {.width = 640, .height = 640});
//   if (!svg) return complain(sentence(svg.error()));
//   file << svg->text;
//   for (const std::string& sentence : svg->simplified) warn(sentence);
//
// Layers are in order, with their colours, linear and radial gradients, opacities, groups, mix modes and clips. Each
// layer's area, whatever it was combined from, is one path: the boundary of its own arrangement. Colours are mixed as
// encoded, as SVG viewers do (Blend::srgb). What SVG cannot show is written as the nearest plain thing or left out, and
// `simplified` tells which.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/limits.h>
#include <mien/progress.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <optional>
#include <string>
#include <vector>

namespace mien {

struct SvgOptions {
  double width = 512, height = 512;  ///< [px] of the whole picture, above 0, at most View::kMaxSide
  Fit fit = Fit::meet;
  double legible = 0;  ///< [px] the least width of lines, as of a View
  /// Replaces the scene's; alpha 0 leaves the picture transparent.
  std::optional<Color> background = {};
  /// [px] How far a path may leave its outline, kLeastTolerance … 1; both sides of a thin line by this are 3 levels of 255.
  double tolerance = 0.006;
  std::string title = {};   ///< the picture's; empty: none
  std::string recipe = {};  ///< stored as metadata: what made this picture
  /// Of all ids, so that several pictures can stand in one page; letters, digits, '.', '-' and '_' of ASCII. None: made
  /// of the picture, so that only equal ones share ids.
  std::optional<std::string> id_prefix = {};
  Progress progress = {};    ///< may cancel
  RenderLimits limits = {};  ///< beyond them it is an error

  static constexpr double kLeastTolerance = 1e-4;
};

struct Svg {
  std::string text;  ///< a whole file, UTF-8
  /// One sentence each, with the layer's name: what is drawn otherwise than in the scene.
  std::vector<std::string> simplified;
};

/// Errors, one sentence each: a side or the tolerance is out of range, or no number; a limit by its name; cancelled.
MIEN_API Expected<Svg> svg_text(const Scene& scene, const SvgOptions& options = {});

}  // namespace mien
