#pragma once
// Scene in, pixels out: the exact box-filtered picture, to within one level of 255.
//
//   const Image picture = render(scene, {.width = 1920, .height = 1080});
//
// A scene is never modified; calls may run in parallel. The pixels depend on scene and view alone: never
// on threads, region or anything drawn before.

#include <mien/api.h>
#include <mien/image.h>
#include <mien/parallel.h>
#include <mien/progress.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/view.h>

namespace mien {

/// How to draw it: may change the time, never one bit of the picture.
struct RenderOptions {
  Depth depth = Depth::u8;
  Threads threads;
  Progress progress;  ///< may cancel; a cancelled picture's pixels are unspecified
};

/// Draws the scene through the view into an image. Total: any Scene and any View. Where there can be
/// no picture (a side outside 1 … View::kMaxSide, or more pixels than there is memory for) the image
/// is the empty one, 0 × 0, and `stats` is left alone.
MIEN_API Image render(const Scene& scene, const View& view, const RenderOptions& how = {},
                      RenderStats* stats = nullptr);

/// The same into the caller's buffer, which holds drawn_rect(view).height rows of
/// drawn_rect(view).width pixels. `how.depth` is ignored in favour of the buffer's. Returns whether
/// it was drawn to the end: not if it was cancelled, a side is invalid or memory ran out.
MIEN_API bool render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                          const RenderOptions& how = {}, RenderStats* stats = nullptr);

}  // namespace mien
