// Any bytes as JSON: frames of MediaPipe and ARKit, Rhubarb's cues, Azure's events and frames.

#include "fuzz/support/motion_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mien::fuzz::require_reader(mien::json_motion_reader, data, size);
  return 0;
}
