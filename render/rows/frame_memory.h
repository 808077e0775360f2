#pragma once
// Finished rows of the frame before, for a frame that changes little: a row in which nothing changed
// (changed_bands.h) is copied instead of drawn.
//
// This costs a copy of every row that is drawn. So rows are kept only of frames of which one row in eight is as in the
// frame before: the next one is probably so, too.

#include <mien/image.h>
#include <mien/view.h>

#include <cstddef>
#include <vector>

namespace mien {

class FrameMemory {
 public:
  /// [bytes] Larger pictures are not kept.
  static constexpr std::size_t kMost = std::size_t{16} << 20;

  /// What decides whether the rows of a frame are worth keeping.
  struct Frame {
    int rows;        ///< of the whole picture
    PixelRect rect;  ///< what is drawn of it
    Depth depth;
    int same;  ///< rows of it in which nothing changed
  };
  /// To be called for every frame. Returns whether it is to be kept; rows of the one before may then be there.
  bool begin(const Frame& frame);
  /// Rows from `top` to `bottom`, since something in them changed.
  void forget(int top, int bottom);

  bool holds(int y) const { return held_[std::size_t(y)]; }
  /// Copy a row. Different rows may be copied at the same time.
  void recall(int y, std::byte* to) const;
  void keep(int y, const std::byte* from);

 private:
  bool is_like_before(const Frame& frame) const;

  Frame before_{};
  std::size_t row_bytes_ = 0;
  std::vector<char> held_;  ///< by row
  std::vector<std::byte> rows_;
};

}  // namespace mien
