#pragma once
// Finished rows of the frame before, for a frame that changes little: a row in which nothing changed
// (changed_bands.h) is copied instead of drawn.
//
// This costs a copy of every row that is drawn. So nothing is kept until two frames in a row have some of their shapes
// in common, and keeping pauses where it was of no use.

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
    int shapes, in_common;  ///< with the frame before
  };
  /// To be called for every frame. Returns whether it is to be kept; rows of the one before may then be there.
  bool begin(const Frame& frame);
  /// Rows from `top` to `bottom`, since something in them changed.
  void forget(int top, int bottom);

  bool holds(int y) const { return held_[std::size_t(y)]; }
  /// Copy a row. Different rows may be copied at the same time.
  void recall(int y, std::byte* to) const;
  void keep(int y, const std::byte* from);

  /// How many of a frame's rows were recalled: keeping pauses for a while if there were too few.
  void end(int rows, int recalled);

 private:
  bool is_like_before(const Frame& frame) const;

  Frame before_{};
  int in_vain_ = 0, rest_ = 0;  ///< [frames]
  bool filled_ = false;         ///< the frame before was kept
  std::size_t row_bytes_ = 0;
  std::vector<char> held_;  ///< by row
  std::vector<std::byte> rows_;
};

}  // namespace mien
