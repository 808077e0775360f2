#include <mien/cubic_bezier_distance.h>
#include "lib/math/norm.h"
#include "lib/math/unit_zeros.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace mien {
namespace {

/// A quintic on a piece of [0, 1], by its Bernstein coefficients there.
using Quintic = std::array<double, 6>;

/// Halves a Bézier curve of N control points: the left half stays in c, the right one is returned.
template <std::size_t N>
std::array<glm::dvec2, N> split(std::array<glm::dvec2, N>& c) {
  std::array<glm::dvec2, N> right = c;
  for (std::size_t level = 1; level < N; ++level) {
    for (std::size_t i = 0; i < N - level; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    c[level] = right[0];
  }
  return right;
}

template <std::size_t N>
double longest(const std::array<glm::dvec2, N>& c) {
  double far = 0.0;
  for (const glm::dvec2 v : c) far = std::max({far, std::abs(v.x), std::abs(v.y)});
  return far;
}

/// The curve seen from a point.
struct Seen {
  std::array<glm::dvec2, 4> q;  ///< control points minus p
  std::array<glm::dvec2, 3> u;  ///< and of B'/3

  Seen(const CubicBezier& c, glm::dvec2 p)
      : q{c.p0 - p, c.p1 - p, c.p2 - p, c.p3 - p}, u{c.p1 - c.p0, c.p2 - c.p1, c.p3 - c.p2} {}

  double size() const {
    double sum = 0.0;
    for (const glm::dvec2 v : q) sum += std::abs(v.x) + std::abs(v.y);
    return sum;
  }

  glm::dvec2 at(double t) const {
    const double s = 1.0 - t;
    const glm::dvec2 a = s * q[0] + t * q[1], b = s * q[1] + t * q[2], c = s * q[2] + t * q[3];
    return s * (s * a + t * b) + t * (s * b + t * c);
  }

  /// f = (B − p)·(B'/3) and its slope.
  ValueSlope slope(double t) const {
    const double s = 1.0 - t;
    const glm::dvec2 a = s * u[0] + t * u[1], b = s * u[1] + t * u[2];
    const glm::dvec2 v = s * a + t * b, here = at(t);
    return {glm::dot(here, v), 3.0 * glm::dot(v, v) + 2.0 * glm::dot(here, b - a)};
  }
};

/// A piece of the curve and of B'/3, both by their own control points on [lo, hi]. f's coefficients are formed again
/// on every piece, so they stay accurate near a cusp, where both are small.
struct Piece {
  std::array<glm::dvec2, 4> q;
  std::array<glm::dvec2, 3> u;
  double lo, hi;

  /// f's Bernstein coefficients: products of binomials over those of degree 5.
  Quintic quintic() const {
    constexpr double kThree[] = {1, 3, 3, 1}, kTwo[] = {1, 2, 1}, kFive[] = {1, 5, 10, 10, 5, 1};
    Quintic f{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        f[i + j] += kThree[i] * kTwo[j] / kFive[i + j] * glm::dot(q[i], u[j]);
    return f;
  }
};

/// Searches the pieces of [0, 1] for the nearest point.
class Search {
 public:
  explicit Search(const Seen& seen) : seen_(seen), far_(longest(seen.q)), fast_(longest(seen.u)) {
    consider(0.0);
    consider(1.0);
    visit({seen.q, seen.u, 0.0, 1.0}, 0);
  }
  double squared() const { return squared_; }
  double t() const { return t_; }

 private:
  void consider(double t) {
    const glm::dvec2 q = seen_.at(t);
    const double squared = glm::dot(q, q);
    if (!(squared < squared_)) return;
    squared_ = squared;
    t_ = t;
  }

  void visit(Piece piece, int depth) {
    // Below the rounding of B − p and B' a coefficient has no sign.
    const double noise = 0x1p-53 * (far_ * longest(piece.u) + fast_ * longest(piece.q));
    const auto sign = [noise](double v) { return std::abs(v) <= noise ? 0 : v < 0.0 ? -1 : 1; };
    int changes = 0, last = 0, first = 0;
    for (const double v : piece.quintic()) {
      const int now = sign(v);
      if (now == 0) continue;
      changes += last != 0 && now != last;
      if (last == 0) first = now;
      last = now;
    }
    const double middle = 0.5 * (piece.lo + piece.hi);
    if (changes == 0) return last == 0 ? consider(middle) : void();  // flat to within rounding
    if (changes == 1) return first < 0 ? polish(piece.lo, piece.hi, noise) : void();
    if (depth == CubicBezierContract::kMaxDepth || ++splits_ > CubicBezierContract::kMaxSplits)
      return consider(middle);
    const Piece right{split(piece.q), split(piece.u), middle, piece.hi};
    piece.hi = middle;
    if (sign(glm::dot(right.q[0], right.u[0])) == 0)
      consider(middle);  // a zero here may belong to neither half
    visit(piece, depth + 1);
    visit(right, depth + 1);
  }

  /// One rising zero between lo and hi; where f is 0 or rounding at an end, its sign beside it is
  /// known.
  void polish(double lo, double hi, double noise) {
    const double at_lo = std::min(seen_.slope(lo).value, -noise);
    const double at_hi = std::max(seen_.slope(hi).value, noise);
    consider(unit_zero_between([this](double t) { return seen_.slope(t); }, lo, hi, at_lo, at_hi));
    consider(lo);
    consider(hi);
  }

  const Seen& seen_;
  double far_, fast_;
  int splits_ = 0;
  double squared_ = std::numeric_limits<double>::infinity(), t_ = 0.0;
};

CubicBezier scaled(const CubicBezier& c, double k) {
  return {k * c.p0, k * c.p1, k * c.p2, k * c.p3};
}

}  // namespace

NearestPoint nearest(const CubicBezier& curve, glm::dvec2 p) {
  const Seen seen(curve, p);
  const double size = seen.size();
  if (size > 0x1p-200 && size < 0x1p200) {
    const Search search(seen);
    return {std::sqrt(search.squared()), search.t(), point(curve, search.t())};
  }
  double largest = 0.0;
  for (const glm::dvec2 v : {curve.p0, curve.p1, curve.p2, curve.p3, p}) {
    if (!std::isfinite(v.x) || !std::isfinite(v.y))
      return {std::numeric_limits<double>::infinity(), 0.0, curve.p0};
    largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
  }
  if (size == 0.0) return {0.0, 0.0, curve.p0};
  // Powers of such sizes leave the range of doubles: ask at a safe size, seen from p if that is
  // what is small.
  const bool small = size < 1.0;
  const double k = std::ldexp(1.0, -std::clamp(std::ilogb(small ? size : largest), -1000, 1000));
  const CubicBezier there{curve.p0 - p, curve.p1 - p, curve.p2 - p, curve.p3 - p};
  const Seen rescued = small ? Seen(scaled(there, k), {0.0, 0.0}) : Seen(scaled(curve, k), k * p);
  const Search search(rescued);
  return {std::sqrt(search.squared()) / k, search.t(), p + rescued.at(search.t()) / k};
}

double distance(const CubicBezier& curve, glm::dvec2 p) {
  return nearest(curve, p).distance;
}

}  // namespace mien
