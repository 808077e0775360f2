#pragma once
// How much work and memory drawing may take.

#include <mien/api.h>

#include <cstdint>

namespace mien {

/// Limits of what drawing one picture may take; beyond them it ends with an error that names the limit.
/// docs/limits.md lists what draws within the defaults.
struct RenderLimits {
  /// Steps of work: pairs of pieces of outline, crossings, distances, parts of pixels, each weighed by what it
  /// costs. A step is about a nanosecond of one core.
  std::int64_t steps = 100'000'000'000;
  /// [bytes] Held by outlines, their order and their regions, beside the pixels.
  std::uint64_t memory = std::uint64_t(1) << 30;
};

/// None but the machine's.
inline constexpr RenderLimits kWithoutLimits{INT64_MAX, UINT64_MAX};

/// For code that waits inside of watched work, for a pipe or another program: throws if the work is to end.
MIEN_API void end_if_stopped();

}  // namespace mien
