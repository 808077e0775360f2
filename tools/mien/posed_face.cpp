#include <mien/lib/file/face_file.h>
#include <mien/tools/mien/posed_face.h>
#include <mien/tools/mien/values.h>

#include <utility>
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

FaceAndPoseOrCode read_face_and_pose(const PosedFace& arguments) {
  Pose pose;
  if (arguments.time) {
    const auto time = read_time(*arguments.time);
    if (!time) return {{}, {}, complain(time.error(), kUsedWrongly)};
    pose.time = *time;
  }
  auto face = read_face_aloud(arguments.face);
  if (!face) return {{}, {}, kFailed};
  for (const std::string& text : arguments.settings) {
    auto setting = read_setting(*face, text);
    if (!setting) return {{}, {}, complain(setting.error(), kUsedWrongly)};
    pose.settings.push_back(*std::move(setting));
  }
  return {std::move(face), std::move(pose), kDone};
}

PosedOrCode read_posed_face(const PosedFace& arguments) {
  const FaceAndPoseOrCode read = read_face_and_pose(arguments);
  if (!read.face) return {{}, read.code};
  return {pose_face(*read.face, read.pose), kDone};
}

}  // namespace mien::command
