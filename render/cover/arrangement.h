#pragma once
// A square cut by several straight edges: every piece's area, and on which side of each edge it
// lies. Exact for any number of edges; what makes corners, thin strokes and layers with a common
// border come out without seams.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// The line d + dot(u, normal) = 0 in the unit square about the origin; inside where negative.
struct Cut {
  double d;
  glm::dvec2 normal;
};

/// Cuts the unit square [−1/2, 1/2]² by up to kMaxCuts lines.
///
/// Keeps its scratch: one Arrangement per thread, used again and again, does not allocate.
class Arrangement {
 public:
  static constexpr int kMaxCuts =
      32;  ///< bits of `inside`; k lines make at most 1 + k(k+1)/2 pieces

  /// Room for what is common, so that the first frame of a program is like the others.
  Arrangement() {
    constexpr std::size_t kPoints = 256, kPieces = 64;
    for (auto* points : {&points_, &next_points_}) points->reserve(kPoints);
    for (auto* polygons : {&polygons_, &next_polygons_}) polygons->reserve(kPieces);
    side_.reserve(kPieces), pieces_.reserve(kPieces);
  }

  struct Piece {
    double area;           ///< in [0, 1]; all pieces sum to 1
    std::uint32_t inside;  ///< bit i: the piece is inside cut i
  };

  /// The pieces, valid until the next call. Slivers of no area may be missing.
  std::span<const Piece> cut(std::span<const Cut> cuts);

  /// The corners of the last cut's piece i, turning left: a convex polygon.
  std::span<const glm::dvec2> corners(std::size_t i) const {
    return {points_.data() + polygons_[i].first, polygons_[i].count};
  }

 private:
  struct Polygon {
    std::uint32_t inside;
    std::uint32_t first, count;  // in points_
  };
  void split(const Polygon& polygon, const Cut& cut, std::uint32_t bit);

  std::vector<glm::dvec2> points_, next_points_;
  std::vector<Polygon> polygons_, next_polygons_;
  std::vector<double> side_;
  std::vector<Piece> pieces_;
};

}  // namespace mien
