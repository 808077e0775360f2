// Any bytes as a take or a track of speech: the first line decides which reader they come to.

#include <mien/bound_motion.h>
#include <mien/motion_file.h>
#include <mien/motion_length.h>
#include <mien/poser.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "fuzz/support/require.h"
#include "fuzz/support/small_face.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mien;
  std::vector<Error> told;
  auto motion = read_motion_text({reinterpret_cast<const char*>(data), size}, "fuzz", &told,
                                 {.rows = 100'000, .numbers = 1'000'000, .bytes = 1 << 20});
  for (const Error& one : told) fuzz::require_sentence(one);
  if (!motion) {
    fuzz::require_sentence(motion.error());
    return 0;
  }
  const double length = motion_length(*motion);
  fuzz::require(std::isfinite(length) && length >= 0);
  for (const MotionChannel& channel : motion->channels) {
    const auto& table = *std::get<SampledCurve>(channel.curves[0]).table;
    fuzz::require(!table.times.empty());
    fuzz::require(table.values.size() == table.times.size() * table.columns);
    for (std::size_t row = 1; row < table.times.size(); ++row)
      fuzz::require(table.times[row] >= table.times[row - 1]);
    for (const float value : table.values) fuzz::require(std::abs(value) <= 180);
  }
  const BoundMotion bound = bind_motion(*std::move(motion), fuzz::small_face());
  Poser poser(fuzz::small_face());
  for (const double t : {-1.0, length / 2, length + 1})
    for (const double number :
         poser.pose({.time = t, .motions = {{.motion = bound.motion}}}).vector)
      fuzz::require(std::isfinite(number));
  return 0;
}
