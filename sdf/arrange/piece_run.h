#pragma once
// Pieces one below the other, as a chain has them between two heights; two such runs at once.

#include "lib/base/watch.h"
#include "sdf/arrange/meeting.h"
#include "sdf/arrange/order_proof.h"

#include <algorithm>
#include <optional>

namespace mien {

struct PieceRun {
  const OutlinePiece *first, *last;

  /// The piece that goes on below a height.
  const OutlinePiece& at(double y) const {
    const OutlinePiece* p = first;
    while (p < last && p->y1 <= y) ++p;
    return *p;
  }
};

/// Calls each(left piece, right piece, upper level, lower level) from the top down as long as it returns true.
template <class Each>
void each_stretch(PieceRun l, PieceRun r, double from, double to, Each&& each) {
  for (double y = from, next = to; y < to; y = next) {
    worked(20);
    l.first = &l.at(y), r.first = &r.at(y), next = to;
    for (const PieceRun* run : {&l, &r})
      if (run->first < run->last) next = std::min(next, run->first->y1);
    if (!each(*l.first, *r.first, pair_at(*l.first, *r.first, y),
              pair_at(*l.first, *r.first, next)))
      return;
  }
}

/// As for two pieces (order_proof.h).
inline std::optional<double> disorder(PieceRun left, PieceRun right, double from, double to,
                                      double order) {
  std::optional<double> found;
  each_stretch(left, right, from, to,
               [&](const OutlinePiece& l, const OutlinePiece& r, const PairLevel& a,
                   const PairLevel& b) { return !(found = disorder(l, r, a, b, order)); });
  return found;
}

/// Where a gap that is < 0 at the height `to` becomes so.
inline double meeting(PieceRun left, PieceRun right, double from, double to) {
  double found = to;
  each_stretch(
      left, right, from, to,
      [&](const OutlinePiece& l, const OutlinePiece& r, const PairLevel& a, const PairLevel& b) {
        if (b.y < to && b.gap() >= -kTouch) return true;
        found = meeting(l, r, a, b);
        return false;
      });
  return found;
}

}  // namespace mien
