#pragma once
// Frames of numbers by name, as JSON: {"jawOpen": 0.4, …}, {"mouth.left/points/2": [70, 150], …}. A frame may also stand
// inside an object, as its member "blendShapes" or "points", or as MediaPipe has it: a list of
// {"categoryName": "jawOpen", "score": 0.4}, perhaps in {"categories": …}, in {"faceBlendshapes": [ONE FACE]}. What stands
// beside such a member and is not about the frame (its time, the face's name, landmarks) is an error.

#include <mien/expected.h>
#include <mien/face_limits.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien {

struct FrameNumber {
  std::string name;
  std::vector<double> values;  ///< at least 1
  std::string where;           ///< "FILE:LINE:COLUMN: /pointer"
};

Expected<std::vector<FrameNumber>> read_frame(const std::filesystem::path& path,
                                              const FaceLimits& limits = {});
Expected<std::vector<FrameNumber>> read_frame_text(std::string_view text,
                                                   std::string_view name = "frame",
                                                   const FaceLimits& limits = {});

}  // namespace mien
