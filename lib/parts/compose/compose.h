#pragma once
// A recipe becomes a face: parts are put on the topology, then nothing of them is left.

#include <mien/expected.h>
#include "lib/file/json/json_tree.h"
#include "lib/parts/compose/chosen_parts.h"

namespace mien {

/// The tree of a face file of format version 1, for a reader of trees: it never was text. The parts must
/// outlive it, and so must their library. The error names what a part asks for that is not there.
Expected<JsonTree> composed_face(const ChosenParts& parts);

}  // namespace mien
