#pragma once
// Why a picture could not be drawn, in a sentence.

#include <mien/expected.h>
#include <mien/view.h>
#include "lib/base/watch.h"

#include <string_view>

namespace mien {

/// What an error says of drawing that the caller ended.
inline constexpr std::string_view kCancelled = "cancelled";

bool drawable(const View& view);  ///< its sides are 1 … View::kMaxSide
Error invalid_size(const View& view);
Error out_of_memory(const PixelRect& rect);
Error drawing_cancelled();
/// What ended watched work.
Error why_stopped(const Watch& watch);

}  // namespace mien
