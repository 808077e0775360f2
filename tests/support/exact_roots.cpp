#include "tests/support/exact_roots.h"

#include <algorithm>
#include <cmath>

namespace mien::test {
namespace {

/// The one change of sign between a and b: the secant of the ends, of which one that stays twice
/// counts half.
double root_between(const std::function<double(double)>& f, double a, double fa, double b,
                    double fb) {
  constexpr double kNear = 1e-13;  // [px]
  double weight_a = fa, weight_b = fb;
  for (int i = 0; i < 60 && b - a > kNear; ++i) {
    const double secant = a + (b - a) * (weight_a / (weight_a - weight_b));
    const double m = i % 8 == 7 || !(secant > a && secant < b)  // a jump or a flat: halves
                         ? 0.5 * (a + b)
                         : std::clamp(secant, a + 0.4 * kNear, b - 0.4 * kNear);
    const double fm = f(m);
    if ((fm <= 0) == (fa <= 0)) {
      a = m, weight_a = fm, weight_b *= 0.5;
    } else {
      b = m, weight_b = fm, weight_a *= 0.5;
    }
  }
  return 0.5 * (a + b);
}

void find_between(const std::function<double(double)>& f, double lipschitz, double a, double fa,
                  double b, double fb, double shortest, std::vector<double>& out) {
  if (b - a < shortest) {
    if ((fa <= 0) != (fb <= 0)) out.push_back(root_between(f, a, fa, b, fb));
    return;
  }
  const double m = 0.5 * (a + b), fm = f(m);
  if (std::abs(fm) > 0.5 * (b - a) * lipschitz) return;
  find_between(f, lipschitz, a, fa, m, fm, shortest, out);
  find_between(f, lipschitz, m, fm, b, fb, shortest, out);
}

}  // namespace

void find_roots(const std::function<double(double)>& f, double lipschitz, double a, double b,
                double shortest, std::vector<double>& out) {
  find_between(f, lipschitz, a, f(a), b, f(b), shortest, out);
}

}  // namespace mien::test
