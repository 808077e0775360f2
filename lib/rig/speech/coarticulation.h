#pragma once
// From sounds to a mouth: how the shapes of neighbouring sounds run into each other.
//
// Every sound pulls the mouth towards its own shape with a *dominance* that is full while it lasts and falls off with the
// time δ to it: D(δ) = α (1 + δ/(16 θ))^−16, close to α e^(−δ/θ). A shape's weight is the share that its sounds have of the
// sum of all dominances. Two things follow, whatever the track:
//
//   * shares lie between 0 and 1, and their sum is 1;
//   * |D'/D| ≤ 1/θ, so a weighted share w = Σ aᵢ Dᵢ / Σ Dⱼ with 0 ≤ aᵢ ≤ 1 changes by |w'| = |cov(a, D'/D)| ≤ 1/(2θ). That
//     is the speed limit, and nothing needs to be filtered.
//
// Lips and jaw have different times. Consonants are made by lips and tongue, with θ = kLipsTime. Vowels carry the jaw; their
// shares are taken with θ = kJawTime among all sounds, so the jaw goes on from vowel to vowel while the lips close, and
// sounds that close give way (a small α). Closing outranks the limit: while p, b, m last the lips meet, and while f, v last
// the lower lip is at the teeth, for at least kLeastContact; the way there takes kContactRamp.
//
// Sources: M. Cohen and D. Massaro, "Modeling coarticulation in synthetic visual speech", 1993: dominance, with exponentials;
// S. Öhman, "Numerical model of coarticulation", 1967: vowels that run on under consonants. The limit is derived here.

#include <mien/motion.h>
#include "lib/rig/speech/viseme.h"

#include <string>
#include <utility>
#include <vector>

namespace mien {

/// A sound as it is heard.
struct Phone {
  double begin, end;  ///< [s] end >= begin
  Viseme viseme;
  double strength = 1;  ///< 0 … 1: below 1 it is unstressed, or opens less
  double stress = 0;    ///< 0 … 1: of a vowel that the speaker stresses
  bool rising = false;  ///< the voice goes up on it
};

/// Phones may overlap, and leave gaps, in which nothing is said.
using SpeechTrack = std::vector<Phone>;

inline constexpr double kLipsTime = 0.024, kJawTime = 0.060;  ///< [s] θ
inline constexpr double kLipsSpeed =
    1 / (2 * kLipsTime);  ///< [1/s] the most that a consonant's weight changes
inline constexpr double kJawSpeed = 1 / (2 * kJawTime);  ///< [1/s] the same of a vowel's
inline constexpr double kContactRamp = 0.040;            ///< [s] from no contact to full contact
inline constexpr double kLeastContact = 0.080;           ///< [s] that a contact lasts

/// When the lips (or lip and teeth) of such a sound touch: within it, or where it is shorter than kLeastContact so long about
/// its middle.
std::pair<double, double> contact_of(const Phone& phone);

/// Moments and weights of the fifteen shapes, as channels "viseme.PP" …: linear between moments at most 20 ms apart where
/// anything changes. Before and after the track all are 0: the face rests. In gaps within it the lips close. With the contacts
/// and accents of the track.
Motion coarticulated(SpeechTrack track, std::string name);

}  // namespace mien
