#include "tools/say/voices.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"

#include <espeak-ng/speak_lib.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

namespace mien::say {
namespace {

/// A language that a voice speaks; the lower the number, the better.
struct SpokenLanguage {
  std::string_view language;
  int priority;
  const espeak_VOICE* voice;
};

/// Voices that need no other synthesizer.
std::vector<const espeak_VOICE*> own_voices() {
  std::vector<const espeak_VOICE*> own;
  for (const espeak_VOICE** voice = espeak_ListVoices(nullptr); voice && *voice; ++voice)
    if (!std::string_view((*voice)->identifier).starts_with("mb/")) own.push_back(*voice);
  return own;
}

/// eSpeak writes them as a number in a byte and a text, again and again.
std::vector<SpokenLanguage> languages_of(const espeak_VOICE& voice) {
  std::vector<SpokenLanguage> all;
  for (const char* at = voice.languages; *at;) {
    const std::string_view language(at + 1);
    all.push_back({language, *at, &voice});
    at += 1 + language.size() + 1;
  }
  return all;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return c == '_' ? '-' : char(std::tolower(c)); });
  return lower;
}

const espeak_VOICE* voice_called(const std::string& wanted) {
  const espeak_VOICE* best = nullptr;
  int priority = 1000;
  for (const espeak_VOICE* voice : own_voices()) {
    if (lower_case(voice->name) == wanted || lower_case(voice->identifier) == wanted) return voice;
    for (const SpokenLanguage& spoken : languages_of(*voice))
      if (lower_case(spoken.language) == wanted && spoken.priority < priority)
        best = voice, priority = spoken.priority;
  }
  return best;
}

/// "f3" of the files "!v/f3".
std::vector<std::string_view> variants() {
  espeak_VOICE asked{};
  asked.languages = "variant";
  std::vector<std::string_view> all;
  for (const espeak_VOICE** voice = espeak_ListVoices(&asked); voice && *voice; ++voice) {
    const std::string_view file((*voice)->identifier);
    if (file.starts_with("!v/")) all.push_back(file.substr(3));
  }
  return all;
}

Error no_voice(const std::string& wanted) {
  std::vector<std::string_view> names;
  const auto own = own_voices();
  for (const espeak_VOICE* voice : own)
    for (const SpokenLanguage& spoken : languages_of(*voice)) names.push_back(spoken.language);
  for (const espeak_VOICE* voice : own) names.push_back(voice->name);
  std::string said = unknown_name("voice", one_line(wanted, 60), names);
  // "en-xy" has more of the right letters wrong than names are forgiven for.
  const std::string language = lower_case(wanted).substr(0, wanted.find_first_of("-_"));
  if (said.find("did you mean") == std::string::npos && voice_called(language))
    said += "; did you mean \"" + language + "\"?";
  return {"--voice", said + (said.ends_with('?') ? " " : "; ") + "--voices lists them"};
}

}  // namespace

Expected<Done> take_voice(const std::string& wanted) {
  const std::size_t plus = wanted.find('+');
  const espeak_VOICE* const voice = voice_called(lower_case(wanted.substr(0, plus)));
  if (!voice) return no_voice(wanted.substr(0, plus));
  std::string name = voice->identifier;
  if (plus != std::string::npos) {
    const std::string variant = wanted.substr(plus + 1);
    const auto known = variants();
    if (std::find(known.begin(), known.end(), variant) == known.end())
      return Error{"--voice", unknown_name("variant", one_line(variant, 60), known)};
    name += "+" + variant;
  }
  if (espeak_SetVoiceByName(name.c_str()) != EE_OK)
    return Error{"--voice", "eSpeak NG cannot load " + one_line(wanted, 60)};
  return Done{};
}

std::string list_of_voices() {
  std::string text;
  for (const espeak_VOICE* voice : own_voices())
    text += std::string(languages_of(*voice).front().language) + "\t" + voice->name + "\n";
  return text;
}

}  // namespace mien::say
