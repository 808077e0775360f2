#pragma once
// Moments that come by a renewal law: the gaps between them are drawn from one distribution. Still, a moment is found in any
// order and at once: time is divided into epochs of about a dozen gaps, whose ends are drawn, too, and the gaps of an
// epoch are scaled so that they fill it.

#include <array>
#include <cstddef>
#include <cstdint>

namespace mien {

/// Gaps as multiples of their median: the quantiles of a distribution at 0, 1/8, 2/8 … 1, linear between.
using GapLaw = std::array<double, 9>;

/// Log-normal laws, e^(σ z), cut at 2 and 98 %.
inline constexpr GapLaw kLogNormal045{0.397, 0.596, 0.738, 0.866, 1, 1.154, 1.354, 1.678, 2.516};
inline constexpr GapLaw kLogNormal055{0.324, 0.531, 0.690, 0.839, 1, 1.192, 1.449, 1.882, 3.088};

struct Moment {
  double time = 0;    ///< [s]
  double count = 0;   ///< which one: what else is drawn for it is chance(stream, count)
  double before = 0;  ///< the count of the one before it
};

/// Some moments, newest first.
class Moments {
 public:
  static constexpr std::size_t kMost = 48;

  std::size_t size() const { return size_; }
  const Moment& operator[](std::size_t i) const { return moments_[i]; }
  const Moment* begin() const { return moments_.data(); }
  const Moment* end() const { return moments_.data() + size_; }
  void add(const Moment& moment) {
    if (size_ < kMost) moments_[size_++] = moment;
  }

  double next = 0;  ///< [s] when the one after the newest comes

 private:
  std::array<Moment, kMost> moments_;
  std::size_t size_ = 0;
};

/// The newest moment not after `time`, and all before it that are after `since` (kMost at most).
/// `median` [s] > 0, time and since finite and below 1e9. Every stream has moments of its own.
Moments moments_until(double time, double since, const GapLaw& law, double median,
                      std::uint64_t stream);

}  // namespace mien
