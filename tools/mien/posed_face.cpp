#include <mien/lib/file/face_file.h>
#include <mien/lib/rig/pose.h>
#include <mien/tools/mien/posed_face.h>
#include <mien/tools/mien/values.h>

#include <vector>

namespace mien::command {

std::optional<Face> read_face_aloud(const std::string& path) {
  std::vector<Error> warnings;
  auto face = read_face(path, {}, &warnings);
  warn(warnings);
  if (face) return *std::move(face);
  complain(face.error(), kFailed);
  return {};
}

PosedOrCode read_posed_face(const PosedFace& arguments) {
  Pose pose;
  if (arguments.time) {
    const auto time = read_time(*arguments.time);
    if (!time) return {{}, complain(time.error(), kUsedWrongly)};
    pose.time = *time;
  }
  const auto face = read_face_aloud(arguments.face);
  if (!face) return {{}, kFailed};
  for (const std::string& text : arguments.settings) {
    auto setting = read_setting(*face, text);
    if (!setting) return {{}, complain(setting.error(), kUsedWrongly)};
    pose.settings.push_back(*std::move(setting));
  }
  return {pose_face(*face, pose), kDone};
}

}  // namespace mien::command
