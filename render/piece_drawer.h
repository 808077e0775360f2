#pragma once
// One picture, drawn piece by piece: a viewer's tiles, a file's strips.
//
//   auto drawer = mien::PieceDrawer::of(scene, {.width = 65536, .height = 65536});
//   drawer->draw({tile.data(), 4 * 256}, {x, y, 256, 256});   // on any thread, in any order
//
// The picture's outlines and their order are made once for all pieces; drawing a region of a View
// makes them anew each time.

#include <mien/api.h>
#include <mien/expected.h>
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
  /// The view's region does not matter. Errors as render's.
  static Expected<PieceDrawer> of(const Scene& scene, const View& view, Depth depth = Depth::u8);
  PieceDrawer(PieceDrawer&&) noexcept;
  PieceDrawer& operator=(PieceDrawer&&) noexcept;
  ~PieceDrawer();

  /// A piece of the whole picture, into `out` from its first byte on; out.depth is ignored in favour of
  /// the drawer's. `stop` is asked every few rows. Errors: the piece is not in the picture; memory ran
  /// out; it was to stop. `stats` gets what this piece took added.
  Expected<Done> draw(const PixelBuffer& out, const PixelRect& piece,
                      const std::function<bool()>& stop = {}, RenderStats* stats = nullptr);

 private:
  struct Parts;
  explicit PieceDrawer(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace mien
