#pragma once
// Why a picture could not be drawn, in a sentence.

#include <mien/expected.h>
#include <mien/view.h>

namespace mien {

bool drawable(const View& view);  ///< its sides are 1 … View::kMaxSide
Error invalid_size(const View& view);
Error out_of_memory(const PixelRect& rect);
Error drawing_cancelled();

}  // namespace mien
