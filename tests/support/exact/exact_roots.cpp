#include "tests/support/exact/exact_roots.h"

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

struct Sample {
  double at, value;
};

/// Where to look next. Beside a root f grows about as straight as it does to the other end: a look
/// from which what it excludes just reaches what the other end does leaves least to do.
double next_look(const Sample& a, const Sample& b, double lo, double hi, double lipschitz) {
  constexpr double kAtARoot = 0.05, kInside = 0.05;
  const double fa = std::abs(a.value), fb = std::abs(b.value);
  double m = 0.5 * (lo + hi);
  if (fb < kAtARoot * fa)
    m = b.at - (b.at - lo) / (1 + fa / (lipschitz * (b.at - a.at)));
  else if (fa < kAtARoot * fb)
    m = a.at + (hi - a.at) / (1 + fb / (lipschitz * (b.at - a.at)));
  else if ((a.value <= 0) != (b.value <= 0))
    m = a.at + (b.at - a.at) * fa / (fa + fb);
  return std::clamp(m, lo + kInside * (hi - lo), hi - kInside * (hi - lo));
}

void find_between(const std::function<double(double)>& f, double lipschitz, const Sample& a,
                  const Sample& b, double shortest, std::vector<double>& out) {
  const double lo = a.at + std::abs(a.value) / lipschitz, hi = b.at - std::abs(b.value) / lipschitz;
  if (hi - lo < shortest) {  // about there, or nowhere
    if ((a.value <= 0) != (b.value <= 0))
      out.push_back(root_between(f, a.at, a.value, b.at, b.value));
    return;
  }
  const double at = next_look(a, b, lo, hi, lipschitz);
  const Sample m{at, f(at)};
  find_between(f, lipschitz, a, m, shortest, out);
  find_between(f, lipschitz, m, b, shortest, out);
}

}  // namespace

void find_roots(const std::function<double(double)>& f, double lipschitz, double a, double b,
                double shortest, std::vector<double>& out) {
  const Sample middle{0.5 * (a + b), f(0.5 * (a + b))};
  if (std::abs(middle.value) > 0.5 * (b - a) * lipschitz) return;
  find_between(f, lipschitz, {a, f(a)}, middle, shortest, out);
  find_between(f, lipschitz, middle, {b, f(b)}, shortest, out);
}

}  // namespace mien::test
