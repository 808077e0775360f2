#include "speech_builder_private.h"

#include "lib/base/one_line.h"
#include "lib/rig/speech/coarticulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

constexpr double kMostSpeech = 1e6;  ///< [s] a film of twelve days
constexpr double kLastSound = 0.12;  ///< [s] that a last sound lasts of which no end is known
constexpr double kFirstPart = 0.55;  ///< of a diphthong

constexpr double kRise = 1.122;  ///< of a voice that goes up within a sound: 2 semitones
constexpr double kHigh = 1.155;  ///< above its usual pitch: 2.5 semitones

/// What the speaker does with a sound.
struct Emphasis {
  double stress = 0;
  bool rising = false;
};

void add_phones(double begin, double end, const PhoneMeaning& meaning, const Emphasis& emphasis,
                SpeechTrack& track) {
  const double middle = meaning.count == 2 ? begin + kFirstPart * (end - begin) : end;
  track.push_back({begin, middle, meaning.shapes[0].viseme, meaning.shapes[0].strength,
                   emphasis.stress, emphasis.rising});
  if (meaning.count == 2)
    track.push_back({middle, end, meaning.shapes[1].viseme, meaning.shapes[1].strength});
}

/// A mark of stress stands before its syllable: it is the next vowel's.
class Stresses {
 public:
  Emphasis of(const PhoneMeaning& meaning) {
    if (meaning.shapes[0].viseme == Viseme::sil) pending_ = 0;
    pending_ = std::max(pending_, meaning.stress);
    if (!is_vowel(meaning.shapes[0].viseme)) return {};
    return {std::exchange(pending_, 0), false};
  }

 private:
  double pending_ = 0;
};

}  // namespace

SpeechBuilder::SpeechBuilder(std::string name, const MotionLimits& limits)
    : name_(std::move(name)), limits_(limits) {}

std::uint32_t SpeechBuilder::index_of(std::string_view name) {
  const auto [found, fresh] = index_.try_emplace(std::string(name), std::uint32_t(names_.size()));
  if (fresh) names_.emplace_back(name), known_.emplace_back();
  return found->second;
}

Expected<Done> SpeechBuilder::add(double begin, std::optional<double> end, std::string_view name,
                                  const Place& where) {
  return add_sound({begin, end.value_or(-kMostSpeech * 2), index_of(name)}, where);
}

Expected<Done> SpeechBuilder::add(double begin, std::optional<double> end,
                                  const PhoneMeaning& meaning, const Place& where) {
  const std::string name = fmt::format("\x01{} {}", int(meaning.shapes[0].viseme),
                                       meaning.count == 2 ? int(meaning.shapes[1].viseme) : -1);
  const std::uint32_t index = index_of(name);
  known_[index] = meaning;
  return add_sound({begin, end.value_or(-kMostSpeech * 2), index}, where);
}

Expected<Done> SpeechBuilder::add_sound(Sound sound, const Place& where) {
  const bool open = sound.end == -kMostSpeech * 2;
  const auto out = [](double time) { return !(std::abs(time) <= kMostSpeech); };
  if (out(sound.begin) || (!open && out(sound.end)))
    return Error{where(), fmt::format("{} is no moment of speech",
                                      out(sound.begin) ? sound.begin : sound.end)};
  if (!open && sound.end < sound.begin)
    return Error{where(),
                 fmt::format("ends at {}, before it begins at {}", sound.end, sound.begin)};
  if (!sounds_.empty() && sound.begin < sounds_.back().begin)
    return Error{where(),
                 fmt::format("time goes back, from {} to {}", sounds_.back().begin, sound.begin)};
  if (sounds_.size() >= limits_.rows)
    return Error{where(), fmt::format("more than {} sounds (limit: rows)", limits_.rows)};
  sounds_.push_back(sound);
  return Done{};
}

std::vector<PhoneMeaning> SpeechBuilder::meanings(std::vector<Error>& told) const {
  std::vector<std::string_view> written;
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (!known_[i]) written.push_back(names_[i]);
  const PhoneAlphabet in = alphabet.value_or(alphabet_of(written));
  std::vector<PhoneMeaning> found;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    found.push_back(known_[i] ? *known_[i] : phone_meaning(in, names_[i]));
    constexpr std::size_t kMostTold = 5;
    if (!found.back().known && told.size() < kMostTold)
      told.push_back(
          {name_, fmt::format("no sound is called {}: it is shown as {}", in_quotes(names_[i]),
                              kVisemeNames[int(found.back().shapes[0].viseme)])});
  }
  return found;
}

void SpeechBuilder::set_pitch(std::span<const double> hertz) {
  if (sounds_.empty() || hertz.empty()) return;
  Sound& sound = sounds_.back();
  sound.first = float(hertz.front()), sound.last = float(hertz.back());
  sound.highest = float(*std::max_element(hertz.begin(), hertz.end()));
}

/// The median of what is told; 0: nothing is.
double SpeechBuilder::usual_pitch() const {
  std::vector<float> all;
  for (const Sound& sound : sounds_)
    if (sound.highest > 0) all.push_back(sound.highest);
  if (all.empty()) return 0;
  const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return double(*middle);
}

Expected<Motion> SpeechBuilder::finish(std::vector<Error>& told) {
  if (sounds_.empty()) return Error{name_, "holds no sounds"};
  const std::vector<PhoneMeaning> meaning = meanings(told);
  const double usual = usual_pitch();
  Stresses stresses;
  SpeechTrack track;
  track.reserve(sounds_.size());
  for (std::size_t i = 0; i < sounds_.size(); ++i) {
    const Sound& sound = sounds_[i];
    const bool last = i + 1 == sounds_.size();
    const double next = last ? sound.begin + kLastSound : sounds_[i + 1].begin;
    const bool open = sound.end < sound.begin;
    const double end = open ? next : last ? sound.end : std::min(sound.end, next);
    // A silence at the end is the face's own.
    if (last && open && meaning[sound.name].shapes[0].viseme == Viseme::sil) break;
    const PhoneMeaning& of = meaning[sound.name];
    Emphasis emphasis = stresses.of(of);
    if (usual > 0 && is_vowel(of.shapes[0].viseme) && sound.first > 0) {
      emphasis.rising = sound.last >= kRise * double(sound.first);
      if (emphasis.rising || sound.highest >= kHigh * usual) emphasis.stress = 1;
    }
    add_phones(sound.begin, end, of, emphasis, track);
  }
  return coarticulated(std::move(track), name_);
}

}  // namespace mien
