#pragma once
// Is one piece left of another over a whole range of heights? Proven by a bound, not sampled.

#include "sdf/arrange/piece_place.h"

#include <optional>

namespace mien {

/// How far neighbours may be out of order [px]: a tenth of a level of 255 at full contrast over the whole height of
/// a pixel. Finer pictures ask for less.
inline constexpr double kOrder = 1.0 / 2560;

/// Whether `left` is left of `right` between two levels: nowhere farther right than `order`, except in stretches
/// whose area is too small to show (a quarter of it). Where that is not known: a height near which it is not.
///
/// Derivation. Let g be the gap, g0 and g1 its values at the ends, H the height between them. g falls below its
/// chord, which is at least min(g0, g1), by no more than the right piece sags to the left of its chord and the left
/// piece to the right of its own: |turning| h³ / (2H) where it sags that way, h its parameter length, which is half of
/// what its control point is off. If that is too much, the height is halved.
/// Cheaper tests come first: the ends alone, since pieces are monotone; and the ends of the gap where it only grows or
/// only falls: a piece's directions lie between those at its ends, and a cross product is linear in both.
std::optional<double> disorder(const OutlinePiece& left, const OutlinePiece& right,
                               const PairLevel& from, const PairLevel& to, double order);

}  // namespace mien
