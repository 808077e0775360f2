#include "render/piece_drawer.h"
#include "render/rows/drawing.h"

namespace mien {

struct PieceDrawer::Parts {
  Drawing drawing;
  StripScratches scratches;
};

PieceDrawer::PieceDrawer(const Scene& scene, const View& view, Depth depth)
    : parts_(std::make_unique<Parts>()) {
  parts_->drawing.make(scene, view, depth);
}
PieceDrawer::~PieceDrawer() = default;

bool PieceDrawer::draw(const PixelBuffer& out, const PixelRect& piece,
                       const std::function<bool()>& stop, RenderStats& stats) {
  constexpr int kAtOnce = 4;  // strips between two questions
  auto scratch = parts_->scratches.take();
  const int first = piece.y / Drawing::kRows, last = (piece.y + piece.height - 1) / Drawing::kRows;
  bool whole = true;
  for (int strip = first; strip <= last && whole; ++strip) {
    parts_->drawing.draw_strip(strip, {static_cast<std::byte*>(out.data), out.stride, piece},
                               *scratch, stats);
    whole = (strip - first) % kAtOnce != 0 || !stop();
  }
  parts_->scratches.give_back(std::move(scratch));
  stats.pixels += (long long)piece.width * piece.height;
  parts_->drawing.tell(stats);
  return whole;
}

}  // namespace mien
