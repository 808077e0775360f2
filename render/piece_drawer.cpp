#include <mien/piece_drawer.h>
#include "render/render_error.h"
#include "render/rows/drawing.h"

#include <fmt/format.h>

#include <new>

namespace mien {

struct PieceDrawer::Parts {
  int width = 0, height = 0;
  Drawing drawing;
  StripScratches scratches;

  bool hold(const PixelRect& piece) const {
    return piece.x >= 0 && piece.y >= 0 && piece.width >= 1 && piece.height >= 1 &&
           piece.x <= width - piece.width && piece.y <= height - piece.height;
  }
};

PieceDrawer::PieceDrawer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PieceDrawer::PieceDrawer(PieceDrawer&&) noexcept = default;
PieceDrawer& PieceDrawer::operator=(PieceDrawer&&) noexcept = default;
PieceDrawer::~PieceDrawer() = default;

Expected<PieceDrawer> PieceDrawer::of(const Scene& scene, const View& view, Depth depth) {
  if (!drawable(view)) return invalid_size(view);
  try {
    auto parts = std::make_unique<Parts>();
    parts->width = view.width, parts->height = view.height;
    View whole = view;
    whole.region.reset();
    parts->drawing.make(scene, whole, depth);
    return PieceDrawer(std::move(parts));
  } catch (const std::bad_alloc&) {
    return out_of_memory({0, 0, view.width, view.height});
  }
}

Expected<Done> PieceDrawer::draw(const PixelBuffer& out, const PixelRect& piece,
                                 const std::function<bool()>& stop, RenderStats* stats) {
  if (!parts_->hold(piece))
    return Error{"",
                 fmt::format("the piece {},{},{},{} is not in a picture of {} x {} pixels", piece.x,
                             piece.y, piece.width, piece.height, parts_->width, parts_->height)};
  constexpr int kAtOnce = 4;  // strips between two checks for a stop
  const int first = piece.y / Drawing::kRows, last = (piece.y + piece.height - 1) / Drawing::kRows;
  RenderStats took;
  try {
    auto scratch = parts_->scratches.take();
    for (int strip = first; strip <= last && !took.cancelled; ++strip) {
      parts_->drawing.draw_strip(strip, {static_cast<std::byte*>(out.data), out.stride, piece},
                                 *scratch, took);
      took.cancelled = stop && (strip - first) % kAtOnce == 0 && stop();
    }
    parts_->scratches.give_back(std::move(scratch));
  } catch (const std::bad_alloc&) {
    return out_of_memory(piece);
  }
  took.pixels += (long long)piece.width * piece.height;
  parts_->drawing.tell(took);
  if (stats) stats->add(took);
  if (took.cancelled) return drawing_cancelled();
  return Done{};
}

}  // namespace mien
