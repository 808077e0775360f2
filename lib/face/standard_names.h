#pragma once
// The names of expressions that programs agree on. "Left" in them is the subject's left, as everywhere
// in mien.
//
//   arkit    the 52 blend shapes of Apple's ARKit (ARFaceAnchor.BlendShapeLocation)
//   facs     action units of the Facial Action Coding System (Ekman, Friesen, Hager, 2002): "AU12"
//   vrm      the expression presets of VRM 1.0
//   viseme   the 15 mouth shapes that lip-sync programs use (Oculus, OpenXR, Ready Player Me)
//   azure    the 22 viseme ids of Azure's speech service: "0" … "21"

#include <span>
#include <string>
#include <string_view>

namespace mien {

/// The names of a set; empty: no set of the five.
std::span<const std::string_view> standard_names(std::string_view set);

/// The standard spelling of a name: free of case and separators, with "_L" or ".L" for Left; of action units "AU1" for
/// "AU01", "au1" and "AU01_r", which may stand behind "left." or "right."; of VRM also the names of 0.x ("joy", "blink_l");
/// of visemes also OpenXR's ("XR_FACE_TRACKING_VISEME_OH_META", "OH") and "viseme_PP". Other names stay as they are.
std::string standard_spelling(std::string_view set, std::string_view name);

/// Whether the names of a set say themselves which side they mean, so that each is one number. Those
/// of other sets have a left and a right half.
bool names_have_sides(std::string_view set);

}  // namespace mien
