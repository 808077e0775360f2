#pragma once
// How long work is watched and stopped.

#include <functional>

namespace mien {

/// Called now and then, never at the same time from two threads, with the share done in [0, 1]
/// (never falling). Returning false asks the work to stop; it stops within about 50 ms.
using Progress = std::function<bool(double done)>;

}  // namespace mien
