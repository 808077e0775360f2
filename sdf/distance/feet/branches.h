#pragma once
// The branches of an outline's distance around a disc: stretches of spines that can be nearest somewhere in it.
//
// The foot of a place p on a spine is the t at which k(t) = |p − B(t)| − w(t) is least. Its derivative vanishes where
//
//     (B − p) · B' − w' |B − p| = 0,
//
// and that grows along a stretch, so that the stretch has one foot, while |B'|² stays above what the bends of spine
// and width can take from it: 2 far (|B''/2| + |w''/2|) + |w'| |B'|, seen from no farther away than `far`. Spines are
// cut until that holds, or until they are short. As k changes by at most one per length, a stretch whose k is more than
// a disc's width above the least one there is nearest nowhere in the disc.

#include "sdf/distance/feet/spine.h"

#include <cstdint>
#include <span>
#include <vector>

namespace mien {

/// Figures by row, for lanes: one column a branch, seen from the disc's middle. A stretch is a curve of its own, so that
/// floats are as exact on long spines as on short ones.
struct Branches {
  /// So many bits has a set of branches.
  static constexpr int kMost = 64, kStride = kMost + 16;
  enum Row : int {
    x0,
    x1,
    x2,
    y0,
    y1,
    y2,
    w0,
    w1,
    w2,  // the spine's
    low,
    high,  // the stretch is 0 to 1; a little beyond joints
    first,
    last,  // the whole spine
    side,
    begin_x,
    begin_y,
    end_x,
    end_y,
    next_x,
    next_y,  // of a path: the way in which the next side sets out
    before_x,
    before_y,  // and in which the one before arrives
    foot,
    foot_x,
    foot_y,  // the middle's, and how it moves with the place
    kRows
  };
  std::vector<float> figures;
  std::vector<double> keys;  ///< scratch
  int count = 0;
  bool stroke = false;
  /// There are more than kMost: the branches are of no use.
  bool crowded = false;

  float* row(Row r) { return figures.data() + int(r) * kStride; }
  const float* row(Row r) const { return figures.data() + int(r) * kStride; }
  std::uint64_t all() const {
    return count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  }
};

/// An outline as spines.
struct SpineList {
  bool stroke = false;  ///< else sides of a path
  std::vector<Spine> spines;
  std::vector<std::size_t> next;    ///< by side of a path: the one that begins at its end
  std::vector<std::size_t> before;  ///< the other way round
};

/// The branches around a disc.
void gather_branches(const SpineList& outline, glm::dvec2 middle, double radius, Branches& to);

}  // namespace mien
