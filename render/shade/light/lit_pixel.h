#pragma once
// The light over a pixel, or over the exact form of a part of one, by 4 × 4 cells; by 8 × 8 to 32 × 32 where those
// show that they are not enough.

#include "render/shade/light/lit_cells.h"
#include "render/shade/nearest/near_feet.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace mien {

/// Keeps its scratch; one per thread.
class LitPixel {
 public:
  /// Where the pixel is asked for: the light and the feet around a tile's middle, and the zone.
  struct Place {
    const LampLanes* lamp;
    NearFeet* feet;  ///< none: nothing rises here
    float shallow, deep;
    glm::vec2 at;     ///< the pixel's middle, from the tile's
    FootAt foot;      ///< there
    bool calm;        ///< the foot serves for all of the pixel
    float tolerance;  ///< of the mean
  };
  /// The mean of the form; of the whole pixel without one.
  glm::vec3 mean(const Place& place, const PartForm* form);

  /// The colours of the form's side × side cells; of cells without area those of `otherwise`.
  void colors(const Place& place, const PartForm* form, int side, glm::vec3 otherwise,
              std::span<float> r, std::span<float> g, std::span<float> b);

  /// The mean of the signed distance; the place's tolerance is then in px.
  float distance(const Place& place, const PartForm* form);

 private:
  float distance_by(const Place& place, const PartForm* form, int side);
  LitMean seen(const Place& place, const PartForm* form, int side);
  /// Cuts the form, or the whole pixel, into side × side cells.
  void cut(const PartForm* form, int side);
  void see(const Place& place, const PartForm* form, int side);
  /// The feet of the centroids of those cells that have an area, one after the other. Ridges do not count for a
  /// distance, so neighbours are not asked. Returns how many there are.
  std::size_t find_feet_of_cells(const Place& place);
  void find_feet(NearFeet& feet);

  PartCells parts_;
  LitCells cells_;
};

}  // namespace mien
