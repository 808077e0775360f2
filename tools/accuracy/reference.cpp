#include "tools/accuracy/reference.h"
#include "tools/accuracy/roots.h"

#include <algorithm>
#include <utility>

namespace mien::accuracy {
namespace {

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0);
  for (size_t i = 0; i < a.size(); ++i) {
    for (size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

Polynomial sum(Polynomial a, const Polynomial& b, Quad factor = 1) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}

Polynomial derivative(const Polynomial& p) {
  Polynomial d;
  for (size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * Quad(double(i)));
  return d;
}

/// Monomial coefficients of a quadratic and a cubic in Bézier form, less `origin`.
Polynomial bezier(Quad p0, Quad p1, Quad p2, Quad origin) {
  return {p0 - origin, 2 * (p1 - p0), p0 - 2 * p1 + p2};
}
Polynomial bezier(Quad p0, Quad p1, Quad p2, Quad p3, Quad origin) {
  return {p0 - origin, 3 * (p1 - p0), 3 * (p0 - 2 * p1 + p2), p3 - p0 + 3 * (p1 - p2)};
}

/// The least distance from 0 to (x(t), y(t)), t in [0, 1].
Quad least_distance(const Polynomial& x, const Polynomial& y) {
  const Polynomial slope = sum(product(x, derivative(x)), product(y, derivative(y)));
  const auto square_at = [&](Quad t) {
    const Quad vx = value(x, t), vy = value(y, t);
    return vx * vx + vy * vy;
  };
  Quad least = std::min(square_at(0), square_at(1));
  for (const Quad t : sign_changes(slope, 0, 1)) least = std::min(least, square_at(t));
  return square_root(least);
}

struct Along {
  Quad along, across;
};

Along along_axis(glm::dvec2 axis, glm::dvec2 from, glm::dvec2 p) {
  const Quad ax = axis.x, ay = axis.y, length = square_root(ax * ax + ay * ay);
  const Quad x = Quad(p.x) - from.x, y = Quad(p.y) - from.y;
  return {(x * ax + y * ay) / length, (y * ax - x * ay) / length};
}

/// The root v > 0 of (ax / (v + focal))² + (by / v)² = 1, by > 0: halving, in the logarithm while
/// far.
Quad secular_root(Quad ax, Quad by, Quad focal) {
  const auto excess = [&](Quad v) {
    const Quad c = ax / (v + focal), s = by / v;
    return c * c + s * s - 1;
  };
  Quad low = std::max(by, ax - focal), high = square_root(ax * ax + by * by);
  Quad v = low;
  for (int i = 0; i < 400 && low < high; ++i) {
    const Quad e = excess(v);
    if (e == 0) return v;
    (e > 0 ? low : high) = v;
    const Quad c = ax / (v + focal), s = by / v;
    Quad next = v + e / (2 * (c * c / (v + focal) + s * s / v));
    if (!(next > low && next < high) || i % 4 == 3) next = square_root(low) * square_root(high);
    if (magnitude(next - v) <= Quad(0x1p-111L) * v) return next;
    v = next;
  }
  return v;
}

}  // namespace

Quad true_distance(const QuadBezier& c, glm::dvec2 p) {
  return least_distance(bezier(c.p0.x, c.p1.x, c.p2.x, p.x), bezier(c.p0.y, c.p1.y, c.p2.y, p.y));
}

Quad true_distance(const CubicBezier& c, glm::dvec2 p) {
  return least_distance(bezier(c.p0.x, c.p1.x, c.p2.x, c.p3.x, p.x),
                        bezier(c.p0.y, c.p1.y, c.p2.y, c.p3.y, p.y));
}

Quad true_distance(const Ellipse& e, glm::dvec2 p) {
  const Along at = along_axis(e.axis, e.center, p);
  Quad a = e.radii.x, b = e.radii.y, x = magnitude(at.along), y = magnitude(at.across);
  if (a < b) std::swap(a, b), std::swap(x, y);
  const bool inside = (x / a) * (x / a) + (y / b) * (y / b) < 1;
  const Quad focal = (a - b) * (a + b);
  Quad fx = 0, fy = b;
  if (y > 0) {
    const Quad v = secular_root(a * x, b * y, focal);
    fx = a * (a * x / (v + focal)), fy = b * (b * y / v);
  } else if (a * x < focal) {
    const Quad c = a * x / focal;
    fx = a * c, fy = b * square_root(1 - c * c);
  } else {
    fx = a, fy = 0;
  }
  const Quad d = square_root((x - fx) * (x - fx) + (y - fy) * (y - fy));
  return inside ? -d : d;
}

Quad true_distance(const ParabolaSide& s, glm::dvec2 p) {
  const Along at = along_axis(s.axis, s.vertex, p);
  const Quad k = magnitude(Quad(s.bend)), u = magnitude(at.across),
             v = s.bend < 0 ? -at.along : at.along;
  // One positive root, at most u + sqrt(|v| / k).
  const Quad most = u + (k > 0 ? square_root(magnitude(v) / k) : Quad(0));
  Quad foot = 0;
  for (const Quad t : sign_changes({-u, 1 - 2 * k * v, 0, 2 * k * k}, 0, most)) foot = t;
  const Quad dx = u - foot, dy = v - k * foot * foot, d = square_root(dx * dx + dy * dy);
  const bool inside = v > k * u * u;
  return inside == (s.bend >= 0) ? -d : d;
}

Quad true_distance(const TaperedStroke& s, glm::dvec2 p) {
  const QuadBezier& c = s.spine;
  const Polynomial x = bezier(c.p0.x, c.p1.x, c.p2.x, p.x), y = bezier(c.p0.y, c.p1.y, c.p2.y, p.y);
  const Polynomial w = bezier(s.half_width[0], s.half_width[1], s.half_width[2], 0);
  const Polynomial square = sum(product(x, x), product(y, y));
  const auto distance_at = [&](Quad t) {
    const Quad vx = value(x, t), vy = value(y, t);
    return square_root(vx * vx + vy * vy) - value(w, t);
  };
  Quad least = std::min(distance_at(0), distance_at(1));
  for (int step = 0; step < 200;
       ++step) {  // a distance below `least` makes the quartic negative there
    const Polynomial reach = sum(w, {least});
    const Quad before = least;
    for (const Quad t : sign_changes(derivative(sum(square, product(reach, reach), -1)), 0, 1)) {
      least = std::min(least, distance_at(t));
    }
    if (!(least < before)) break;
  }
  return least;
}

Quad true_distance(const Case& k) {
  return std::visit([&](const auto& figure) { return true_distance(figure, k.p); }, k.figure);
}

}  // namespace mien::accuracy
