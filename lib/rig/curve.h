#pragma once
// What a curve in time is worth at a moment.

#include <mien/lib/base/api.h>
#include <mien/lib/face/clip.h>

namespace mien {

/// The curve's value at `time` [s], finite. At a key it is the key's value exactly.
MIEN_API double value_at(const Curve& curve, double time);

}  // namespace mien
