#pragma once
// The letters of the command's own captions, and of faces with text in them.

#include <mien/face_letters.h>
#include <mien/text_path.h>

namespace mien::command {

inline const Lettering& letters() {
  static const Lettering shipped = shipped_lettering();
  return shipped;
}

inline const Letters& face_letters() {
  static const Letters shipped = shipped_letters();
  return shipped;
}

}  // namespace mien::command
