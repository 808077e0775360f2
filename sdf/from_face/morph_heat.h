#pragma once
// How far each point of a face has gone, as a picture.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/lettering.h>
#include <mien/scene.h>

namespace mien {

struct MorphHeat {
  Scene scene;
  double largest = 0;  ///< [face units] what the top of the colour bar stands for: the largest
                       ///< displacement of any point
};

/// The posed face in grey; a line from where each point rests to where it is, and a disc there, in the
/// heat spectrum of its displacement, from 0 to the largest; a bar of that spectrum at the right, both its ends labelled in the canvas's unit if
/// there are letters. `posed` is `rest`, posed.
MIEN_API MorphHeat morph_heat(const Face& rest, const Face& posed, const Lettering& letters = {});

}  // namespace mien
