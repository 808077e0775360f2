#pragma once
// What a channel at a value does to the face vector.

#include <mien/lib/base/api.h>
#include <mien/lib/face/control.h>
#include <mien/lib/face/face.h>
#include <mien/lib/face/layout.h>

namespace mien {

/// Lets all drives of `channel` act on `vector`, in order, at `value`, which is in the channel's
/// range.
MIEN_API void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector);

/// The same with the caller's scratch, which is kept: no allocation after the first frames.
MIEN_API void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector,
                    std::vector<double>& scratch);

}  // namespace mien
