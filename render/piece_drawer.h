#pragma once
// One picture, drawn piece by piece: its outlines and their order are made once for all of them.

#include <mien/api.h>
#include <mien/image.h>
#include <mien/render_stats.h>
#include <mien/scene.h>
#include <mien/view.h>

#include <functional>
#include <memory>

namespace mien {

/// The pixels are render's (render.h). Several threads may draw at once, each a piece of its own; what
/// a thread needs to draw is lent to it for that long, so there is as much of it as threads draw.
class MIEN_API PieceDrawer {
 public:
  /// The view's sides are valid. Throws where there is no memory for it, as draw does.
  PieceDrawer(const Scene& scene, const View& view, Depth depth);
  ~PieceDrawer();

  /// A piece of the whole picture, into `out` from its first byte on. `stop` is asked every few rows;
  /// false: it said so.
  bool draw(const PixelBuffer& out, const PixelRect& piece, const std::function<bool()>& stop,
            RenderStats& stats);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mien
