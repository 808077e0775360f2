#pragma once
// A scene drawn as the options say, effects and all.

#include <mien/effect.h>
#include <mien/face.h>
#include <mien/render.h>
#include "tools/mien/cli/arguments.h"
#include "tools/mien/commands/render_plan.h"

#include <vector>

namespace mien::command {

/// The effects asked for with --effect ("none": none), else the face's own; checked for a picture of
/// that width.
Expected<std::vector<Effect>> read_effects(const RenderArguments& arguments, const Face& face,
                                           int width);

/// A picture for a sheet. Its size has been checked, so only memory can be lacking: then std::bad_alloc is
/// thrown.
Image sheet_picture(const Scene& scene, const View& view);

/// Draws; effects see the whole picture even where only a region of it is kept. An error's `where`
/// is left empty.
Expected<Image> drawn_picture(const Scene& scene, const View& view, const RenderOptions& how,
                              const std::vector<Effect>& effects);

}  // namespace mien::command
