#pragma once
// Numbers of 113 bits, and the few things the references need of them. Only arithmetic is the
// compiler's; the square root is Newton's.

#include <cmath>
#include <vector>

namespace mien::test {

__extension__ typedef __float128 Real;

inline Real abs(Real x) {
  return x < 0 ? -x : x;
}

inline Real sqrt(Real x) {
  if (!(x > 0)) return 0;
  Real scale = 1;
  for (int i = 0; i < 40 && x > Real(1e300); ++i) x *= Real(0x1p-800), scale *= Real(0x1p400);
  for (int i = 0; i < 40 && x < Real(1e-300); ++i) x *= Real(0x1p800), scale *= Real(0x1p-400);
  Real y = std::sqrt(static_cast<double>(x));
  for (int i = 0; i < 3; ++i) y = (y + x / y) / 2;
  return y * scale;
}

struct Real2 {
  Real x = 0, y = 0;
  friend Real2 operator+(Real2 a, Real2 b) { return {a.x + b.x, a.y + b.y}; }
  friend Real2 operator-(Real2 a, Real2 b) { return {a.x - b.x, a.y - b.y}; }
  friend Real2 operator*(Real k, Real2 a) { return {k * a.x, k * a.y}; }
  friend Real dot(Real2 a, Real2 b) { return a.x * b.x + a.y * b.y; }
  friend Real cross(Real2 a, Real2 b) { return a.x * b.y - a.y * b.x; }
  friend Real length(Real2 a) { return sqrt(dot(a, a)); }
};

/// A polynomial, coefficients ascending.
using Polynomial = std::vector<Real>;

inline Real value(const Polynomial& f, Real x) {
  Real v = 0;
  for (auto c = f.rbegin(); c != f.rend(); ++c) v = v * x + *c;
  return v;
}

inline Polynomial derivative(const Polynomial& f) {
  Polynomial d;
  for (std::size_t i = 1; i < f.size(); ++i) d.push_back(Real(static_cast<double>(i)) * f[i]);
  return d;
}

inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, Real(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

inline Polynomial operator+(Polynomial a, const Polynomial& b) {
  if (a.size() < b.size()) a.resize(b.size(), Real(0));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

inline Polynomial operator*(Real k, Polynomial a) {
  for (Real& c : a) c *= k;
  return a;
}

/// The root between lo and hi, where f differs in sign: Newton inside a bracket, else halving.
inline Real root_between(const Polynomial& f, const Polynomial& slope, Real lo, Real hi) {
  const bool rising = value(f, lo) < 0;
  Real x = (lo + hi) / 2;
  for (int i = 0; i < 600; ++i) {
    const Real v = value(f, x);
    if (v == 0) return x;
    ((v < 0) == rising ? lo : hi) = x;
    const Real d = value(slope, x);
    Real next = d != 0 ? x - v / d : lo;
    if (!(next > lo && next < hi) || i % 4 == 3) {
      // Halve: in the exponent if the ends are far apart in size, else in the value.
      const bool far = (lo > 0 && hi > 4 * lo) || (hi < 0 && lo < 4 * hi);
      next = far ? (lo > 0 ? sqrt(lo) * sqrt(hi) : -(sqrt(-lo) * sqrt(-hi))) : (lo + hi) / 2;
    }
    if (abs(next - x) <= Real(0x1p-108) * abs(x) || !(next > lo && next < hi)) return next;
    x = next;
  }
  return x;
}

/// Real roots in [lo, hi], ascending: sign changes between the roots of the derivative; a critical
/// point where f is 0 counts once.
inline std::vector<Real> roots_in(const Polynomial& f, Real lo, Real hi) {
  std::vector<Real> roots;
  if (f.size() < 2) return roots;
  const Polynomial slope = derivative(f);
  std::vector<Real> knots{lo};
  for (const Real m : roots_in(slope, lo, hi))
    if (m > knots.back() && m < hi) knots.push_back(m);
  knots.push_back(hi);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Real a = value(f, knots[i]), b = value(f, knots[i + 1]);
    if (a == 0 && (roots.empty() || roots.back() < knots[i])) roots.push_back(knots[i]);
    if ((a < 0 && b > 0) || (a > 0 && b < 0))
      roots.push_back(root_between(f, slope, knots[i], knots[i + 1]));
  }
  if (value(f, hi) == 0 && (roots.empty() || roots.back() < hi)) roots.push_back(hi);
  return roots;
}

/// All real roots: no root is larger than 1 + the largest ratio to the leading coefficient.
inline std::vector<Real> real_roots(Polynomial f) {
  while (!f.empty() && f.back() == 0) f.pop_back();
  if (f.size() < 2) return {};
  Real ratio = 0;
  for (const Real c : f)
    if (abs(c / f.back()) > ratio) ratio = abs(c / f.back());
  return roots_in(f, -(1 + ratio), 1 + ratio);
}

}  // namespace mien::test
