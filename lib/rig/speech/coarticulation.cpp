#include "lib/rig/speech/coarticulation.h"
#include "lib/rig/speech/gestures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <vector>

namespace mien {
namespace {

constexpr double kStep = 0.020;     ///< [s] between moments
constexpr double kReach = 12;       ///< times θ: beyond, a dominance is below 2e-4
constexpr double kShortGap = 0.03;  ///< [s] between sounds that hang together

/// Dominances α: how much a shape insists, among lips and in the jaw. Order of Viseme.
constexpr double kLipsDominance[kVisemes] = {0.5, 1.2, 1.2, 0.9, 0.7, 0.35, 1.1, 1,
                                             0.7, 0.9, 1,   1,   1,   1,    1};
constexpr double kJawDominance[kVisemes] = {0.6, 0.6, 0.5, 0.5, 0.4, 0.3, 0.8, 0.8,
                                            0.4, 0.5, 1,   1,   1,   1,   1};

using Weights = std::array<double, kVisemes>;

/// A sound, or the rest before and after all.
struct Pull {
  double begin, end;
  int viseme;  ///< −1: the rest
  double strength;
};

/// Falls from 1 like e^−x, by products alone: the same bits on every machine.
double fall(double x) {
  double base = 1 / (1 + x / 16);
  for (int i = 0; i < 4; ++i) base *= base;
  return base;
}

double distance(const Pull& pull, double time) {
  return std::max({pull.begin - time, time - pull.end, 0.0});
}

/// Sounds end where the next begins; gaps between them are silence; the rest stands around all.
std::vector<Pull> pulls_of(SpeechTrack& track) {
  std::stable_sort(track.begin(), track.end(),
                   [](const Phone& a, const Phone& b) { return a.begin < b.begin; });
  std::vector<Pull> pulls;
  constexpr double kEver = std::numeric_limits<double>::infinity();
  if (track.empty()) return pulls;
  pulls.push_back({-kEver, track.front().begin, -1, 0});
  for (std::size_t i = 0; i < track.size(); ++i) {
    const bool last = i + 1 == track.size();
    Phone& phone = track[i];
    if (!last) phone.end = std::min(phone.end, track[i + 1].begin);
    const double gap = last ? 0 : track[i + 1].begin - phone.end;
    const double end = gap <= kShortGap ? phone.end + gap : phone.end;
    pulls.push_back({phone.begin, end, int(phone.viseme), phone.strength});
    if (gap > kShortGap) pulls.push_back({end, end + gap, int(Viseme::sil), 1});
  }
  pulls.push_back({pulls.back().end, kEver, -1, 0});
  return pulls;
}

/// Moments at which weights are taken: all multiples of the step that are near a border between sounds.
void add_moments(double border, std::vector<double>& moments) {
  const double reach = kReach * kJawTime;
  const double first = std::ceil((border - reach) / kStep), last = (border + reach) / kStep;
  for (double n = first; n <= last; ++n)
    if (moments.empty() || n * kStep > moments.back()) moments.push_back(n * kStep);
}

using Span = std::pair<double, double>;

/// When one of some shapes is in contact: spans that do not touch each other, in order.
std::vector<Span> contacts_of(const SpeechTrack& track, std::initializer_list<Viseme> shapes) {
  std::vector<Span> spans;
  for (const Phone& phone : track)
    if (std::find(shapes.begin(), shapes.end(), phone.viseme) != shapes.end())
      spans.push_back(contact_of(phone));
  std::sort(spans.begin(), spans.end());
  std::vector<Span> joined;
  for (const Span& span : spans)
    if (!joined.empty() && span.first <= joined.back().second)
      joined.back().second = std::max(joined.back().second, span.second);
    else
      joined.push_back(span);
  return joined;
}

std::vector<double> moments_of(const std::vector<Pull>& pulls, const SpeechTrack& track) {
  std::vector<double> moments;
  for (const Pull& pull : pulls)
    if (std::isfinite(pull.end)) add_moments(pull.end, moments);
  for (const Viseme viseme : {Viseme::PP, Viseme::FF})
    for (const auto& [begin, end] : contacts_of(track, {viseme}))
      for (const double t : {begin - kContactRamp, begin, end, end + kContactRamp})
        moments.push_back(t);
  std::sort(moments.begin(), moments.end());
  moments.erase(std::unique(moments.begin(), moments.end()), moments.end());
  return moments;
}

/// Adds the shares of one layer to the weights of its shapes. Pulls are in order and do not overlap; `first` goes along with
/// rising times.
void add_shares(const std::vector<Pull>& pulls, std::size_t& first, double time, bool jaw,
                Weights& weights) {
  const double theta = jaw ? kJawTime : kLipsTime, reach = kReach * theta;
  while (pulls[first].end < time - reach) ++first;
  Weights shares{};
  double sum = 0;
  for (std::size_t i = first; i < pulls.size() && pulls[i].begin <= time + reach; ++i) {
    const Pull& pull = pulls[i];
    const auto v = std::size_t(std::max(pull.viseme, 0));
    const double dominance =
        (jaw ? kJawDominance : kLipsDominance)[v] * fall(distance(pull, time) / theta);
    sum += dominance;
    const bool carries = is_vowel(Viseme(v)) || Viseme(v) == Viseme::sil;
    if (pull.viseme >= 0 && carries == jaw) shares[v] += pull.strength * dominance;
  }
  for (std::size_t v = 0; v < kVisemes; ++v) weights[v] += shares[v] / sum;
}

/// Lets the contacts of one shape outrank its shares, at rising times.
class Contacts {
 public:
  Contacts(const SpeechTrack& track, Viseme viseme)
      : spans_(contacts_of(track, {viseme})), viseme_(std::size_t(viseme)) {}

