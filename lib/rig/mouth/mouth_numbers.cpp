#include "lib/rig/mouth/mouth_numbers.h"

#include <algorithm>

namespace mien {
namespace {

/// 0 of a silent mouth, 1 of one that speaks.
double speech_of(const Mouth& mouth, std::span<const double> values) {
  double sum = 0;
  for (const Index<Channel> c : mouth.speech) sum += values[std::size_t(c.at)];
  return std::clamp(sum, 0.0, 1.0);
}

}  // namespace

MouthNumbers mouth_numbers(const Mouth& mouth, std::span<const double> values, double pulled) {
  constexpr double kJawOfTongue = 0.35;  // a tongue that is out needs as much room
  constexpr double kSpoken = 0.8;        // of what muscles open, speech takes away
  const auto half = [&](MouthAct act, std::size_t side) {
    const Index<Channel> c = mouth.channels[std::size_t(act)][side];
    return values[std::size_t(c.at)];
  };
  const auto one = [&](MouthAct act) { return half(act, 0); };
  const auto both = [&](MouthAct act) { return std::array{half(act, 0), half(act, 1)}; };
  MouthNumbers n;
  n.tongue_out = one(MouthAct::tongue_out);
  n.jaw = one(MouthAct::jaw_open);
  pulled *= 1 - kSpoken * speech_of(mouth, values);
  if (pulled > 0) n.jaw = 1 - (1 - n.jaw) * (1 - std::min(pulled, 1.0));
  n.jaw = std::max(n.jaw, kJawOfTongue * n.tongue_out);
  n.close = std::min(one(MouthAct::close), 1 - n.tongue_out);
  n.aside = one(MouthAct::jaw_aside), n.forward = one(MouthAct::jaw_forward);
  n.part = one(MouthAct::part), n.pucker = one(MouthAct::pucker);
  n.funnel = one(MouthAct::funnel), n.shift = one(MouthAct::aside);
  n.puff = one(MouthAct::puff), n.bite = one(MouthAct::bite);
  n.stretch = both(MouthAct::stretch), n.press = both(MouthAct::press);
  n.dimple = both(MouthAct::dimple);
  n.roll = {one(MouthAct::roll_upper), one(MouthAct::roll_lower)};
  n.shrug = {one(MouthAct::shrug_upper), one(MouthAct::shrug_lower)};
  n.tongue_up = one(MouthAct::tongue_up), n.tongue_between = one(MouthAct::tongue_between);
  n.tongue_wide = one(MouthAct::tongue_wide), n.tongue_back = one(MouthAct::tongue_back);
  return n;
}

}  // namespace mien
