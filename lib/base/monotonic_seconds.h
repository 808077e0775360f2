#pragma once
// A clock that never goes back, for telling how long something took.

#include <chrono>

namespace mien {

/// [s] since some moment.
inline double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace mien
