#pragma once
// f as a Bézier curve of its own, halved until its control points change sign once and lie as good as on a line, which is
// cut with the axis.
//
// Source. P. J. Schneider, "Solving the Nearest-Point-on-Curve Problem" and "A Bézier Curve-Based Root-Finder",
// Graphics Gems, 1990, 607–611 and 408–415. Written from the description.

#include "tools/accuracy/methods/foot.h"

#include <array>
#include <limits>

namespace mien::accuracy {

template <class T>
class Subdivision {
 public:
  explicit Subdivision(const FootEquation<T>& foot)
      : foot_(foot), best_(std::min(foot.square(0), foot.square(1))) {
    const T d = foot.c0, c = foot.c1 / 3, b = foot.c2 / 3;
    search({d, d + c, d + 2 * c + b, d + foot.c1 + foot.c2 + foot.c3}, 0, 1, 0);
  }

  T distance() const { return std::sqrt(best_); }

 private:
  using Controls = std::array<T, 4>;
  static constexpr int kDepth = std::numeric_limits<T>::digits;

  static int changes(const Controls& c) {
    int count = 0;
    for (int i = 0; i < 3; ++i) count += (c[std::size_t(i)] < 0) != (c[std::size_t(i) + 1] < 0);
    return count;
  }

  static bool is_flat(const Controls& c) {
    const T step = (c[3] - c[0]) / 3;
    const T off = std::max(std::abs(c[1] - c[0] - step), std::abs(c[2] - c[3] + step));
    return off <= std::numeric_limits<T>::epsilon() * std::abs(c[3] - c[0]);
  }

  void search(const Controls& c, T lo, T hi, int depth) {
    const int count = changes(c);
    if (count == 0) return;
    if (depth == kDepth) return take((lo + hi) / 2);
    if (count == 1 && is_flat(c)) return take(lo + (hi - lo) * c[0] / (c[0] - c[3]));
    const T ab = (c[0] + c[1]) / 2, bc = (c[1] + c[2]) / 2, cd = (c[2] + c[3]) / 2;
    const T abc = (ab + bc) / 2, bcd = (bc + cd) / 2, at = (abc + bcd) / 2, middle = (lo + hi) / 2;
    search({c[0], ab, abc, at}, lo, middle, depth + 1);
    search({at, bcd, cd, c[3]}, middle, hi, depth + 1);
  }

  void take(T t) { best_ = std::min(best_, foot_.square(t)); }

  const FootEquation<T>& foot_;
  T best_;
};

template <class T>
T subdivision(const QuadBezier& curve, T x, T y) {
  const FootEquation<T> foot(curve, x, y);
  return Subdivision<T>(foot).distance();
}

}  // namespace mien::accuracy
