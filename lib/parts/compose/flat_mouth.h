#pragma once
// The mouth of a composed face: the topology's own, and everything that parts bound to its points.

#include "lib/parts/compose/flat_rig.h"

namespace mien {

/// Writes the members of the topology's "mouth", put in their frames, and "ride" and "stiff" out of its "riders":
/// {"anchors": [SLICE, …], "twins": {SLICE: SLICE, …}, "stiff": [SLOT, …], "stiff_above": {SLOT: POINT, …}}. An anchor with
/// a twin is a point of an outline; its twin is the one on the right.
void write_mouth(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to);

}  // namespace mien
