#include "lib/rig/speech/gestures.h"

#include "lib/base/mixed_bits.h"
#include "lib/math/chance.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

/// A move there and back. Times [s] are since the accent.
struct Swing {
  double begin, there, leave, back;

  double at(double since) const {
    return ramp((since - begin) / (there - begin)) - ramp((since - leave) / (back - leave));
  }
  static double ramp(double u) {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * (3 - 2 * u);
  }
};

constexpr Swing kNod{-0.18, 0.02, 0.06, 0.42};
constexpr Swing kBrowSwing{-0.24, -0.04, 0.10, 0.50};
constexpr double kBefore = 0.24, kAfter = 0.5;  ///< [s] the longest of them

/// What one speaker does at an accent.
class Speaker {
 public:
  explicit Speaker(std::uint64_t seed) : stream_(mixed_bits(seed ^ mixed_bits(0x73706F6B656E))) {
    nods_ = draw(0, -1, 0.45, 0.8), lifts_ = draw(1, -1, 0.2, 0.5);
  }

  /// [degrees] at the accent of a count.
  double nod(const SpokenAccent& accent, double count) const {
    const double size = accent.strength * draw(2, count, 0.5, 1);
    if (accent.rising) return 0.5 * kDeepestNod * size;
    return draw(3, count, 0, 1) < nods_ ? -kDeepestNod * size : 0;
  }
  double brows(const SpokenAccent& accent, double count) const {
    const double size = accent.strength * draw(4, count, 0.4, 1);
    return accent.rising || draw(5, count, 0, 1) < lifts_ ? kHighestBrows * size : 0;
  }

 private:
  double draw(std::uint64_t nth, double count, double lo, double hi) const {
    return lo + chance(stream_ + nth, count) * (hi - lo);
  }

  std::uint64_t stream_;
  double nods_ = 0, lifts_ = 0;  ///< shares of the accents
};

}  // namespace

std::vector<SpokenAccent> accents_of(const SpeechTrack& track) {
  constexpr double kMiddle = 0.4;       ///< of a sound: its accent
  constexpr double kFullLength = 0.12;  ///< [s] from which on a sound counts wholly
  constexpr double kLeastCounts = 0.4;  ///< what the shortest counts
  std::vector<SpokenAccent> accents;
  for (const Phone& phone : track) {
    if (!(phone.stress > 0)) continue;
    const double length = phone.end - phone.begin;
    const SpokenAccent accent{
        phone.begin + kMiddle * length,
        std::min(phone.stress, 1.0) * std::clamp(length / kFullLength, kLeastCounts, 1.0),
        phone.rising};
    if (accents.empty() || accent.time >= accents.back().time + kAccentGap)
      accents.push_back(accent);
    else if (accent.time >= accents.back().time && accent.strength > accents.back().strength)
      accents.back() = accent;
  }
  return accents;
}

Gestures gestures_at(const std::vector<SpokenAccent>& accents, std::uint64_t seed, double time) {
  Gestures now;
  const auto first =
      std::lower_bound(accents.begin(), accents.end(), time - kAfter,
                       [](const SpokenAccent& accent, double t) { return accent.time < t; });
  const Speaker speaker(seed);
  for (auto accent = first; accent != accents.end() && accent->time < time + kBefore; ++accent) {
    const auto count = double(accent - accents.begin());
    const double since = time - accent->time;
    now.pitch += kNod.at(since) * speaker.nod(*accent, count);
    now.brows = std::max(now.brows, kBrowSwing.at(since) * speaker.brows(*accent, count));
  }
  now.pitch = std::clamp(now.pitch, -kDeepestNod, kDeepestNod);
  return now;
}

}  // namespace mien
