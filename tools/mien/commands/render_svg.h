#pragma once
// mien render FACE -o FACE.svg: shapes instead of pixels.

#include "tools/mien/cli/arguments.h"

namespace mien::command {

/// By the extension, in any case.
bool asks_for_svg(const RenderArguments& arguments);

/// What the SVG file leaves out or simplifies is printed as warnings. Returns the exit code.
int render_svg(const RenderArguments& arguments);

}  // namespace mien::command
