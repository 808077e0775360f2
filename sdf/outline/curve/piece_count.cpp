#include "sdf/outline/curve/piece_count.h"
#include "lib/base/watch.h"

#include "boundary_private.h"

namespace mien {
namespace {

/// Pieces that are held at least, and twice as many at most.
constexpr std::size_t kHeldPieces = 256;
/// A side adds fewer. While more are held than that, what was forgotten has not changed.
constexpr std::size_t kAddedBySide = 16;

}  // namespace

PieceCount::PieceCount(const OutlineFrame& frame) : map_(frame.grid_from_face) {
  loop_.frame(frame.window, frame.tolerance, held_);
  loop_.outline(FillRule::nonzero);
  window_ = loop_.window();
}

void PieceCount::add(const Path& path) {
  BoundaryWriter{*this, map_, map_.scale()}(path);
}

void PieceCount::begin(glm::dvec2 p) {
  held_.pieces.clear(), held_.chains.clear(), held_.turns.clear();
  before_ = 0, lost_ = false;
  loop_.begin(p);
  at_ = p;
}

void PieceCount::line(glm::dvec2 to) {
  if (!lost_) loop_.line(to);
  at_ = to;
  forget();
}

void PieceCount::quad(glm::dvec2 control, glm::dvec2 to) {
  if (!lost_) loop_.quad(control, to);
  at_ = to;
  forget();
}

void PieceCount::close() {
  if (lost_) return;
  loop_.close();
  const std::size_t held = held_.pieces.size();
  if (held > (before_ > 0 ? kAddedBySide : 0)) pieces_ += before_ + held;
}

void PieceCount::forget() {
  const std::size_t held = loop_.sides();
  if (before_ > 0 && held <= kAddedBySide) lost_ = true;
  if (held < 2 * kHeldPieces) return;
  const std::size_t gone = held - kHeldPieces;
  before_ += loop_.forget_sides(gone);
  worked(40 * std::int64_t(gone));
}

}  // namespace mien
