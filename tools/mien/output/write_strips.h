#pragma once
// Pictures that are made from the top down, strip by strip, and written as they come. So effects and debug
// pictures hold no more of a picture than they are allowed.

#include <mien/write.h>
#include "render/image/picture_encoder.h"

#include <functional>

namespace mien::command {

struct StripPicture {
  PictureFrame frame;
  std::uint64_t row_bytes = 0;  ///< held for each row of a strip
  int rows = 1;                 ///< of a strip, where the memory allows
  /// The picture's rows from y on, in the frame's depth; strips come in order. Errors: cancelled; a limit. If memory
  /// is lacking, it throws std::bad_alloc.
  std::function<Expected<Image>(int y, int rows, const Progress& progress)> strip;
};

/// Writes the same file for any memory and threads. Filling `render` of the stats is left to the caller.
Expected<PictureStats> write_strips(const StripPicture& picture, const std::string& output,
                                    const PictureOptions& how);

}  // namespace mien::command
