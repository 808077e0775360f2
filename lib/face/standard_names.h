#pragma once
// The names of expressions that programs agree on. "Left" in them is the subject's left, as everywhere
// in mien.
//
//   arkit    the 52 blend shapes of Apple's ARKit (ARFaceAnchor.BlendShapeLocation)
//   facs     action units of the Facial Action Coding System (Ekman, Friesen, Hager, 2002): "AU12"
//   vrm      the expression presets of VRM 1.0
//   viseme   the 15 mouth shapes that lip-sync programs use (Oculus, Ready Player Me)

#include <span>
#include <string>
#include <string_view>

namespace mien {

/// The names of a set; empty: no set of the four.
std::span<const std::string_view> standard_names(std::string_view set);

/// The standard spelling of a name, whatever program wrote it: "EyeBlinkLeft", "eyeBlink_L" and "eye_blink.l" are
/// "eyeBlinkLeft"; "AU01" and OpenFace's "AU01_r" are "AU1"; of visemes "ih", "oh", "ou" (OpenXR, Oculus) and "viseme_I"
/// are "I", "O", "U"; VRM 0's "joy" is "happy". It may stand behind "left." or "right.". Other names stay as they are.
std::string standard_spelling(std::string_view set, std::string_view name);

/// Whether the names of a set say themselves which side they mean, so that each is one number. Those
/// of other sets have a left and a right half.
bool names_have_sides(std::string_view set);

}  // namespace mien
