#pragma once
// Renders a scene: the exact box-filtered picture, to within one level of 255.
//
//   const Expected<Image> picture = render(scene, {.width = 1920, .height = 1080});
//
// A scene is never modified, and calls may run in parallel. Pixels depend on scene and view alone, never on
// threads, the region or anything drawn before.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/image.h>
#include <mien/limits.h>
#include <mien/parallel.h>
#include <mien/progress.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/view.h>

namespace mien {

/// How to draw: may change the time or end the work, never a bit of the picture.
struct RenderOptions {
  Depth depth = Depth::u8;
  Threads threads = {};
  Progress progress = {};    ///< may cancel, wherever the work is
  RenderLimits limits = {};  ///< beyond them it is an error
};

/// Draws any scene through any view into an image. Errors, one sentence each: a side outside
/// 1 … View::kMaxSide; more pixels than memory holds; a limit of `how.limits`, by its name; cancelled. `stats` is left alone if drawing did not
/// begin.
MIEN_API Expected<Image> render(const Scene& scene, const View& view, const RenderOptions& how = {},
                                RenderStats* stats = nullptr);

/// The same into the caller's buffer, which holds drawn_rect(view).height rows of
/// drawn_rect(view).width pixels. The buffer's depth counts, not `how.depth`. Errors as for render; the
/// pixels are unspecified then.
MIEN_API Expected<Done> render_into(const PixelBuffer& out, const Scene& scene, const View& view,
                                    const RenderOptions& how = {}, RenderStats* stats = nullptr);

}  // namespace mien
