#pragma once
// What a style's own features do when the face moves: members that are added to the topology's controls.
//
//   "controls"  {"blink": {"offset": {"eye_dot/radii": {"$vector": [0.03, 0], "in": "eye"}}}}

#include "lib/parts/compose/flat_rig.h"

namespace mien {

/// Writes the topology's controls, with the style's members in theirs.
void write_controls(const Reading& in, const JsonNode& controls, const PartStyle& style,
                    const RigPlace& place, TreeWriter& to);

}  // namespace mien
