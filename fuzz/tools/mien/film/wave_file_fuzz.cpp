// Any bytes as a sound: a length that is a number, a sentence, or a file of another kind.

#include "tools/mien/film/wave_file.h"

#include <cmath>
#include <cstdint>

#include "fuzz/support/bytes_as_file.h"
#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const fuzz::BytesAsFile file(data, size);
  const auto seconds = command::wave_seconds(file.path().string());
  if (!seconds)
    fuzz::require_sentence(seconds.error());
  else if (*seconds)
    fuzz::require(std::isfinite(**seconds) && **seconds >= 0 && **seconds <= double(size));
  return 0;
}
