#pragma once
// The poses that the nonsense test looks at.

#include <mien/face.h>
#include <mien/pose.h>

#include <string>
#include <vector>

namespace mien {

struct NonsensePose {
  std::string name = "rest";  ///< as --set takes it, word by word: "emotion.joy=1 yaw=30"
  Pose pose;
  std::string feeling;       ///< "emotion.joy", where it is one emotion alone, seen from the front
  double blink = 0;          ///< of both eyes
  bool turned = false;       ///< by yaw or pitch, beside what emotions do
  bool moves_head = true;    ///< emotions do, ARKit's shapes and visemes do not, however turned
  bool lips_shut = false;    ///< whatever the jaw does
  bool bites = false;        ///< the lower lip touches the upper teeth
  double jaw = 0;            ///< how far it is open at least
  bool lowers_brow = false;  ///< anger and disgust lay the brows upon the lids
};

/// Rest; six emotions at ½ and 1; their 15 pairs; what an idle face moves beside eyes and head, at both ends; ARKit's 52
/// shapes and 15 visemes at 1: each as it is and with shut eyes, the first 13 also half shut. Then rest and the six
/// emotions with lips shut on a jaw that is open by 0.2, 0.6 and 1, and with the visemes PP and FF. The first 13 turn by yaw and pitch to the ends of
/// their ranges, 30° at most, in all 8 directions; pairs in 4; what is left to both sides. What a face
/// has no control for is left out. Rest comes first.
std::vector<NonsensePose> nonsense_poses(const Face& face);

}  // namespace mien
