#include "render/rows/frame_memory.h"

#include <algorithm>
#include <cstring>

namespace mien {
namespace {

constexpr int kInCommon = 4;              // one shape in so many is enough in common
constexpr int kUseful = 8;                // one row in so many is worth it
constexpr int kPatience = 3, kRest = 30;  // [frames]

}  // namespace

/// Pieces of one picture have no row in common: nothing of them comes again.
bool FrameMemory::is_like_before(const Frame& f) const {
  const PixelRect &now = f.rect, &then = before_.rect;
  return f.rows == before_.rows && f.depth == before_.depth && now.x == then.x &&
         now.width == then.width && now.y < then.y + then.height && then.y < now.y + now.height;
}

bool FrameMemory::begin(const Frame& frame) {
  const bool like_before = is_like_before(frame);
  before_ = frame;
  if (!like_before) rest_ = in_vain_ = 0;
  if (rest_ > 0) --rest_;
  const std::size_t row_bytes = std::size_t(frame.rect.width) * 4 * bytes_per_channel(frame.depth);
  const std::size_t bytes = row_bytes * std::size_t(frame.rows);
  if (!like_before || rest_ > 0 || kInCommon * frame.in_common < frame.shapes || bytes > kMost) {
    filled_ = false;
    std::fill(held_.begin(), held_.end(), 0);
    return false;
  }
  if (row_bytes_ != row_bytes || held_.size() != std::size_t(frame.rows)) {
    filled_ = false;
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

void FrameMemory::end(int rows, int recalled) {
  const bool useful = !filled_ || kUseful * recalled >= rows;
  filled_ = true;
  in_vain_ = useful ? 0 : in_vain_ + 1;
  if (in_vain_ >= kPatience) in_vain_ = 0, rest_ = kRest;
}

}  // namespace mien
