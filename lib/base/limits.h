#pragma once
// How much work and memory drawing may take.

#include <mien/api.h>

#include <cstdint>

namespace mien {

/// Limits of what drawing one picture may take; beyond them it ends with an error that names the limit.
/// docs/limits.md lists what draws within the defaults.
struct RenderLimits {
  /// Steps of work: pairs of pieces of outline, crossings, distances, parts of pixels, each weighed by what it
  /// costs. A step is one or two nanoseconds of one core. 0: as many as `default_steps` of the picture's pixels.
  std::int64_t steps = 0;
  /// [bytes] Held by outlines, their order and their regions, beside the pixels.
  std::uint64_t memory = std::uint64_t(1) << 30;
};

/// Steps that a picture of so many pixels may take if nothing else is asked: about eight seconds of one core, and one or
/// two microseconds for a pixel.
constexpr std::int64_t default_steps(std::int64_t pixels) {
  return 8'000'000'000 + 1000 * pixels;
}

/// None but the machine's.
inline constexpr RenderLimits kWithoutLimits{INT64_MAX, UINT64_MAX};

/// For code that waits inside of watched work, for a pipe or another program: throws if the work is to end.
MIEN_API void end_if_stopped();

}  // namespace mien
