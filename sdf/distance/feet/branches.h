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

//
// A spine is a quadratic curve with a half-width along it: the disc (B(t), w(t)) for every t from 0 to 1. Strokes are
// unions of those discs: their distance is the least |p − B(t)| − w(t). Sides of paths are spines without width, with an
// outside.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// x = x0 + t (x1 + t x2), likewise y and the half-width w.
struct Spine {
  double x0, x1, x2, y0, y1, y2, w0, w1, w2;
  /// Of a path: outward, unit, between this side's normal and the next's.
  double begin_x, begin_y, end_x, end_y;
  /// Of a path: outward is side · (y', −x'). Of strokes: 0.
  double side;
};

inline glm::dvec2 on_spine(const Spine& s, double t) {
  return {s.x0 + t * (s.x1 + t * s.x2), s.y0 + t * (s.y1 + t * s.y2)};
}
/// B'.
inline glm::dvec2 along_spine(const Spine& s, double t) {
  return {s.x1 + 2.0 * t * s.x2, s.y1 + 2.0 * t * s.y2};
}
inline double width_on_spine(const Spine& s, double t) {
  return s.w0 + t * (s.w1 + t * s.w2);
}

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
    least,
    most,  // as far as feet may be looked for: to the spine's end, or where it turns
    side,
    begin_x,
    begin_y,
    end_x,
    end_y,
    next_x,
    next_y,  // of a path: the way in which the next side sets out
    before_x,
    before_y,  // and in which the one before arrives
    single,  // 1: proven to have one foot; 0: one least distance, being of one width; −1: neither
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

struct NearBranches {
  std::uint64_t near = 0;   ///< may be nearest somewhere in it
  std::uint64_t local = 0;  ///< of those, the least among their neighbours
  float key = 0;            ///< the least |p − B| − w at its middle
  /// One branch is local and will stay so all over the square: squares in it need not look.
  bool sure = false;
  bool endless = false;          ///< nor does its spine end in it
  float x = 0, y = 0, foot = 0;  ///< its foot, seen from there
  float foot_x = 0, foot_y = 0;  ///< and how that moves with the place
};

/// By branch: its foot seen from the middle of the square that was entered last, and how that moves with the place.
struct BranchFeet {
  static constexpr int kStride = 64 + 16;
  alignas(64) float t[kStride], x[kStride], y[kStride];
};

/// What sixteen places see: signed distances and their gradients, and the nearest ridge. There two branches are equally
/// near and the gradient jumps from one to the other. Branches change along their gradients, so a ridge lies
/// (d' − d) / |n' − n| away in the direction of n − n' (of a least distance), up to how far level lines bend on the way.
/// Distances change by at most one per length: no ridge lies nearer than half of their gap.
struct BranchPair {
  static constexpr int kPlaces = 16;
  /// Stands for no ridge.
  static constexpr float kFar = 1e9f;
  struct Values {
    alignas(64) float d[kPlaces], nx[kPlaces], ny[kPlaces];
  };
  Values best, beyond;
  /// How far the ridge is, and the way to it, of length 1.
  alignas(64) float off[kPlaces], ex[kPlaces], ey[kPlaces];
};

}  // namespace mien
