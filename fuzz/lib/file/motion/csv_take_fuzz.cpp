// Any bytes as a table: of Live Link Face, OpenFace, or any with a column of times.

#include "fuzz/support/motion_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mien::fuzz::require_reader(mien::csv_take_reader, data, size);
  return 0;
}
