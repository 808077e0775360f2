#pragma once
// How the colour of a group meets the picture below it, by blend modes of W3C, Compositing and Blending Level 1,
// section "Blending" (https://www.w3.org/TR/compositing-1/).
//
// With colours cs of the group and cb of the picture below, straight, and opacities αs and αb, the result has the
// opacity αs + αb − αs αb and, premultiplied by it, the colour
//
//     αs (1 − αb) cs  +  αb (1 − αs) cb  +  αs αb B(cb, cs)
//
// in the space that the picture is blended in. Modes whose B has kinks (darken, overlay …) are not among them:
// where two gradients cross, a kink would be a line that no outline knows.

#include <array>
#include <string_view>

namespace mien {

enum class MixMode : unsigned char {
  normal,    ///< B = cs: laid over
  multiply,  ///< B = cb cs: as through tinted glass; nothing gets lighter
  screen     ///< B = cb + cs − cb cs: as light that is added; nothing gets darker
};

/// The names of modes in files and scenes.
inline constexpr std::array<std::string_view, 3> kMixModes{"normal", "multiply", "screen"};

}  // namespace mien
