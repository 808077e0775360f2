// Any bytes as a morphology: refused with one sentence, or made into a face file that reads, poses
// to finite numbers, and reads the same again.

#include <mien/pose.h>
#include "tools/mien/import/facemotion.h"

#include <cmath>
#include <cstdint>

#include "fuzz/support/require.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  const FaceLimits limits{.bytes = 1u << 20, .numbers = 10'000, .features = 1'000};
  const auto text = face_text_from_facemotion({reinterpret_cast<const char*>(data), size}, "fuzz",
                                              {.limits = limits});
  if (!text) {
    fuzz::require_sentence(text.error());
    return 0;
  }
  const auto face = read_face_text(*text, "imported", limits);
  if (!face) {  // larger than the limits, or with names and places that a face file refuses
    fuzz::require_sentence(face.error());
    return 0;
  }
  for (const double number : pose_face(*face, {}).vector) fuzz::require(std::isfinite(number));
  return 0;
}
