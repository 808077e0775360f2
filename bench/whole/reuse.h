#pragma once

#include "bench/whole/frame_case.h"
#include "bench/whole/options.h"

namespace mien::bench {

/// What a renderer gains from the frame before: one line of a case. Of each round the first frame
/// is cold, the second is the same again, in the third the eyes alone have moved.
void reuse(const Options& options, const FrameCase& c);

std::string reuse_head();

}  // namespace mien::bench
