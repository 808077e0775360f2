#pragma once
// Where to find the pieces of a piecewise function in constant time, where pieces are of alike lengths.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace mien {

/// A place s lies, less whole periods, in the bucket s · per_bucket, or the nearest one. Its piece is the one in which
/// that begins or one of the next two; if some buckets are crowded, it may be a later one.
struct PieceIndex {
  std::vector<double> begins;          ///< of pieces, rising, the first at 0; and one without end
  std::vector<std::uint32_t> buckets;  ///< equal stretches: the piece in which one begins
  double period = 0, per_period = 0;   ///< 0: it does not repeat, and ends hold without end
  double per_bucket = 1;
  bool crowded = false;
  /// Of pieces that begin at `begins`.
  void make(double repeats) {
    period = repeats, per_period = period > 0.0 ? 1.0 / period : 0.0;
    const double until = period > 0.0 ? period : begins.back() > 0.0 ? begins.back() : 1.0;
    const std::size_t count = 2 * begins.size();
    per_bucket = double(count) / until;
    begins.push_back(std::numeric_limits<double>::infinity());
    buckets.clear(), crowded = false;
    std::uint32_t piece = 0;
    for (std::size_t b = 0; b <= count; ++b) {
      while (b > 0 && begins[piece + 1] <= double(b) / per_bucket)
        ++piece;  // first what is before 0
      crowded = crowded || (b > 0 && piece - buckets.back() > 2);
      buckets.push_back(piece);
    }
  }
};

}  // namespace mien
