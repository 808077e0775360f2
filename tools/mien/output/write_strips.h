#pragma once
// Pictures that are made from the top down, a strip of rows after the other, and written as they
// come: what is laid over a picture, and pictures about it, hold no more of it than they are allowed.

#include <mien/write.h>
#include "render/image/picture_encoder.h"

#include <functional>

namespace mien::command {

struct StripPicture {
  PictureFrame frame;
  std::uint64_t row_bytes = 0;  ///< held for each row of a strip
  int rows = 1;                 ///< of a strip, where the memory allows
  /// The picture's rows from y on, in the frame's depth; strips come in order. Empty: stopped. What
  /// does not find its memory throws std::bad_alloc.
  std::function<Image(int y, int rows, const Progress& progress)> strip;
};

/// The same file for any memory and threads. Of the stats `render` is left to the caller.
Expected<PictureStats> write_strips(const StripPicture& picture, const std::string& output,
                                    const PictureOptions& how);

}  // namespace mien::command
