#pragma once

#include "bench/whole/options.h"

namespace mien::bench {

/// 1000 thumbnails of toon, 128 pixels wide, each at a pose of its own, pose to pixels, on
/// options.threads threads, each with a renderer of its own: seconds in all.
void thumbnails(const Options& options);

}  // namespace mien::bench
