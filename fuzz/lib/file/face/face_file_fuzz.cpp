// Any bytes at all are read as a face: refused with one sentence, or a valid face, which then goes
// through the whole house. Never a crash, a hang, or an unbounded allocation.

#include <mien/mien.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/faces/box_letters.h"

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::vector<mien::Error> warnings;
  const mien::FaceLimits limits{.bytes = 1u << 20, .numbers = 10'000, .features = 1'000};
  const auto face =
      mien::read_face_text(text, "fuzz", limits, &warnings, mien::test::box_letters());
  if (!face) {
    require(!face.error().what.empty());
    require(sentence(face.error()).find('\n') == std::string::npos);
    return 0;
  }
  const mien::Face posed = mien::pose_face(*face, {.time = 1.25});
  require(posed.vector.size() == face->vector.size());
  for (double number : posed.vector) require(std::isfinite(number));

  const mien::Scene scene = mien::scene_from_face(posed);
  std::vector<std::uint8_t> pixels(16 * 9 * 4);
  require(bool(mien::render_into({.data = pixels.data(), .stride = 16 * 4}, scene,
                                 {.width = 16, .height = 9}, {.threads = {.count = 1}})));
  return 0;
}
