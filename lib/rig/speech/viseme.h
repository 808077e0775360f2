#pragma once
// The fifteen mouth shapes of speech.

#include <string_view>

namespace mien {

/// In the order of kVisemeNames; consonants first after silence, then vowels.
enum class Viseme : unsigned char { sil, PP, FF, TH, DD, kk, CH, SS, nn, RR, aa, E, I, O, U };

inline constexpr int kVisemes = 15;
inline constexpr std::string_view kVisemeNames[kVisemes] = {
    "sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U"};

constexpr bool is_vowel(Viseme viseme) {
  return viseme >= Viseme::aa;
}

/// Shapes in which the lips meet, or the lower lip the upper teeth.
constexpr bool is_contact(Viseme viseme) {
  return viseme == Viseme::PP || viseme == Viseme::FF;
}

}  // namespace mien
