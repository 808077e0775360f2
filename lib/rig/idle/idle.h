#pragma once
// What a face does by itself while nothing is asked of it: a pure function of time and a seed.
//
//   gaze     fixations that last by a log-normal law: half of them on the viewer, the others up to 15° aside. Between
//            them the eyes jump within 50 to 80 ms
//   head     follows the gaze by a third on a damped spring, and sways. The eyes yield by as much as the head turns, so
//            they stay on what they look at
//   blinks   a renewal law; one that comes near a wide glance waits for it or hurries; one in seven comes twice; while the
//            face speaks, none falls into a moment in which lips touch
//   breath   in faster than out, then a rest; the chin goes up a little with it
//   mouth, brows   corners and brows go elsewhere now and then, on springs; brows rise with the gaze
//   pupils   wider and narrower
//
// How often, how far and how fast differs from seed to seed.

#include <mien/motion.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace mien {

/// When no lid is down, in order and apart. Spans of more than half a second hold nothing up.
struct BlinkHolds {
  std::span<const SpokenSpan> spans = {};
  double later = 0;  ///< [s] all of them
};

inline constexpr std::size_t kIdleParts = std::size_t(IdlePart::dilation) + 1;

/// Each part's number. `gaze_x` and `gaze_y`: sines of the eyes' angles in the head; yaw, pitch and roll [degrees];
/// blinks, 0 … 1; breath, 0 … 1; the others within −1 … 1.
using IdleNumbers = std::array<double, kIdleParts>;

/// At `time` [s], any finite number. `liveliness`, 0 … 1 or more: how many of the blinks are blinked, and what all others are
/// multiplied with. A blink that meets `holds` waits; one that would have to wait for longer than 0.6 s is not blinked.
IdleNumbers idle_at(std::uint64_t seed, double time, double liveliness = 1,
                    const BlinkHolds& holds = {});

}  // namespace mien
