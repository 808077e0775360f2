#pragma once
#include "sdf/outline/outline_loop.h"

#include "pen_private.h"

#include <array>
#include <cstddef>

namespace mien {

/// The union of the pen's discs: {min over t of |p − B(t)| − w(t) <= 0}. Widths below 0 are no
/// discs.
///
/// Derivation.  The loops wind around p as often as {t in [0, 1] : |p − B(t)| <= w(t)} has parts:
///   never where p is in no disc, else at least once. Rims that turn back on themselves (inside
///   tight bends) and discs that swallow their neighbours need nothing of their own.
///   docs/derivations/outlines.md
void write_stroke(OutlineLoop& loop, const Pen& pen);

/// The union of several. Where a pen goes on as the one before ended, in its place, way and width, their rims do too.
class StrokeRow {
 public:
  explicit StrokeRow(OutlineLoop& loop) : loop_(loop) {}
  void add(const Pen& pen);
  void end();

 private:
  OutlineLoop& loop_;
  std::array<Pen, 64>
      pens_;  ///< that go on as each other; of more, the next begins with a round end
  std::size_t count_ = 0;
};

/// The hull of two discs.
void write_capsule(OutlineLoop& loop, glm::dvec2 c0, double r0, glm::dvec2 c1, double r1);

}  // namespace mien
