#pragma once
// The bounds of muscles in a face file. They keep a motion within what can be integrated in time.

namespace mien {

inline constexpr double kLeastStiffness = 1e-3, kMostStiffness = 1e6;  ///< [1/s²]
inline constexpr double kLeastDamping = 1e-2, kMostDamping = 1e4;      ///< [1/s]
inline constexpr double kMostStrength = 1e6;                           ///< [1/s²]

}  // namespace mien
