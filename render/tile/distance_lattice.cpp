#include <mien/render/tile/distance_lattice.h>

#include <cmath>
#include <limits>

namespace mien {

void DistanceLattice::fill(const AreaDistance& area, glm::dvec2 begin) {
  if (filled_ && begin == begin_) return;
  begin_ = begin, filled_ = true;
  constexpr double kHalfDiagonal = 0.70710678118654757 * kBlock;
  near_.narrow(area, begin + 0.5 * kBlock, kHalfDiagonal);
  d_.fill(std::numeric_limits<double>::quiet_NaN());
}

double DistanceLattice::at(int column, int row) {
  double& d = d_[std::size_t(row * kPlaces + column)];
  if (std::isnan(d)) d = near_.at(begin_ + 0.5 * glm::dvec2{column, row});
  return d;
}

DistanceLattice::Corners DistanceLattice::corners(int column, int row) {
  const int i = 2 * column, j = 2 * row;
  return {at(i, j), at(i + 2, j), at(i, j + 2), at(i + 2, j + 2)};
}

double DistanceLattice::center(int column, int row) {
  return at(2 * column + 1, 2 * row + 1);
}

}  // namespace mien
