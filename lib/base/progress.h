#pragma once
// How callers watch and cancel long work.

#include <functional>

namespace mien {

/// Called now and then with the share done, in [0, 1] and never decreasing; never from two threads at
/// once. Returning false asks the work to stop, which it does within about 50 ms.
using Progress = std::function<bool(double done)>;

}  // namespace mien
