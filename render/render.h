#pragma once
// Scene in, pixels out: the exact box-filtered picture, to within one level of 255.
//
//   const Expected<Image> picture = render(scene, {.width = 1920, .height = 1080});
//
// A scene is never modified; calls may run in parallel. The pixels depend on scene and view alone: never
// on threads, region or anything drawn before.

#include <mien/api.h>
#include <mien/expected.h>
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
  Progress progress;  ///< may cancel
};

/// Draws the scene through the view into an image: any Scene and any View. Errors, one sentence each:
/// a side outside 1 … View::kMaxSide; more pixels than there is memory for; cancelled. `stats` is left
/// alone where nothing was begun.
MIEN_API Expected<Image> render(const Scene& scene, const View& view, const RenderOptions& how = {},
                                RenderStats* stats = nullptr);

/// The same into the caller's buffer, which holds drawn_rect(view).height rows of
/// drawn_rect(view).width pixels. `how.depth` is ignored in favour of the buffer's. Errors as
/// render's; the pixels are then unspecified.
MIEN_API Expected<Done> render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                                    const RenderOptions& how = {}, RenderStats* stats = nullptr);

}  // namespace mien
