#pragma once
// What head and brows do while a face speaks: where a track tells which vowels are stressed, the head nods on some of them and
// the brows go up on some; where it tells that the voice goes up, head and brows go up with it. A pure function of time and
// a seed.
//
// Nods and raised brows come with accents of the voice, a nod's depth is reached in the vowel, and brows begin a little
// before it: H. P. Graf, E. Cosatto, V. Strom, F. J. Huang, Visual Prosody, FGR 2002; M. L. Flecha-García, Speech
// Communication 52 (2010). How often and how far is chosen here, small.

#include "lib/rig/speech/coarticulation.h"

#include <cstdint>
#include <vector>

namespace mien {

inline constexpr double kAccentGap = 0.35;  ///< [s] the least between two accents
inline constexpr double kDeepestNod = 4;    ///< [degrees]
inline constexpr double kHighestBrows = 0.5;

struct Gestures {
  double pitch = 0;  ///< [degrees] of the head, up; within ±kDeepestNod
  double brows = 0;  ///< 0 … kHighestBrows of the way up
};

/// The stressed sounds that get a gesture: of two within kAccentGap the stronger. Short ones count less.
std::vector<SpokenAccent> accents_of(const SpeechTrack& track);

/// At `time` [s], finite. `accents` as accents_of gives them.
Gestures gestures_at(const std::vector<SpokenAccent>& accents, std::uint64_t seed, double time);

}  // namespace mien
