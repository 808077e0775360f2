#pragma once

#include "bench/whole/frame_case.h"
#include "bench/whole/options.h"

namespace mien::bench {

/// A case's frames mixed and stored as asked for, beside the same frames mixed as encoded and
/// stored in 8 bits: one line.
void beside_encoded(const Options& options, const FrameCase& c);

std::string beside_encoded_head(const Options& options);

}  // namespace mien::bench
