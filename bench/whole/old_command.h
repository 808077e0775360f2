#pragma once
// Another build's `mien` command, timed by its own `mien bench`.

#include <string>

#include "bench/whole/frame_case.h"
#include "bench/whole/options.h"

namespace mien::bench {

/// One run of `PROGRAM bench FACE …`: what it said, or why it said nothing of use.
struct OldRun {
  double median_ms = 0;  ///< of its frames; 0: see `why`
  std::string why;
};
OldRun run_old(const Options& options, const FrameCase& c, int frames);

/// A case drawn by this build and by the old one, in turns: one line. False if the old one cannot.
bool beside_old(const Options& options, const FrameCase& c);

std::string beside_old_head();

}  // namespace mien::bench
