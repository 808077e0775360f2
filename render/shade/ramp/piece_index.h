#pragma once
// Finds the piece of a piecewise function in constant time, where pieces are of alike lengths.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace mien {

class PieceIndex {
 public:
  /// Pieces begin at these places, which rise, the first at 0; it holds before, too, and the last one without end.
  /// With a period pieces repeat.
  void make(std::vector<double> begins, double period) {
    begins_ = std::move(begins), period_ = period, per_period_ = period > 0.0 ? 1.0 / period : 0.0;
    const double until = period > 0.0 ? period : begins_.back() > 0.0 ? begins_.back() : 1.0;
    const std::size_t count = 2 * begins_.size();
    per_bucket_ = double(count) / until;
    begins_.insert(begins_.end(), 3, std::numeric_limits<double>::infinity());
    buckets_.clear();
    for (std::size_t b = 0, piece = 0; b <= count; ++b) {
      while (begins_[piece + 1] <= double(b) / per_bucket_) ++piece;
      buckets_.push_back(piece);
    }
  }

  /// The piece at s, which is seen from its beginning then.
  std::size_t find(double& s) const {
    if (period_ > 0.0) s -= period_ * whole(s * per_period_);
    if (!(s >= 0.0)) return 0;  // or NaN
    std::size_t piece =
        buckets_[std::size_t(std::min(s * per_bucket_, double(buckets_.size() - 1)))];
    for (int i = 0; i < 2; ++i) piece += std::size_t(s >= begins_[piece + 1]);
    if (s >= begins_[piece + 1])
      piece =
          std::size_t(std::upper_bound(begins_.begin(), begins_.end(), s) - begins_.begin()) - 1;
    s -= begins_[piece];
    return piece;
  }

  std::size_t size() const { return begins_.size() - 3; }
  double begin(std::size_t piece) const { return begins_[piece]; }
  double period() const { return period_; }

 private:
  /// floor(), which is no instruction everywhere; of what has no fraction, anything that leaves a place in the period.
  static double whole(double turns) {
    constexpr double kMost = 4e15;
    if (!(std::abs(turns) < kMost)) return turns;
    const double cut = double((long long)turns);
    return cut - double(cut > turns);
  }

  std::vector<double> begins_;        ///< and three without end
  std::vector<std::size_t> buckets_;  ///< equal stretches: the piece in which one begins
  double period_ = 0, per_period_ = 0, per_bucket_ = 1;
};

}  // namespace mien
