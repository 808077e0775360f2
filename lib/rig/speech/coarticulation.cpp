#include "lib/rig/speech/coarticulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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
constexpr double kJawDominance[kVisemes] = {1,   0.8, 0.6, 0.5, 0.45, 0.35, 1, 1,
                                            0.4, 0.5, 1,   1,   1,    1,    1};

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
    if (gap <= kShortGap) phone.end += gap;
    pulls.push_back({phone.begin, phone.end, int(phone.viseme), phone.strength});
    if (gap > kShortGap) pulls.push_back({phone.end, phone.end + gap, int(Viseme::sil), 1});
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

std::vector<double> moments_of(const std::vector<Pull>& pulls, const SpeechTrack& track) {
  std::vector<double> moments;
  for (const Pull& pull : pulls)
    if (std::isfinite(pull.end)) add_moments(pull.end, moments);
  for (const Phone& phone : track)
    if (is_contact(phone.viseme)) {
      const auto [begin, end] = contact_of(phone);
      for (const double t : {begin - kContactRamp, begin, end, end + kContactRamp})
        moments.push_back(t);
    }
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

/// How far a contact has come, 0 … 1.
double contact_at(const Phone& phone, double time) {
  const auto [begin, end] = contact_of(phone);
  const double away = std::max({begin - time, time - end, 0.0});
  return std::max(1 - away / kContactRamp, 0.0);
}

/// Lets contacts outrank shares. `first` goes along with rising times; contacts last about as long as their sounds, so
/// their ends rise too.
class Contacts {
 public:
  explicit Contacts(const SpeechTrack& track) {
    std::copy_if(track.begin(), track.end(), std::back_inserter(phones_),
                 [](const Phone& phone) { return is_contact(phone.viseme); });
  }

  void outrank(double time, Weights& weights) {
    const double reach = kContactRamp + kLeastContact;
    while (first_ < phones_.size() && phones_[first_].end + reach < time) ++first_;
    for (std::size_t i = first_; i < phones_.size() && phones_[i].begin - reach <= time; ++i) {
      double& weight = weights[std::size_t(phones_[i].viseme)];
      weight = std::max(weight, contact_at(phones_[i], time));
    }
  }

 private:
  std::vector<Phone> phones_;
  std::size_t first_ = 0;
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
  Contacts contacts(track);
  std::size_t lips = 0, jaw = 0;
  for (const double time : table->times) {
    Weights weights{};
    if (!pulls.empty()) {
      add_shares(pulls, lips, time, false, weights);
      add_shares(pulls, jaw, time, true, weights);
      contacts.outrank(time, weights);
    }
    for (const double weight : weights) table->values.push_back(float(std::min(weight, 1.0)));
  }
  Motion motion{.name = std::move(name), .channels = {}, .settled = true};
  const std::shared_ptr<const SampleTable> done = std::move(table);
  for (std::size_t v = 0; v < kVisemes; ++v)
    motion.channels.push_back({"viseme." + std::string(kVisemeNames[v]), {SampledCurve{done, v}}});
  return motion;
}

}  // namespace mien
