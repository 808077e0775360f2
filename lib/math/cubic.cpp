#include <mien/cubic_roots.h>
#include "lib/math/bracketed_root.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mien {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

/// Rounding of Horner's rule is at most 6·2⁻⁵³ of the terms' absolute sum; half of that is typical.
/// A value below kNoise of the sum tells nothing about its sign.
constexpr double kNoise = 0x1p-51;

/// p q − r s, within 1.5 ulp (Kahan's way with two fused multiply-adds).
double difference_of_products(double p, double q, double r, double s) {
  const double rs = r * s;
  return std::fma(p, q, -rs) + std::fma(-r, s, rs);
}

struct Cubic {
  double a, b, c, d;

  double operator()(double x) const { return ((a * x + b) * x + c) * x + d; }
  double size(double x) const {  // the terms' absolute sum
    const double y = std::abs(x);
    return ((std::abs(a) * y + std::abs(b)) * y + std::abs(c)) * y + std::abs(d);
  }
  ValueSlope at(double x) const {
    return {(*this)(x), (3.0 * a * x + 2.0 * b) * x + c, 0.25 * kNoise * size(x)};
  }
  /// The root between lo and hi.
  double root(double lo, double hi, double sign_lo, double start) const {
    return bracketed_root([this](double x) { return at(x); }, lo, hi, sign_lo, start,
                          CubicContract::kMaxEvaluations);
  }
};

void add(Roots& r, double x) {
  if (r.count > 0 && r.x[r.count - 1] == x) return;
  r.x[r.count++] = x;
}

/// a > 0 and no critical points, or two so close that they don't matter.
Roots one_root(const Cubic& f, double discriminant) {
  const double turn = std::clamp(-f.b / (3.0 * f.a), -kLargest, kLargest);
  const double value = f(turn), slope = -discriminant / (3.0 * f.a);
  if (value == 0.0) return {1, {turn}};
  const double far = std::min(std::abs(value) / slope, std::cbrt(std::abs(value) / f.a));
  if (value > 0.0) return {1, {f.root(-kLargest, turn, -1.0, turn - far)}};
  return {1, {f.root(turn, kLargest, -1.0, turn + far)}};
}

/// a > 0, critical points m1 < m2: a maximum and a minimum.
Roots up_down_up(const Cubic& f, double r, double m1, double m2) {
  const double f1 = f(m1), f2 = f(m2);
  const bool double1 = std::abs(f1) <= kNoise * f.size(m1);
  const bool double2 = std::abs(f2) <= kNoise * f.size(m2);
  if (double1 && double2) return {1, {0.5 * m1 + 0.5 * m2}};
  const auto outer = [&](double value) {
    return std::min(std::sqrt(std::abs(value) / r), std::cbrt(std::abs(value) / f.a));
  };
  Roots roots;
  if (double1)
    add(roots, m1);
  else if (f1 > 0.0)
    add(roots, f.root(-kLargest, m1, -1.0, m1 - outer(f1)));
  if (!double1 && !double2 && f1 > 0.0 && f2 < 0.0) {
    constexpr double kMiddle =
        1.2247448713915890;  // sqrt(3/2): Newton then comes from the steep side
    double start = 0.5 * m1 + 0.5 * m2;
    if (f1 < -f2) start = m1 + kMiddle * std::sqrt(f1 / r);
    if (f1 > -f2) start = m2 - kMiddle * std::sqrt(-f2 / r);
    add(roots, f.root(m1, m2, 1.0, start));
  }
  if (double2)
    add(roots, m2);
  else if (f2 < 0.0)
    add(roots, f.root(m2, kLargest, -1.0, m2 + outer(f2)));
  return roots;
}

