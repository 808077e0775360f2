#pragma once
// What a style's own features do when the face moves: members that are added to the topology's controls, and a pen.
//
//   "controls"  {"blink": {"offset": {"eye_dot/radii": {"$vector": [0.03, 0], "in": "eye"}}}}
//   "pen"       {"most": 2, "lines": {"skin": "contour/widths", "glasses/frame": "contour/half_width"}}
//               by role, by slot and role or by the feature's name: what the control "pen", from 1 to `most`, multiplies

#include "lib/parts/compose/flat_rig.h"

namespace mien {

/// Writes the topology's controls, with the style's members in theirs, and the pen's after them.
void write_controls(const Reading& in, const JsonNode& controls, const PartStyle& style,
                    const RigPlace& place, TreeWriter& to);

}  // namespace mien
