#pragma once
// A hash of all that a row of a picture is made from: rows of two frames with the same hash are the same to the
// byte.
//
// A row is made from the stretches of visible outline that cross it, in their order, and from what is
// seen on both sides of each. Nothing else of a scene counts: not what is hidden, nor names, nor how
// the sweep came to it.

#include "render/shade/looks.h"
#include "sdf/arrange/sweep.h"
#include "sdf/scene/same_scene.h"

#include <cstdint>
#include <vector>

namespace mien {

class RowFingerprints {
 public:
  /// No row has it: it stands for a row that may depend on more than its outlines.
  static constexpr std::uint64_t kNone = 0;

  /// `seed` stands for the view, and for everything else that a whole picture shares.
  void begin(std::uint64_t seed, const Scene& scene, const PaintTable& paints, int rows);
  /// Rows from `top` to `bottom`.
  void add(const Looks& looks, int first_look, const Sweep& sweep, int top, int bottom);

  std::uint64_t operator[](int row) const { return rows_[std::size_t(row)]; }

 private:
  void look_at_looks(const Looks& looks);
  void add(const Fragment& fragment, const OutlinePiece& piece);
  void doubt(const Doubt& doubt);

  std::uint64_t seed_ = 0;
  PaintFingerprints layers_;
  std::vector<std::uint64_t> paints_;  ///< by varied paint
  std::vector<std::uint64_t> looks_;
  std::vector<std::uint64_t> rows_;
};

}  // namespace mien
