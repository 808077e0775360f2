#pragma once
// Finds the piece of a piecewise function in constant time, where pieces are of alike lengths.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace mien {

class PieceIndex {
 public:
  /// Equal stretches of the function: the piece in which one begins, and where that and the next three begin.
  struct Bucket {
    double begin[4];
    std::size_t piece;
  };

  /// Pieces begin at these places, which rise, the first at 0; it holds before, too, and the last one without end.
  /// With a period pieces repeat.
  void make(std::vector<double> begins, double period) {
    begins_ = std::move(begins), period_ = period, per_period_ = period > 0.0 ? 1.0 / period : 0.0;
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const double until = period > 0.0 ? period : begins_.back() > 0.0 ? begins_.back() : 1.0;
    const std::size_t count = 2 * begins_.size();
    per_bucket_ = double(count) / until;
    begins_.insert(begins_.end(), 3, kEndless);
    buckets_.clear();
    for (std::size_t b = 0, piece = 0; b <= count; ++b) {
      while (begins_[piece + 1] <= double(b) / per_bucket_) ++piece;
      const double* const at = &begins_[piece];
      buckets_.push_back({{at[0], at[1], at[2], at[3]}, piece});
    }
  }

  /// The piece at s, which is seen from its beginning then.
  std::size_t find(double& s) const {
    if (period_ > 0.0) s -= period_ * whole(s * per_period_);
    if (!(s >= 0.0)) return 0;  // or NaN
    const Bucket& b = buckets_[std::size_t(std::min(s * per_bucket_, most()))];
    std::size_t piece = b.piece + std::size_t(s >= b.begin[1]) + std::size_t(s >= b.begin[2]);
    if (s >= b.begin[3])
      piece = std::size_t(
                  std::upper_bound(begins_.begin() + std::ptrdiff_t(b.piece), begins_.end(), s) -
                  begins_.begin()) -
              1;
    s -= begins_[piece];
    return piece;
  }

  std::size_t size() const { return begins_.size() - 3; }
  double begin(std::size_t piece) const { return begins_[piece]; }
  double period() const { return period_; }
  double per_period() const { return per_period_; }
  const Bucket* buckets() const { return buckets_.data(); }
  double per_bucket() const { return per_bucket_; }
  /// The last bucket.
  double most() const { return double(buckets_.size() - 1); }

 private:
  /// floor(), which is no instruction everywhere; of what has no fraction, anything that leaves a place in the period.
  static double whole(double turns) {
    constexpr double kMost = 4e15;
    if (!(std::abs(turns) < kMost)) return turns;
    const double cut = double((long long)turns);
    return cut - double(cut > turns);
  }

  std::vector<double> begins_;  ///< and three without end
  std::vector<Bucket> buckets_;
  double period_ = 0, per_period_ = 0, per_bucket_ = 1;
};

}  // namespace mien
