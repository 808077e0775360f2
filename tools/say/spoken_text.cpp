#include "tools/say/spoken_text.h"
#include "lib/base/one_line.h"

#include <espeak-ng/speak_lib.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace mien::say {
namespace {

constexpr std::size_t kMostSamples = std::size_t(1)
                                     << 30;  // twelve hours; a WAV holds twice as many bytes

/// Its numbers are little-endian.
void add_little(std::string& to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to += char(value >> 8 * i & 0xff);
}

/// eSpeak gives names of up to 8 bytes, without an end where they are full. A letter may be cut off there.
std::string sound_name(const char (&bytes)[8]) {
  std::string name(bytes, std::find(std::begin(bytes), std::end(bytes), '\0'));
  while (!name.empty() && !is_utf8(name)) name.pop_back();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c <= ' '; }, '_');
  // "_:" and "_" are pauses; marks of length and tone alone are no sounds of their own.
  return name.starts_with('_') ? std::string() : name;
}

/// Called by eSpeak with each piece; any other number than 0 ends it.
int hear(short* samples, int count, espeak_EVENT* events) {
  auto* const to = static_cast<SpokenText*>(events->user_data);
  for (; events->type != espeakEVENT_LIST_TERMINATED; ++events) {
    if (events->type != espeakEVENT_PHONEME) continue;
    const SpokenSound sound{events->audio_position / 1000.0, sound_name(events->id.string)};
    to->sounds.push_back(sound);
  }
  if (samples && count > 0) to->samples.insert(to->samples.end(), samples, samples + count);
  return to->samples.size() > kMostSamples;
}

}  // namespace

std::string SpokenText::track() const {
  std::string text;
  for (const SpokenSound& sound : sounds)
    text += fmt::format("{:.3f}\t{}\n", sound.begin, sound.name);
  return text + fmt::format("{:.3f}\t\n", double(samples.size()) / rate);
}

std::string SpokenText::wave() const {
  const auto size = std::uint32_t(2 * samples.size());
  std::string file = "RIFF";
  add_little(file, 36 + size, 4);
  file += "WAVEfmt ";
  add_little(file, 16, 4), add_little(file, 1, 2), add_little(file, 1, 2);
  add_little(file, std::uint32_t(rate), 4), add_little(file, 2 * std::uint32_t(rate), 4);
  add_little(file, 2, 2), add_little(file, 16, 2);
  file += "data";
  add_little(file, size, 4);
  for (const std::int16_t sample : samples) add_little(file, std::uint16_t(sample), 2);
  return file;
}

Expected<SpokenText> speak_text(std::string text, int rate) {
  if (!is_utf8(text)) return Error{"text", "is not UTF-8"};
  // Among them is the one with which a text would change the voice.
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\n') || c == 0x7f; },
      ' ');
  SpokenText spoken;
  spoken.rate = rate;
  espeak_SetSynthCallback(hear);
  const auto said = espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0,
                                 espeakCHARS_UTF8, nullptr, &spoken);
  if (said != EE_OK || espeak_Synchronize() != EE_OK)
    return Error{"text", "eSpeak NG cannot speak it"};
  if (spoken.samples.size() > kMostSamples) return Error{"text", "is longer than a WAV can hold"};
  if (std::all_of(spoken.sounds.begin(), spoken.sounds.end(),
                  [](const SpokenSound& sound) { return sound.name.empty(); }))
    return Error{"text", "has nothing in it that is spoken"};
  return spoken;
}

}  // namespace mien::say
