#pragma once
// A text as it is heard: samples, and which sound begins when.

#include <mien/expected.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mien::say {

struct SpokenSound {
  double begin;      ///< [s]
  std::string name;  ///< in IPA, with its mark of stress; empty is a pause
};

struct SpokenText {
  int rate = 0;                       ///< [samples a second]
  std::vector<std::int16_t> samples;  ///< of one channel
  std::vector<SpokenSound> sounds;

  /// "SECONDS<TAB>SOUND", a line each; the last one is the end.
  std::string track() const;
  /// As a WAV.
  std::string wave() const;
};

/// Speaks by the voice that has been taken. Marks in the text are letters like others, and control characters are blanks.
/// Errors: it is no UTF-8, has no sound, is longer than a WAV.
Expected<SpokenText> speak_text(std::string text, int rate);

}  // namespace mien::say
