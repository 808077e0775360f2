#pragma once

#include "bench/whole/frame_case.h"
#include "bench/whole/options.h"

namespace mien::bench {

/// What a renderer gains from the frame before: one line of a case. Cold frames, the same frame again,
/// frames in which the eyes alone have moved, and frames in which the lids have.
void reuse(const Options& options, const FrameCase& c);

std::string reuse_head();

}  // namespace mien::bench
