#pragma once
// Which mouth shape a sound has, in the alphabets that tracks are written in.

#include "lib/rig/speech/viseme.h"

#include <optional>
#include <span>
#include <string_view>

namespace mien {

enum class PhoneAlphabet : unsigned char {
  visemes,  ///< the fifteen shapes by their names, "PP", "ih"
  rhubarb,  ///< mouths "A" to "H" and "X"
  arpabet,  ///< "AH0", "HH": dictionaries of English
  ipa,      ///< "tʃ", "əʊ"
  sampa     ///< the same in ASCII, "tS", "@U"
};

/// A part of a sound; diphthongs have two.
struct PhoneShape {
  Viseme viseme;
  double strength = 1;
};

struct PhoneMeaning {
  PhoneShape shapes[2];
  int count = 1;
  bool known = true;  ///< else this is the nearest that there is
  double stress =
      0;  ///< 0 … 1, as the name tells: 0.5 is a secondary one. Of IPA also with consonants, before their vowel
};

/// The alphabet in which all of the names are written.
PhoneAlphabet alphabet_of(std::span<const std::string_view> names);

/// The shapes of a sound. Silence, and what stands for it ("", "sp", "SIL", "_"), is sil. A sound that the alphabet does not
/// have is the viseme of that name, or the sound of ARPABET, or like the sound that its first letters mean, or else like
/// "kk", of which little is seen.
PhoneMeaning phone_meaning(PhoneAlphabet alphabet, std::string_view name);

/// The shape of one of the 22 ids of Azure's viseme events.
std::optional<PhoneMeaning> azure_viseme(double id);

}  // namespace mien
