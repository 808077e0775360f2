// Any bytes as lines with a sound in each: marks, and the .pho files of espeak and MBROLA.

#include "fuzz/support/motion_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mien::fuzz::require_reader(mien::marks_reader, data, size);
  mien::fuzz::require_reader(mien::pho_reader, data, size);
  return 0;
}