  void outrank(double time, Weights& weights) {
    while (next_ < spans_.size() && spans_[next_].second < time) ++next_;
    for (std::size_t i = next_ > 0 ? next_ - 1 : 0; i < std::min(next_ + 1, spans_.size()); ++i) {
      const double away = std::max({spans_[i].first - time, time - spans_[i].second, 0.0});
      weights[viseme_] = std::max(weights[viseme_], 1 - away / kContactRamp);
    }
  }

 private:
  std::vector<Span> spans_;
  std::size_t viseme_, next_ = 0;
};

}  // namespace

std::pair<double, double> contact_of(const Phone& phone) {
  constexpr double kMargin = 0.15;  ///< of the sound, on either side
  const double length = phone.end - phone.begin;
  if (length < kLeastContact) {
    const double middle = phone.begin + length / 2;
    return {middle - kLeastContact / 2, middle + kLeastContact / 2};
  }
  const double margin = std::min(kMargin * length, (length - kLeastContact) / 2);
  return {phone.begin + margin, phone.end - margin};
}

Motion coarticulated(SpeechTrack track, std::string name) {
  const std::vector<Pull> pulls = pulls_of(track);
  auto table = std::make_shared<SampleTable>();
  table->columns = kVisemes;
  table->times = moments_of(pulls, track);
  if (table->times.empty()) table->times.push_back(0);
  table->values.reserve(table->times.size() * kVisemes);
  Contacts lips_meet(track, Viseme::PP), lip_and_teeth(track, Viseme::FF);
  std::size_t lips = 0, jaw = 0;
  for (const double time : table->times) {
    Weights weights{};
    if (!pulls.empty()) {
      add_shares(pulls, lips, time, false, weights);
      add_shares(pulls, jaw, time, true, weights);
      lips_meet.outrank(time, weights);
      lip_and_teeth.outrank(time, weights);
    }
    for (const double weight : weights) table->values.push_back(float(std::min(weight, 1.0)));
  }
  Motion motion{.name = std::move(name), .channels = {}, .settled = true};
  for (const auto& [begin, end] : contacts_of(track, {Viseme::PP, Viseme::FF}))
    motion.spoken.contacts.push_back({begin, end});
  motion.spoken.accents = accents_of(track);
  const std::shared_ptr<const SampleTable> done = std::move(table);
  for (std::size_t v = 0; v < kVisemes; ++v)
    motion.channels.push_back({"viseme." + std::string(kVisemeNames[v]), {SampledCurve{done, v}}});
  return motion;
}

}  // namespace mien
