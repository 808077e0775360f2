#pragma once
// Sample faces, posed by the words of the command line. Throws what a test then shows.

#include <mien/mien.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/faces/face_path.h"

namespace mien::test {

inline Face face_named(const std::string& name) {
  auto face = read_face(face_path(name));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

inline Face posed(const Face& face, const std::vector<std::string>& settings) {
  Pose pose;
  for (const std::string& text : settings) {
    auto setting = read_setting(face, text);
    if (!setting) throw std::runtime_error(sentence(setting.error()));
    pose.settings.push_back(*setting);
  }
  return pose_face(face, pose);
}

}  // namespace mien::test
