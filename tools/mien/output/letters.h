#pragma once
// The lettering of the command's own captions.

#include <mien/text_path.h>

namespace mien::command {

inline const Lettering& letters() {
  static const Lettering shipped = shipped_lettering();
  return shipped;
}

}  // namespace mien::command
