#pragma once
// The displacements of the points of a face, as a picture.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/lettering.h>
#include <mien/scene.h>

namespace mien {

struct MorphHeat {
  Scene scene;
  double largest = 0;  ///< [face units] the largest displacement of any point, at the top of
                       ///< the colour bar
};

/// Draws the posed face in grey. For each point there is a line from its place at rest to its posed place and a
/// disc at the end, coloured by its displacement in the heat spectrum, from 0 to the largest. A bar at the right shows
/// the spectrum, with both ends labelled in the canvas's unit if there are letters. `posed` is `rest`, posed.
MIEN_API MorphHeat morph_heat(const Face& rest, const Face& posed, const Lettering& letters = {});

}  // namespace mien
