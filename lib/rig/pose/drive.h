#pragma once
// What a channel at a value does to the face vector.

#include <mien/control.h>
#include <mien/face.h>
#include <mien/layout.h>

namespace mien {

/// Lets all drives of `channel` act on `vector`, in order, at `value`, which is in the channel's
/// range.
void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector);

/// The same with scratch that the caller keeps, so that nothing is allocated after the first frames.
void drive(const Channel& channel, double value, const Layout& layout, FaceVector& vector,
           std::vector<double>& scratch);

}  // namespace mien