/// a > 0, d != 0, and coefficients that cannot overflow.
Roots solve_true_cubic(const Cubic& f) {
  const double discriminant = difference_of_products(f.b, f.b, 3.0 * f.a, f.c);
  if (!(discriminant > 0.0)) return one_root(f, discriminant);
  const double r = std::sqrt(discriminant), q = -(f.b + std::copysign(r, f.b + 0.0));
  double m1 = std::clamp(q / (3.0 * f.a), -kLargest, kLargest), m2 = f.b == 0.0 ? -m1 : f.c / q;
  if (m1 > m2) std::swap(m1, m2);
  if (!(m1 < m2)) return one_root(f, 0.0);
  return up_down_up(f, r, m1, m2);
}

Roots solve_linear(double a, double b) {
  if (a == 0.0) return {b == 0.0 ? -1 : 0, {}};
  return {1, {-b / a + 0.0}};  // + 0.0: no negative zero
}

/// Scales by powers of two so that the first and last of N coefficients are alike and the largest is about
/// 1: x = 2^k y.
template <std::size_t N>
int balance(std::array<double, N>& c) {
  constexpr int kDegree = static_cast<int>(N) - 1;
  const int k = (std::ilogb(c[N - 1]) - std::ilogb(c[0])) / kDegree;
  int top = -5000;
  for (std::size_t i = 0; i < N; ++i)
    if (c[i] != 0.0) top = std::max(top, std::ilogb(c[i]) + k * (kDegree - static_cast<int>(i)));
  for (std::size_t i = 0; i < N; ++i)
    c[i] = std::scalbn(c[i], k * (kDegree - static_cast<int>(i)) - top);
  return k;
}

Roots scaled(Roots r, int k) {
  for (int i = 0; i < r.count; ++i) r.x[i] = std::scalbn(r.x[i], k);
  return r;
}

/// The given roots and 0.
Roots with_zero(const Roots& r) {
  Roots all;
  bool pending = true;
  for (int i = 0; i < r.count; ++i) {
    if (pending && r.x[i] >= 0.0) {
      add(all, 0.0);
      pending = false;
    }
    add(all, r.x[i]);
  }
  if (pending) add(all, 0.0);
  return all;
}

bool safe(double v) {
  return v == 0.0 || (std::abs(v) > 0x1p-200 && std::abs(v) < 0x1p200);
}

}  // namespace

Roots solve_quadratic(double a, double b, double c) {
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c)) return {};
  if (a == 0.0) return solve_linear(b, c);
  if (c == 0.0) return with_zero(solve_linear(a, b));
  std::array<double, 3> k{a, b, c};
  const int shift = safe(a) && safe(b) && safe(c) ? 0 : balance(k);
  const double discriminant = difference_of_products(k[1], k[1], 4.0 * k[0], k[2]);
  if (discriminant <= 0.0) {
    if (discriminant < -kNoise * k[1] * k[1]) return {};
    return scaled({1, {-0.5 * k[1] / k[0] + 0.0}}, shift);
  }
  const double q = -0.5 * (k[1] + std::copysign(std::sqrt(discriminant), k[1]));
  const double x = q / k[0], y = k[1] == 0.0 ? -x : k[2] / q;  // mirror images alike
  Roots roots;
  add(roots, std::min(x, y));
  add(roots, std::max(x, y));
  return scaled(roots, shift);
}

Roots solve_cubic(double a, double b, double c, double d) {
  if (!std::isfinite(a) || !std::isfinite(b) || !std::isfinite(c) || !std::isfinite(d)) return {};
  if (a == 0.0) return solve_quadratic(b, c, d);
  if (d == 0.0) return with_zero(solve_quadratic(a, b, c));
  std::array<double, 4> k{a, b, c, d};
  const int shift = safe(a) && safe(b) && safe(c) && safe(d) ? 0 : balance(k);
  if (k[0] < 0.0)
    for (double& v : k) v = -v;
  if (k[0] == 0.0) return scaled(solve_quadratic(k[1], k[2], k[3]), shift);
  return scaled(solve_true_cubic({k[0], k[1], k[2], k[3]}), shift);
}

}  // namespace mien
