#pragma once
// All colours of a face, from the few that its recipe chooses.

#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/compose/part_geometry.h"
#include "lib/parts/compose/part_style.h"
#include "lib/picture/oklch.h"

namespace mien {

/// The colour that a part is: {"color": [L, C, h]}.
Oklch color_of(const Part& part);

/// The skin's, of a tone from 1 to 10 as the Monk scale counts.
Oklch skin_color(const PartLibrary& library, double tone, double undertone);

/// Writes the palette of a face file. A rule is {"is": [L, C, h]}, {"part": FAMILY}, {"skin": true},
/// {"from": COLOUR, "L": a or [a, by darkness], "C": …, "h": …} or {"mix": [COLOUR, COLOUR], "share": s}, each
/// with "alpha"; or "#rrggbb", or another colour's name.
void write_palette(const ChosenParts& parts, const PartGeometry& geometry, const PartStyle& style,
                   TreeWriter& to);

}  // namespace mien
