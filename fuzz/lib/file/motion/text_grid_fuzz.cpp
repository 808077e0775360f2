// Any bytes as Praat's TextGrid.

#include "fuzz/support/motion_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mien::fuzz::require_reader(mien::text_grid_reader, data, size);
  return 0;
}
