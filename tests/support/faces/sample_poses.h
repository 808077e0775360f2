#pragma once
// The sample faces in poses that judges look at.

#include <mien/mien.h>

#include <string>
#include <vector>

namespace mien::test {

inline constexpr const char* kSampleFaces[] = {"seed0", "male",       "toon",        "bruno",
                                               "clay",  "faces/toon", "faces/bruno", "faces/clay"};

struct NamedPose {
  std::string name;  ///< "rest", "joy", "anger", "surprise", "blink_half", "blink", "turn_left", …
  Pose pose;
};

/// Those of them that the face has.
std::vector<NamedPose> sample_poses(const Face& face);

}  // namespace mien::test
