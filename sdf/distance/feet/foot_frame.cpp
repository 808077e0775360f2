#include "lib/math/norm.h"
#include "sdf/distance/feet/foot_pieces_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [0, 1] in cells, shorter towards the vertex, where feet meet.
int set_knots(const FootPiece& c, double* t) {
  const double bb = glm::dot(c.b, c.b);
  const double vertex = bb > 0.0 ? -0.5 * glm::dot(c.a2, c.b) / bb : -1.0;
  const bool is_straight = bb == 0.0 && !c.tapers();
  const int each = is_straight ? 1 : c.tapers() ? 10 : 5;
  int cells = 0;
  t[0] = 0.0;
  if (vertex > 0.0 && vertex < 1.0) {
    for (int i = each - 1; i >= 0; --i) t[++cells] = vertex - vertex * i * i / (each * each);
    for (int i = 1; i < each; ++i)
      t[++cells] = vertex + (1.0 - vertex) * i * i / (each * each);
  } else {
    for (int i = 1; i < each; ++i) t[++cells] = double(i) / each;
  }
  t[++cells] = 1.0;
  return cells;
}

bool powers_fit(const FootPiece& c) {
  const double far = std::max({larger_side(c.p0), larger_side(c.p2), std::abs(c.w0)});
  const double size = std::max({larger_side(c.a2), larger_side(c.b), std::abs(c.w1), std::abs(c.w2)});
  return far < 0x1p200 && size < 0x1p200 && (size == 0.0 || size > 0x1p-200);
}

}  // namespace

FootFrame foot_frame(const FootPiece& c) {
  FootFrame f{c, powers_fit(c), norm(c.a2) + norm(c.b)};
  f.cells = set_knots(c, f.t);
  const auto speed_at = [&](double t) { return c.a2 + 2.0 * t * c.b; };
  for (int i = 0; i <= f.cells; ++i) {
    const double t = f.t[i];
    const glm::dvec2 on = i == f.cells ? c.p2 - c.p0 : t * (c.a2 + t * c.b), g = speed_at(t);
    f.x[i] = on.x, f.y[i] = on.y;
    f.gx[i] = g.x, f.gy[i] = g.y, f.gg[i] = glm::dot(g, g);
    f.widening[i] = c.w1 + 2.0 * t * c.w2;
  }
  const double bb = glm::dot(c.b, c.b);
  for (int i = 0; i < f.cells; ++i) {
    const double v = f.widening[i], w = f.widening[i + 1];
    const double turn = bb > 0.0 ? -0.5 * glm::dot(c.a2, c.b) / bb : 0.0;
    f.h[i] = f.t[i + 1] - f.t[i];
    f.slow[i] = norm(speed_at(std::clamp(turn, f.t[i], f.t[i + 1])));
    f.fast[i] = std::sqrt(std::max(f.gg[i], f.gg[i + 1]));
    f.least[i] = v * w > 0.0 ? std::min(std::abs(v), std::abs(w)) : 0.0;
    f.widest[i] = std::max(std::abs(v), std::abs(w));
  }
  f.fastest = std::sqrt(std::max(f.gg[0], f.gg[f.cells]));
  for (const int end : {0, 1}) {
    const int i = end * f.cells;
    const double length = norm(c.way[end]), sign = end ? 1.0 : -1.0;
    f.out[end] = length > 0.0 ? sign * c.way[end] / length : glm::dvec2{1.0, 0.0};
    const bool sets_out = glm::dvec2{f.gx[i], f.gy[i]} == c.way[end];
    if (!sets_out && c.tapers()) f.fits = false;
    f.gx[i] = c.way[end].x, f.gy[i] = c.way[end].y;
  }
  return f;
}

}  // namespace mien
