#pragma once
// Sample faces, their numbers and poses, for tests of lib alone. Throws what a test then shows.

#include <mien/face_file.h>
#include <mien/face_model.h>
#include <mien/pose.h>

#include <glm/vec2.hpp>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/faces/face_path.h"

namespace mien::test {

inline Face sample_face(const std::string& name) {
  const Expected<Face> face = read_face(face_path(name));
  if (!face) throw std::runtime_error(sentence(face.error()));
  return *face;
}

inline std::string text_of_face(const std::string& name) {
  std::ifstream file(face_path(name));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

inline std::vector<double> slice_of(const Face& face, std::string_view name) {
  const int slice = face.model->layout.find(name);
  if (slice < 0) throw std::runtime_error("no slice " + std::string(name));
  const auto first = face.vector.begin() + face.model->layout[slice].begin;
  return {first, first + face.model->layout[slice].size};
}

/// The inner edge of a lip, "upper" or "lower": its bends, left and right.
inline std::vector<double> inner_edge_of(const Face& face, const std::string& which) {
  std::vector<double> all;
  for (const char* side : {"left", "right"})
    for (const char* bend : {"0", "1"})
      for (const double x : slice_of(face, which + "_edge." + side + "/spine/" + bend))
        all.push_back(x);
  return all;
}

inline glm::dvec2 point_of(const Face& face, std::string_view name) {
  const std::vector<double> xy = slice_of(face, name);
  return {xy[0], xy[1]};
}

/// A pose by the words of --set.
inline Pose pose_of(const Face& face, const std::vector<std::string>& settings) {
  Pose pose;
  for (const std::string& text : settings) {
    const Expected<Setting> setting = read_setting(face, text);
    if (!setting) throw std::runtime_error(sentence(setting.error()));
    pose.settings.push_back(*setting);
  }
  return pose;
}

inline Face face_at(const Face& face, const std::vector<std::string>& settings) {
  return pose_face(face, pose_of(face, settings));
}

/// Names of the face's poses that begin so ("lid." → "lid.sad", …), those for both sides.
inline std::vector<std::string> poses_named(const Face& face, std::string_view begin) {
  std::vector<std::string> names;
  for (const Control& control : face.model->controls)
    if (control.pose && control.channels.size() == 2 && control.name.starts_with(begin))
      names.emplace_back(control.name);
  return names;
}

}  // namespace mien::test
