#pragma once
// A track of speech as it is read: sounds by their names.

#include <mien/expected.h>
#include <mien/motion.h>
#include <mien/motion_file.h>
#include "lib/rig/speech/phone_visemes.h"
#include "place_private.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mien {

class SpeechBuilder {
 public:
  /// `name` is that of the file, for messages.
  SpeechBuilder(std::string name, const MotionLimits& limits);

  /// In what names are written; if not said, the names decide.
  std::optional<PhoneAlphabet> alphabet;

  /// A sound from `begin` on, until `end` or the next one. Where it begins before the last one, ends before it begins, or
  /// lies out of bounds, the error says so, and `where` is its place.
  Expected<Done> add(double begin, std::optional<double> end, std::string_view name,
                     const Place& where);
  /// The same for what it is known to be.
  Expected<Done> add(double begin, std::optional<double> end, const PhoneMeaning& meaning,
                     const Place& where);
  /// How the voice goes in the last sound: its pitch [Hz] at each of the places that are told, in order.
  void set_pitch(std::span<const double> hertz);

  /// The motion, coarticulated, and what is to be told. An error for a track without sounds.
  Expected<Motion> finish(std::vector<Error>& told);

 private:
  struct Sound {
    double begin, end;  ///< end below begin: until the next one
    std::uint32_t name;
    float first = 0, last = 0, highest = 0;  ///< [Hz] of the voice; 0: not told
  };
  Expected<Done> add_sound(Sound sound, const Place& where);
  std::uint32_t index_of(std::string_view name);
  std::vector<PhoneMeaning> meanings(std::vector<Error>& told) const;
  double usual_pitch() const;

  std::string name_;
  MotionLimits limits_;
  std::vector<Sound> sounds_;
  std::unordered_map<std::string, std::uint32_t> index_;
  std::vector<std::string> names_;
  std::vector<std::optional<PhoneMeaning>> known_;  ///< of a name that was told
};

}  // namespace mien
