#pragma once

#include "bench/whole/frame_case.h"
#include "bench/whole/options.h"

namespace mien::bench {

/// A case's frames and draws beside Cairo's and the floor, one line. False if the two pictures are
/// not of the same thing: then that is said, too.
bool beside_cairo(const Options& options, const FrameCase& c);

std::string beside_cairo_head();

}  // namespace mien::bench
