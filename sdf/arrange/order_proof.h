#pragma once
// Is one piece left of another over a whole range of heights? Proven by a bound, not sampled.

#include "sdf/arrange/sweep_piece.h"

namespace mien {

/// How far neighbours may be out of order [px]: a tenth of a level of 255 at full contrast over the whole height of
/// a pixel. Finer pictures ask for less.
inline constexpr double kOrder = 1.0 / 2560;

/// A pair of pieces at a height: parameters and places.
struct PairLevel {
  double y, l, r, left_x, right_x;
  double gap() const { return right_x - left_x; }
};

inline PairLevel pair_at(const SweepPiece& left, const SweepPiece& right, double y) {
  const double l = parameter_at(left, y), r = parameter_at(right, y);
  return {y, l, r, x_of(left, l), x_of(right, r)};
}

/// > 0 where the gap from `left` to `right` grows all the way from a to b, < 0 where it falls, 0 where that is
/// not known. A piece's directions lie between those at its ends, and a cross product is linear in both.
int trend(const SweepPiece& left, const SweepPiece& right, const PairLevel& a, const PairLevel& b);

/// Whether `left` is left of `right` between two heights: nowhere farther right than `order`, except in stretches
/// whose area is too small to show (a quarter of it). False where that is not known.
///
/// Derivation. Let g be the gap, g0 and g1 its values at the ends, H the height between them. g falls below its
/// chord, which is at least min(g0, g1), by no more than either of
///
///   the sag of the right piece to the left of its chord plus that of the left piece to the right, where they sag
///   that way: |turning| h³ / (2H) each, h its parameter length, half of what its control point is off;
///   H²/8 times the greatest g'' = x''(right) − x''(left), where x'' = −turning / (2 v³) with v the speed down. v
///   is linear in the parameter, so x'' is greatest and least at the ends. A parabola of that bend below the chord,
///   which may slope, gives the bound.
///
/// The first is good for long stretches and where v is 0, the second for similar pieces, which bend alike at both
/// ends. If neither is enough, the height is halved.
/// Cheaper tests come first: the chords and how far pieces leave them; the ends alone, since pieces are monotone;
/// and the ends of the gap where it only grows or only falls.
bool in_order(const SweepPiece& left, const SweepPiece& right, double from, double to,
              double order = kOrder);

/// The same between two levels, to another tolerance [px], with at most so many halvings and without the chords.
bool stays_in_order(const SweepPiece& left, const SweepPiece& right, const PairLevel& from,
                    const PairLevel& to, double tolerance, int halvings);

}  // namespace mien
