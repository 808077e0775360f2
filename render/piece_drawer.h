#pragma once
// Draws one picture piece by piece: tiles for a viewer, or strips for a file.
//
//   auto drawer = mien::PieceDrawer::of(scene, {.width = 65536, .height = 65536});
//   drawer->draw({tile.data(), 4 * 256}, {x, y, 256, 256});   // on any thread, in any order
//
// The picture's outlines and their order are computed once for all pieces. Rendering regions of a View
// computes them again for each region.

#include <mien/api.h>
#include <mien/expected.h>
#include <mien/image.h>
#include <mien/limits.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <functional>
#include <memory>

namespace mien {

/// The pixels are those of render (render.h). Several threads may draw at once, each its own piece. Each
/// borrows scratch memory while it draws, so there is as much of it as there are threads drawing.
class MIEN_API PieceDrawer {
 public:
  /// The view's region is ignored. Errors as for render. `stop` is called every 10 ms or so. The limits are for this
  /// and for every piece.
  static Expected<PieceDrawer> of(const Scene& scene, const View& view, Depth depth = Depth::u8,
                                  const RenderLimits& limits = {},
                                  const std::function<bool()>& stop = {});
  PieceDrawer(PieceDrawer&&) noexcept;
  PieceDrawer& operator=(PieceDrawer&&) noexcept;
  ~PieceDrawer();

  /// Draws a piece of the whole picture into `out`, from its first byte on. The drawer's depth counts, not
  /// out.depth. `stop` is called every 10 ms or so. Errors: the piece is not in the picture; memory ran
  /// out; a limit; `stop` asked to stop. The work of this piece is added to `stats`.
  Expected<Done> draw(const PixelBuffer& out, const PixelRect& piece,
                      const std::function<bool()>& stop = {}, RenderStats* stats = nullptr);

 private:
  struct Parts;
  explicit PieceDrawer(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace mien
