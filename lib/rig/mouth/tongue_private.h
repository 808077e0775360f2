#pragma once
// The tongue: its body behind the lower teeth, its tip at the upper teeth's edge, and the tongue that is out.

#include "mouth_vector_private.h"

#include <optional>

namespace mien {

/// Places the tongue in a mouth that is open as `line`; at rest its body took `share` of the mouth's half width.
/// `lip_bottom` is the height of the painted lower lip's middle.
void move_tongue(const MouthNumbers& n, const Mouth& mouth, const std::optional<TeethEdge>& teeth,
                 const LipLine& line, double share, double lip_bottom, MouthVector& to);

}  // namespace mien
