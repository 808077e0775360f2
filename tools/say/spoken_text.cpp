#include "tools/say/spoken_text.h"
#include "lib/base/one_line.h"

#include <espeak-ng/speak_lib.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

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

/// The sounds that eSpeak writes down for a text, of which it tells the stress, and no times.
std::vector<std::string> written_sounds(const std::string& text) {
  constexpr int kIpa = 0x02, kBetween = '|' << 8;
  std::vector<std::string> sounds;
  const void* left = text.c_str();
  while (left) {
    const char* const clause = espeak_TextToPhonemes(&left, espeakCHARS_UTF8, kIpa | kBetween);
    if (!clause) break;
    std::string sound;
    for (const char* c = clause;; ++c) {
      const bool ends = *c == '\0' || *c == '|' || *c == ' ' || *c == '\n';
      if (!ends) sound += *c;
      if (ends && !sound.empty()) sounds.push_back(std::exchange(sound, {}));
      if (*c == '\0') break;
    }
  }
  return sounds;
}

constexpr std::string_view kStresses[] = {"ˈ", "ˌ"};

/// The mark of stress that a sound begins with, taken off it.
std::string_view take_stress(std::string_view& sound) {
  for (const std::string_view mark : kStresses)
    if (sound.starts_with(mark)) {
      sound.remove_prefix(mark.size());
      return mark;
    }
  return {};
}

/// Puts marks of stress before sounds that were heard. Both rows are the same but for a sound here and there.
void mark_stresses(const std::vector<std::string>& written, std::vector<SpokenSound>& heard) {
  constexpr std::size_t kApart = 6;
  std::size_t next = 0;
  for (const std::string& one : written) {
    std::string_view name = one;
    const std::string_view stress = take_stress(name);
    std::size_t at = next;
    const std::size_t end = std::min(next + kApart, heard.size());
    while (at < end && heard[at].name != name) ++at;
    if (at == end) continue;
    heard[at].name.insert(0, stress);
    next = at + 1;
  }
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
  mark_stresses(written_sounds(text), spoken.sounds);
  return spoken;
}

}  // namespace mien::say
