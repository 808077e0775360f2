#pragma once
// How the head is turned, out of a matrix.

#include "lib/file/json/reading.h"

#include <optional>

namespace mien {

/// [degrees] As the head of a face is turned: to the subject's left, up, and from the subject's left towards up.
struct HeadAngles {
  double yaw = 0, pitch = 0, roll = 0;
};

/// Of a 4 × 4 matrix that takes points of the head to the camera's space, both with x to the right of the picture, y up and
/// z towards the viewer, as MediaPipe gives it: 16 numbers by columns, perhaps under "data" or "packedData", or four rows of
/// four, where the bottom row is 0, 0, 0, 1; or a list whose first element is that. None: an empty list. The yaw is the
/// outermost turn, then the pitch. Throws a Refusal for anything else.
std::optional<HeadAngles> head_turn_of(const Reading& in, const JsonNode& node);

}  // namespace mien
