#include "lib/math/quartic.h"
#include <mien/cubic_roots.h>
#include "lib/math/bracketed_root.h"

#include <algorithm>
#include <cmath>

namespace mien {
namespace {

constexpr double kLargestQuartic = std::numeric_limits<double>::max();
constexpr double kQuarticNoise = 0x1p-51;  // of the terms' absolute sum; see cubic.cpp

struct Quartic {
  double a, b, c, d, e;

  ValueSlope at(double x) const {
    const double y = std::abs(x);
    const double size =
        (((std::abs(a) * y + std::abs(b)) * y + std::abs(c)) * y + std::abs(d)) * y + std::abs(e);
    return {(((a * x + b) * x + c) * x + d) * x + e,
            ((4.0 * a * x + 3.0 * b) * x + 2.0 * c) * x + d, kQuarticNoise * size};
  }
};

/// The roots of a quartic with f.a != 0 and a largest coefficient of about 1: at most one in each of its
/// monotone pieces.
QuarticRoots solve_true_quartic(const Quartic& f) {
  QuarticRoots roots;
  const auto add = [&](double x) {
    if (roots.count < 4 && (roots.count == 0 || roots.x[roots.count - 1] < x))
      roots.x[roots.count++] = x;
  };
  const auto value = [&](double x) {
    ValueSlope v = f.at(x);
    v.noise *= 0.25;
    return v;
  };
  const Roots turns = solve_cubic(4.0 * f.a, 3.0 * f.b, 2.0 * f.c, f.d);
  double lo = -kLargestQuartic, sign_lo = f.a;
  for (int i = 0; i <= turns.count; ++i) {
    const bool last = i == turns.count;
    const double hi = last ? kLargestQuartic : turns.x[i];
    const ValueSlope at = last ? ValueSlope{f.a, 0.0} : f.at(hi);
    const bool flat = !last && std::abs(at.value) <= at.noise;
    if (flat) {
      add(hi);
    } else if (sign_lo != 0.0 && (sign_lo < 0.0) != (at.value < 0.0)) {
      // From an end at infinity, start beside the other end.
      const double beside = lo == -kLargestQuartic ? hi - std::max(1.0, std::abs(hi))
                            : last                 ? lo + std::max(1.0, std::abs(lo))
                                                   : 0.5 * lo + 0.5 * hi;
      add(bracketed_root(value, lo, hi, sign_lo, beside, CubicContract::kMaxEvaluations));
    }
    lo = hi;
    sign_lo = flat ? 0.0 : at.value;
  }
  return roots;
}

}  // namespace

QuarticRoots solve_quartic(double a, double b, double c, double d, double e) {
  double largest = 0.0;
  for (const double v : {a, b, c, d, e}) {
    if (!std::isfinite(v)) return {};
    largest = std::max(largest, std::abs(v));
  }
  if (largest == 0.0) return {-1, {}};
  const double k = std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000));
  const Quartic f{k * a, k * b, k * c, k * d, k * e};
  if (f.a == 0.0) {
    QuarticRoots roots;
    const Roots lower = solve_cubic(f.b, f.c, f.d, f.e);
    roots.count = lower.count;
    std::copy(lower.x.begin(), lower.x.end(), roots.x.begin());
    return roots;
  }
  return solve_true_quartic(f);
}

}  // namespace mien
