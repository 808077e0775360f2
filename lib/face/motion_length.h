#pragma once
// How long motions are.

#include <mien/api.h>
#include <mien/motion.h>

namespace mien {

/// [s] A curve's turn: after which it repeats, or makes its next random move; 0: it ends at its last key, or stands still.
MIEN_API double period_of(const Curve& curve);

/// [s] After which a motion has shown all that it has: from then on it repeats, or rests. Infinite where it never does: chance
/// moves it, or its curves' periods are together again after more than an hour, or never. 0 for one that moves nothing.
MIEN_API double motion_length(const Motion& motion);

}  // namespace mien
