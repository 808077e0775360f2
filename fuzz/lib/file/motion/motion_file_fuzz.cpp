// Any bytes as a take or a track of speech: the first line decides which reader they come to.

#include "fuzz/support/motion_laws.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  std::vector<Error> told;
  auto motion = read_motion_text({reinterpret_cast<const char*>(data), size}, "fuzz", &told,
                                 fuzz::kMotionLimits);
  fuzz::require_motion(std::move(motion), told);
  return 0;
}
