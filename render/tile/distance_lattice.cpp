#include <mien/render/tile/distance_lattice.h>

#include <cmath>

namespace mien {
namespace {

constexpr int kNodes = 5;
constexpr std::array<int, kNodes> kNode{0, 1, 4, 7, 8};

using Weights = std::array<double, kNodes>;

/// Lagrange's: what each node counts for at half-pixels s/2. Products of halves are exact, and there is one division:
/// the weights of mirrored places are mirrored to the bit, and at a node they are 0 and 1.
constexpr auto kWeights = [] {
  std::array<Weights, std::size_t(2 * DistanceLattice::kBlock + 1)> all{};
  for (std::size_t s = 0; s < all.size(); ++s)
    for (std::size_t k = 0; k < kNodes; ++k) {
      double above = 1.0, below = 1.0;
      for (std::size_t j = 0; j < kNodes; ++j)
        if (j != k) above *= 0.5 * double(s) - kNode[j], below *= kNode[k] - kNode[j];
      all[s][k] = above / below;
    }
  return all;
}();

double mixed(const Weights& w, const Weights& f) {
  return ((w[0] * f[0] + w[4] * f[4]) + (w[1] * f[1] + w[3] * f[3])) + w[2] * f[2];
}

}  // namespace

void DistanceLattice::fill(const AreaDistance& area, glm::dvec2 begin) {
  if (filled_ && begin == begin_) return;
  begin_ = begin, filled_ = true;
  std::array<Weights, std::size_t(kPlaces)> rows;  // [place along x][node along y]
  for (std::size_t j = 0; j < kNodes; ++j) {
    Weights nodes;
    for (std::size_t i = 0; i < kNodes; ++i)
      nodes[i] = area.at(begin + glm::dvec2{kNode[i], kNode[j]});
    for (std::size_t s = 0; s < rows.size(); ++s) rows[s][j] = mixed(kWeights[s], nodes);
  }
  std::size_t next = 0;
  for (const Weights& weights : kWeights)
    for (const Weights& row : rows) d_[next++] = mixed(weights, row);
  smooth_ = is_smooth(area);
  if (smooth_) return;
  for (int j = 0; j <= kBlock; ++j)
    for (int i = 0; i <= kBlock; ++i)
      d_[std::size_t(2 * j * kPlaces + 2 * i)] = area.at(begin + glm::dvec2{i, j});
}

bool DistanceLattice::is_smooth(const AreaDistance& area) const {
  constexpr int kLow = 5, kMiddle = 8, kHigh = 11;  // [half pixels]
  for (const int row : {kLow, kMiddle, kHigh})
    for (const int column : {kLow, kMiddle, kHigh}) {
      if (row == kMiddle && column == kMiddle) continue;  // a node
      const double truth = area.at(begin_ + 0.5 * glm::dvec2{column, row});
      if (!(std::abs(at(column, row) - truth) <= kTolerance)) return false;
    }
  return true;
}

DistanceLattice::Corners DistanceLattice::corners(int column, int row) const {
  const int i = 2 * column, j = 2 * row;
  return {at(i, j), at(i + 2, j), at(i, j + 2), at(i + 2, j + 2)};
}

double DistanceLattice::center(const AreaDistance& area, int column, int row) const {
  return smooth_ ? at(2 * column + 1, 2 * row + 1)
                 : area.at(begin_ + glm::dvec2{column + 0.5, row + 0.5});
}

}  // namespace mien
