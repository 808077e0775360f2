// The laboratory's reference against 100 decimal digits and another method: dense search, then Newton from the
// best few samples.

#include <gtest/gtest.h>

#include "tools/accuracy/reference.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

namespace mien::accuracy {
namespace {

using Big = boost::multiprecision::cpp_bin_float_100;

/// The least |(x(t), y(t))|, t in [0, 1], of two polynomials with ascending coefficients.
Big least_norm(const std::vector<Big>& x, const std::vector<Big>& y) {
  const auto at = [](const std::vector<Big>& p, const Big& t, int derivative) {
    Big v = 0;
    for (size_t i = p.size(); i-- > size_t(derivative);) {
      Big factor = p[i];
      for (int k = 0; k < derivative; ++k) factor *= double(i) - k;
      v = v * t + factor;
    }
    return v;
  };
  const auto square = [&](const Big& t) -> Big {
    const Big vx = at(x, t, 0), vy = at(y, t, 0);
    return vx * vx + vy * vy;
  };
  constexpr int kSamples = 500;
  Big least = square(0) < square(1) ? square(0) : square(1);
  for (int i = 1; i < kSamples; ++i) {
    Big t = Big(i) / kSamples;
    const Big step = Big(1) / kSamples;
    if (square(t - step) < square(t) || square(t + step) < square(t)) continue;
    Big low = t - step, high = t + step;
    for (int halvings = 0; halvings < 340; ++halvings) {  // on the sign of the slope
      t = (low + high) / 2;
      const Big slope = at(x, t, 0) * at(x, t, 1) + at(y, t, 0) * at(y, t, 1);
      (slope < 0 ? low : high) = t;
    }
    if (square(t) < least) least = square(t);
  }
  return sqrt(least);
}

Big exact(const QuadBezier& c, glm::dvec2 p) {
  const auto axis = [](Big a, Big b, Big d, Big o) {
    return std::vector<Big>{a - o, 2 * (b - a), a - 2 * b + d};
  };
  return least_norm(axis(c.p0.x, c.p1.x, c.p2.x, p.x), axis(c.p0.y, c.p1.y, c.p2.y, p.y));
}

Big exact(const CubicBezier& c, glm::dvec2 p) {
  const auto axis = [](Big a, Big b, Big d, Big e, Big o) {
    return std::vector<Big>{a - o, 3 * (b - a), 3 * (a - 2 * b + d), e - a + 3 * (b - d)};
  };
  return least_norm(axis(c.p0.x, c.p1.x, c.p2.x, c.p3.x, p.x),
                    axis(c.p0.y, c.p1.y, c.p2.y, c.p3.y, p.y));
}

Big big(Quad q) {
  const double head = double(q), middle = double(q - Quad(head));
  return Big(head) + Big(middle) + Big(double(q - Quad(head) - Quad(middle)));
}

TEST(Reference, AgreesWithAHundredDigits) {
  for (const Family& family : families()) {
    if (family.name == "beyond reason") continue;  // 500 samples cannot see its minima apart
    for (const Case& k : cases_of(family, 3, 5)) {
      Big truth;
      if (const auto* curve = std::get_if<QuadBezier>(&k.figure)) {
        truth = exact(*curve, k.p);
      } else if (const auto* cubic = std::get_if<CubicBezier>(&k.figure)) {
        truth = exact(*cubic, k.p);
      } else {
        continue;
      }
      const Big error = abs(big(true_distance(k)) - truth);
      EXPECT_LT(double(error), 1e-24 * (1e-6 + double(truth))) << family.name;
    }
  }
}

/// Feet of ellipses and parabolas: the reference's distance is that of a point on the outline whose normal
/// passes through p, built the other way round, from the foot.
TEST(Reference, FindsTheFootAConicWasBuiltFrom) {
  Random r(3);
  for (int i = 0; i < 200; ++i) {
    const double a = 1, b = r.between(0.1, 1),
                 d = r.between(-0.5, 5) * b * b;  // inside the evolute
    // A rational point of the unit circle, so that everything below is exact in binary128.
    const double t = std::floor(r.between(0, 256)) / 256;
    const Quad c = (1 - Quad(t) * t) / (1 + Quad(t) * t), s = 2 * Quad(t) / (1 + Quad(t) * t);
    const Quad n = square_root(b * c * (b * c) + a * s * (a * s));
    const Quad x = a * c + d * (b * c) / n, y = b * s + d * (a * s) / n;
    if (x < 0 || y < 0) continue;
    const Quad found = true_distance(Ellipse{{0, 0}, {a, b}}, {double(x), double(y)});
    EXPECT_LT(double(magnitude(found - Quad(d))), 4e-16 * 6) << a << ' ' << b << ' ' << d;
    const Quad u = r.between(0, 2), m = square_root(1 + 4 * u * u), e = r.between(-0.4, 3);
    const Quad px = u + e * (2 * u) / m, py = u * u - e / m;
    const Quad side = true_distance(ParabolaSide{{0, 0}, {0, 1}, 1}, {double(px), double(py)});
    EXPECT_LT(double(magnitude(side - e)), 4e-16 * 6) << double(u) << ' ' << double(e);
  }
}

}  // namespace
}  // namespace mien::accuracy
