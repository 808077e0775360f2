#pragma once
// Where two pieces change their order from left to right.

#include "sdf/arrange/piece_place.h"

namespace mien {

/// Pieces closer than this touch [px]: too close for a wrong order to show (1e-6 of a pixel's area per row), but
/// far above rounding (1e-10 at coordinates of a million).
inline constexpr double kTouch = 1e-6;

/// The height between two levels at which the gap falls from > 0 to < 0, if it is < 0 at the lower one. The upper one,
/// if they are not apart there and do not part.
double meeting(const OutlinePiece& left, const OutlinePiece& right, const PairLevel& from,
               const PairLevel& to);

}  // namespace mien
