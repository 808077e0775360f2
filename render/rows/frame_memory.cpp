#include "render/rows/frame_memory.h"

#include <algorithm>
#include <cstring>

namespace mien {

/// Pieces of one picture have no row in common: nothing of them comes again.
bool FrameMemory::is_like_before(const Frame& f) const {
  const PixelRect &now = f.rect, &then = before_.rect;
  return f.rows == before_.rows && f.depth == before_.depth && now.x == then.x &&
         now.width == then.width && now.y < then.y + then.height && then.y < now.y + now.height;
}

bool FrameMemory::begin(const Frame& frame) {
  constexpr int kUseful = 8;  // one row in so many is worth it
  const bool like_before = is_like_before(frame);
  before_ = frame;
  const std::size_t row_bytes = std::size_t(frame.rect.width) * 4 * bytes_per_channel(frame.depth);
  const std::size_t bytes = row_bytes * std::size_t(frame.rows);
  if (!like_before || kUseful * frame.same < frame.rect.height || bytes > kMost) {
    std::fill(held_.begin(), held_.end(), 0);
    return false;
  }
  if (row_bytes_ != row_bytes || held_.size() != std::size_t(frame.rows)) {
    row_bytes_ = row_bytes;
    rows_.resize(bytes);
    held_.assign(std::size_t(frame.rows), 0);
  }
  return true;
}

void FrameMemory::forget(int top, int bottom) {
  std::fill(held_.begin() + top, held_.begin() + bottom, 0);
}

void FrameMemory::recall(int y, std::byte* to) const {
  std::memcpy(to, &rows_[row_bytes_ * std::size_t(y)], row_bytes_);
}

void FrameMemory::keep(int y, const std::byte* from) {
  std::memcpy(&rows_[row_bytes_ * std::size_t(y)], from, row_bytes_);
  held_[std::size_t(y)] = 1;
}

}  // namespace mien
