#pragma once
// The picture as it ought to be: implicit geometry, sampled on a fine grid in every pixel an
// outline can reach. Shares no code with what it judges: shapes are given as inequalities, not as
// distances or edges.

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include <mien/image.h>
#include <mien/scene.h>

namespace mien::test {

/// One painted area, topmost last in a list.
struct TruthLayer {
  std::function<bool(glm::dvec2)> inside;
  /// A lower bound of the distance from p to the area's outline (0 if unknown).
  std::function<double(glm::dvec2)> clearance;
  glm::dvec3 rgb;      ///< 0 … 255, in the space that is averaged
  double opacity = 1;  ///< laid over what is below in that space
};

struct TruthScene {
  glm::dvec3 background;
  std::vector<TruthLayer> layers;
  glm::dvec2 top_left;  ///< of the picture, in the layers' units
  double pixel;         ///< size of a pixel in those units
  bool y_up;
};

/// The mean over pixel (x, y) by grid × grid samples; grid a power of two.
glm::dvec3 truth_pixel(const TruthScene& scene, int x, int y, int grid);

struct TruthError {
  double worst = 0;      ///< largest |channel − rounded truth|
  long over_one = 0;     ///< pixels off by more than 1
  long edge_pixels = 0;  ///< pixels that were sampled
  std::string where;     ///< the worst one
};

/// Compares every pixel of an 8-bit image with the truth; `every` > 1 looks at one pixel in that
/// many (all rows).
TruthError compare_with_truth(const Image& image, const TruthScene& scene, int grid, int every = 1);

/// The published eyes at a pose: the truth for faces/seed0 (items E1 – E7, E10 of docs/sources.md).
TruthScene eyes_truth(int width, int height, glm::dvec2 gaze, double dilation, double blink);

/// The muscle face at rest: the truth for faces/male (M1 – M3).
TruthScene male_truth(int width);

/// The truth for any scene blended in sRGB, by the signs of Scene::distance: independent of edges,
/// coverage, tiles, layers on bits, but not of the distances themselves, which have truths of their
/// own in tests/sdf.
TruthScene scene_truth(const Scene& scene, int width, int height);

}  // namespace mien::test
