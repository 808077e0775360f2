#pragma once
// What moves a face: the topology's controls, muscles, emotions and clips, solved once for all faces, in the frames of one.

#include "lib/parts/compose/flat_feature.h"

namespace mien {

/// Where a rig is written: the face's frames and features, and the library's slots.
struct RigPlace {
  const PartLibrary& library;
  const PartGeometry& geometry;
  const FlatFeatures& features;
};

/// Writes a node of the topology; {"$point": [x, y], "in": FRAME}, {"$vector": …}, {"$length": …} and {"$value": …}
/// are put in the frame. {"$rise": {"from": POINT, "to": POINT}, "times": k} is k times the height of one over the other. {"$still": OFFSET, "slots": […]} becomes {"FEATURE/*": OFFSET, …}, of the features in those slots
/// that stand still while the head turns.
void write_rig(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to);

/// Writes what stands for one object, where it is such a place; tells whether it was one.
bool write_placed(const Reading& in, const JsonNode& at, const RigPlace& place, TreeWriter& to);

/// The muscle system: strokes and origins in their frames, and everything that parts bound to what a muscle holds.
/// `more`: what else muscles hold, by their names, {"mentalis": {"NUMBER": {"weight": …, "stroke": …}}}; may be null.
void write_muscles(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                   const FlatFeatures& features, const JsonNode* more, TreeWriter& to);

/// The head's turn, with the depths of what parts drew.
void write_turn(const Reading& in, const JsonNode& node, const RigPlace& place, TreeWriter& to);

}  // namespace mien
