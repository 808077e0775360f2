#pragma once
// Where the sample faces lie. Tests are pinned to those of faces/compat/, whose points never change.

#include <string>

namespace mien::test {

/// The file of a face: "toon" is of faces/compat/, "faces/toon" lies where it says.
inline std::string face_path(const std::string& name) {
  const bool says_where = name.find('/') != std::string::npos;
  return std::string(MIEN_SOURCE_DIR "/") + (says_where ? "" : "faces/compat/") + name +
         ".face.json";
}

}  // namespace mien::test
