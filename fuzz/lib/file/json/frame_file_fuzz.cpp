// Any bytes as a frame of numbers by name.

#include "lib/file/json/frame_file.h"

#include <cmath>
#include <cstdint>

#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const auto frame = read_frame_text({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!frame) {
    fuzz::require_sentence(frame.error());
    return 0;
  }
  for (const FrameNumber& number : *frame) {
    fuzz::require(!number.values.empty());
    for (const double value : number.values) fuzz::require(std::isfinite(value));
  }
  return 0;
}
