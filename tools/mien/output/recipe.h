#pragma once
// What made a picture, as JSON for its metadata.

#include "tools/mien/cli/arguments.h"
#include "tools/mien/commands/render_plan.h"

#include <string>

namespace mien::command {

/// {"mien": "0.1.0", "face": "toon.face.json", "size": "1024x768", "set": ["blink=0.5"], …}: the
/// face by its file's name without folders, and the options that were given and change the picture.
std::string recipe(const RenderArguments& arguments, const View& view);

}  // namespace mien::command
