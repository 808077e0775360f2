#pragma once
// A picture of an experiment: who is seen, at what pose, and how it is drawn.

#include <mien/face.h>
#include <mien/image.h>
#include <mien/recipe.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mien::command {

/// What is made of a drawn face.
enum class StimulusPicture {
  whole,
  mirror,  ///< left and right changed
  left,    ///< the picture's left half and its mirror image
  right    ///< the picture's right half and its mirror image
};
inline constexpr std::string_view kStimulusPictures[] = {"whole", "mirror", "left", "right"};

struct Stimulus {
  std::string file;  ///< "0001.png"
  std::vector<std::pair<std::string, std::string>>
      levels;  ///< of each factor, as the manifest says it
  Recipe recipe;
  std::vector<std::pair<std::string, double>> controls;  ///< "emotion.joy", "blink"
  StimulusPicture picture = StimulusPicture::whole;
};

/// The face of its recipe, at rest.
Expected<Face> composed_stimulus(const Stimulus& stimulus);

/// That face at its pose. Errors: an unknown control, or a value out of its range.
Expected<Face> posed_stimulus(const Face& composed, const Stimulus& stimulus);

/// The picture of the posed face, `size` pixels on the longer side.
Expected<Image> stimulus_picture(const Face& posed, StimulusPicture picture, int size);

/// The root mean square distance between the same points of two faces, in face units. Points that only one
/// of them has do not count.
double displacement(const Face& one, const Face& other);

}  // namespace mien::command
