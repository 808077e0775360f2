#pragma once
// What moves a face: the topology's controls, muscles, emotions and clips, solved once for all faces, in the frames of one.

#include "lib/parts/compose/flat_feature.h"

#include <string>

namespace mien {

/// A node of the topology as text; {"$point": [x, y], "in": FRAME}, {"$vector": …}, {"$length": …} and {"$value": …}
/// are put in the frame.
std::string rig_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry);

/// The muscle system: strokes and origins in their frames, and everything that parts bound to what a muscle holds.
std::string muscles_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                         const FlatFeatures& features);

/// The head's turn, with the depths of what parts drew.
std::string turn_text(const Reading& in, const JsonNode& node, const PartGeometry& geometry,
                      const FlatFeatures& features);

}  // namespace mien
