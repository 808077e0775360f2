#pragma once
// `mien sheet …` on the command line, and the options of one picture of it.

#include <mien/expected.h>
#include "tools/mien/cli/arguments.h"

#include <string>

namespace mien::command {

/// "near: --look-at 0,0,0.6": a name, which may be empty, and the options that `mien render` would get.
struct SheetPicture {
  std::string name;
  RenderArguments render;
};
Expected<SheetPicture> read_sheet_picture(const std::string& text);

}  // namespace mien::command
