#pragma once
// What the command writes with.

#include <mien/text_path.h>

namespace mien::command {

inline const Lettering& letters() {
  static const Lettering shipped = shipped_lettering();
  return shipped;
}

}  // namespace mien::command
