#pragma once
// Areas of all that a face has of some roles, "any": {"roles": ["hair", "hair.back"], "slots": ["hair"]}: one mass of hair, the
// edge round a figure. A role may be one of a slot alone, "hair.far/cloth.shade". Only what was composed before counts.

#include "lib/parts/compose/flat_feature.h"

#include <string>
#include <vector>

namespace mien {

/// Of a union, a feature that is cut to another one of them can be left out: the union is the same without it.
enum class Operands { all, of_union };

/// The names of the features that an object selects, in the order of drawing; both lists count, and a list that is not
/// there lets all through. `order`: of the area, before which they are drawn.
std::vector<std::string> selected_features(const Reading& in, const JsonNode& selection,
                                           std::size_t order, const PartLibrary& library,
                                           const FlatFeatures& features, Operands which);

}  // namespace mien
