#include "lib/rig/idle/renewal.h"

#include "lib/math/chance.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr double kGaps = 12;    ///< of an epoch, on average
constexpr double kLoose = 0.4;  ///< the share of an epoch by which its beginning is drawn
constexpr double kCounts =
    64;  ///< numbers for the moments of an epoch; the last one is its last moment's
constexpr std::size_t kMostGaps = 24;

double gap_at(const GapLaw& law, double share) {
  const double at = share * double(law.size() - 1);
  const auto i = std::min(std::size_t(at), law.size() - 2);
  return law[i] + (at - double(i)) * (law[i + 1] - law[i]);
}

double mean_of(const GapLaw& law) {
  double sum = -0.5 * (law.front() + law.back());
  for (const double quantile : law) sum += quantile;
  return sum / double(law.size() - 1);
}

/// The moments of one stream.
class Epochs {
 public:
  Epochs(const GapLaw& law, double median, std::uint64_t stream)
      : law_(law), length_(kGaps * median * mean_of(law)), stream_(stream) {}

  double at(double time) const {
    const double epoch = std::floor(time / length_);
    return begin_of(epoch) <= time ? epoch : epoch - 1;
  }
  double begin_of(double epoch) const {
    return (epoch + kLoose * chance(stream_, epoch)) * length_;
  }

  /// Adds those of an epoch that are not after `time`.
  void add(double epoch, double time, Moments& to) const {
    const double begin = begin_of(epoch), length = begin_of(epoch + 1) - begin;
    const auto gaps =
        std::clamp(std::size_t(length / length_ * kGaps + 0.5), std::size_t{1}, kMostGaps);
    std::array<double, kMostGaps + 1> after;
    after[0] = 0;
    for (std::size_t i = 0; i < gaps; ++i)
      after[i + 1] = after[i] + gap_at(law_, chance(~stream_, epoch * kCounts + double(i)));
    const double scale = length / after[gaps];
    std::size_t past = gaps;
    while (past > 1 && begin + scale * after[past - 1] > time) --past;
    if (to.size() == 0) to.next = begin + scale * after[past];
    const auto count_of = [&](std::size_t i) {
      return epoch * kCounts + (i + 1 == gaps ? kCounts - 1 : double(i));
    };
    for (std::size_t i = past; i-- > 0;)
      to.add(
          {begin + scale * after[i], count_of(i), i > 0 ? count_of(i - 1) : epoch * kCounts - 1});
  }

 private:
  const GapLaw& law_;
  double length_;  ///< [s] of epochs, on average
  std::uint64_t stream_;
};

}  // namespace

Moments moments_until(double time, double since, const GapLaw& law, double median,
                      std::uint64_t stream) {
  const Epochs epochs(law, median, stream);
  Moments all, found;
  double epoch = epochs.at(time);
  epochs.add(epoch, time, all);
  while (all.size() < Moments::kMost && all[all.size() - 1].time > since)
    epochs.add(--epoch, time, all);
  found.next = all.next;
  for (const Moment& moment : all)
    if (found.size() == 0 || moment.time > since) found.add(moment);
  return found;
}

}  // namespace mien
