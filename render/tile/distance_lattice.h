#pragma once
// The distances of an area all over a block of 8 × 8 pixels: at the pixels' corners and centres,
// each asked for once, when it is first wanted, of what of the area can matter in the block
// (near_area.h). They are the area's own distances, to the last digits.
//
// An earlier form asked for 33 of the 145 and put a polynomial through them where that agreed at a few more
// places. It was no faster than asking the one side of a path that is near, and what it could miss
// beside a kink was argued, not proven.

#include <mien/render/tile/near_area.h>

#include <array>

namespace mien {

class DistanceLattice {
 public:
  static constexpr int kBlock = 8;        ///< pixels, each way
  using Corners = std::array<double, 4>;  ///< 00, 10, 01, 11

  /// Of the block that begins at `begin`; nothing is done if it is that already.
  void fill(const AreaDistance& area, glm::dvec2 begin);

  Corners corners(int column, int row);
  double center(int column, int row);

 private:
  static constexpr int kPlaces = 2 * kBlock + 1;  ///< half a pixel apart
  double at(int column, int row);

  glm::dvec2 begin_{0.0};
  bool filled_ = false;
  NearArea near_;
  std::array<double, std::size_t(kPlaces* kPlaces)> d_;  ///< NaN: not asked for yet
};

}  // namespace mien
