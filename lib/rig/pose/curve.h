#pragma once
// The value of a curve in time at a moment.

#include <mien/motion.h>

namespace mien {

/// The curve's value at `time` [s], finite. At a key it is the key's value exactly.
double value_at(const Curve& curve, double time);

}  // namespace mien
