#pragma once
// RenderArguments understood: what to draw, how, and into which kind of file.

#include <mien/debug_picture.h>
#include <mien/render.h>
#include <mien/write.h>
#include "tools/mien/cli/arguments.h"

#include <optional>
#include <string>

namespace mien::command {

/// Without --size the longer side has so many pixels.
inline constexpr int kDefaultSide = 1024;

struct RenderPlan {
  View view;
  PictureOptions picture;
  bool stats = false;
  std::optional<DebugPicture> debug;     ///< this instead of the picture
  std::optional<std::string> error_map;  ///< a file for the certified bounds, beside the picture
  WriteOptions error_map_write;
};

/// Frames that `mien bench` measures without --repeat.
inline constexpr int kDefaultRepeat = 50;

/// Everything that can be planned without the face: files, depths, counts. `plan_view` adds what depends on
/// its canvas.
Expected<RenderPlan> plan_render(const RenderArguments& arguments);
/// The same for a picture that goes nowhere: `output` is not read, any depth will do (u8 unless said).
Expected<RenderPlan> plan_frame(const RenderArguments& arguments);
Expected<Done> plan_view(RenderPlan& plan, const RenderArguments& arguments, const Canvas& canvas);

}  // namespace mien::command
