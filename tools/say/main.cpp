// mien-say: text on standard input becomes a WAV on standard output and a track of its sounds. `mien say` runs it.

#include <mien/version.h>
#include "lib/base/one_line.h"
#include "tools/say/spoken_text.h"
#include "tools/say/voices.h"

#include <espeak-ng/speak_lib.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

namespace mien::say {
namespace {

constexpr char kHelp[] =
    "mien-say [--voice VOICE] [--rate N] [--pitch N] [--track FILE] <TEXT >WAV\n"
    "mien-say --voices\n\n"
    "Speaks a text by eSpeak NG. VOICE is a language or a voice of eSpeak's; the rate is in words "
    "a\n"
    "minute, 80 to 450; the pitch 0 to 100. FILE gets a line SECONDS<TAB>SOUND for each sound.\n";

constexpr int kWrong = 2, kFailed = 1;

struct Wishes {
  std::string voice = "en";
  std::optional<int> rate, pitch;
  std::string track;
  bool voices = false;
};

int complain(const Error& error, int code) {
  std::fprintf(stderr, "mien-say: %s\n", one_line(sentence(error)).c_str());
  return code;
}

Expected<int> number_of(const std::string& option, std::string_view text, int least, int most) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed == std::errc() && end == text.data() + text.size() && value >= least && value <= most)
    return value;
  return Error{option + " " + one_line(text, 60),
               fmt::format("expected a whole number from {} to {}", least, most)};
}

Expected<Wishes> read_wishes(int count, char** words) {
  Wishes wishes;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--voices") {
      wishes.voices = true;
      continue;
    }
    const bool known =
        word == "--voice" || word == "--rate" || word == "--pitch" || word == "--track";
    if (!known) return Error{one_line(word, 60), "is no option; mien-say --help lists them"};
    if (++i == count) return Error{word, "needs a value"};
    if (word == "--voice") wishes.voice = words[i];
    if (word == "--track") wishes.track = words[i];
    if (word != "--rate" && word != "--pitch") continue;
    const bool rate = word == "--rate";
    const auto number = rate ? number_of(word, words[i], espeakRATE_MINIMUM, espeakRATE_MAXIMUM)
                             : number_of(word, words[i], 0, 100);
    if (!number) return number.error();
    (rate ? wishes.rate : wishes.pitch) = *number;
  }
  return wishes;
}

std::string whole_input() {
  std::string text;
  char block[1 << 16];
  while (const std::size_t got = std::fread(block, 1, sizeof block, stdin)) text.append(block, got);
  return text;
}

/// Into a file, or to standard output.
bool put(const std::string& bytes, std::FILE* file) {
  const bool all = file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return all && std::fflush(file) == 0;
}

/// Writes the track, where it is wanted, and the sound.
int put_spoken(const SpokenText& spoken, const std::string& track) {
  if (!track.empty()) {
    std::FILE* const file = std::fopen(track.c_str(), "wb");
    const bool written = put(spoken.track(), file);
    if (!file || std::fclose(file) != 0 || !written)
      return complain({one_line(track), "cannot be written"}, kFailed);
  }
  return put(spoken.wave(), stdout) ? 0
                                    : complain({"standard output", "cannot be written"}, kFailed);
}

int run(const Wishes& wishes) {
  constexpr int kOptions =
      espeakINITIALIZE_PHONEME_EVENTS | espeakINITIALIZE_PHONEME_IPA | espeakINITIALIZE_DONT_EXIT;
  const int rate = espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 0, nullptr, kOptions);
  if (rate <= 0)
    return complain({"eSpeak NG", "finds no data: install the package espeak-ng-data"}, kFailed);
  if (wishes.voices)
    return put(list_of_voices(), stdout)
               ? 0
               : complain({"standard output", "cannot be written"}, kFailed);
  if (const auto taken = take_voice(wishes.voice); !taken) return complain(taken.error(), kWrong);
  if (wishes.rate) espeak_SetParameter(espeakRATE, *wishes.rate, 0);
  if (wishes.pitch) espeak_SetParameter(espeakPITCH, *wishes.pitch, 0);
  const auto spoken = speak_text(whole_input(), rate);
  if (!spoken) return complain(spoken.error(), kFailed);
  return put_spoken(*spoken, wishes.track);
}

}  // namespace
}  // namespace mien::say

int main(int count, char** words) {
  using namespace mien::say;
  if (count == 2 && std::string_view(words[1]) == "--help") return std::fputs(kHelp, stdout) < 0;
  if (count == 2 && std::string_view(words[1]) == "--version")
    return std::puts("mien-say " MIEN_VERSION_STRING) < 0;
  const auto wishes = read_wishes(count, words);
  return wishes ? run(*wishes) : complain(wishes.error(), kWrong);
}
