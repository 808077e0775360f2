#pragma once
// Is one piece left of another over a whole stretch of height? A bound says so, not a look here and
// there.

#include "sdf/arrange/sweep_piece.h"

namespace mien {

/// What neighbours may be out of order by [px] at most: a tenth of a level of 255 at full contrast, over the
/// whole height of a pixel. Finer pictures ask for less.
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

/// Whether `left` is left of `right` between two heights: nowhere farther right than `order`, but for
/// stretches whose area shows nowhere (a quarter of it). False where it is not known.
///
/// Derivation. Let g be the gap, g0 and g1 that at the ends, H the height between. g leaves its chord,
/// which is at least min(g0, g1), downwards by no more than either of
///
///   what the right piece sags to the left of its chord and the left one to the right, where they do:
///     over a parameter length h by |turning| h³ / (2H), half of what its control point is off;
///   H²/8 times the greatest g'' = x''(right) − x''(left), where x'' = −turning / (2 v³) with v the
///     speed down. v is linear in the parameter, so x'' is greatest and least at the ends. By a parabola
///     of that bend below the chord, which may fall from one end to the other.
///
/// The first is good for long stretches and where v is 0, the second for pieces alike, at whose ends
/// both bend alike. Where neither is enough the height is halved.
/// Before all that, chords and how far pieces leave them may do; and pieces are monotone: their ends may. So may
/// those of the gap, where it only grows or only falls.
bool in_order(const SweepPiece& left, const SweepPiece& right, double from, double to,
              double order = kOrder);

/// The same between two levels to another tolerance [px], with so many halvings at most and without the
/// chords.
bool stays_in_order(const SweepPiece& left, const SweepPiece& right, const PairLevel& from,
                    const PairLevel& to, double tolerance, int halvings);

}  // namespace mien
