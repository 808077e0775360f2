#pragma once
// The mouth of a face: jaw, lips, teeth, tongue, and what rides on them (docs/rig.md has the laws).

#include <mien/face.h>

#include <span>

namespace mien {

struct FaceModel;

/// Moves the mouth, before the head turns: everything but the closing of the edges. `rest` are the numbers that the
/// mouth was drawn with, `values` those of all channels. `before` is scratch memory.
void pose_mouth(const FaceModel& model, const FaceVector& rest, std::span<const double> values,
                FaceVector& before, FaceVector& vector);

/// Closes the lips, after all else: at closure 1 both inner edges are the same curve, bit for bit. Painted lips ride.
void close_lips(const FaceModel& model, std::span<const double> values, FaceVector& vector);

}  // namespace mien
