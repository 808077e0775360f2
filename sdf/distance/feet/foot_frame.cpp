#include "lib/math/norm.h"
#include "sdf/distance/feet/foot_pieces_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [0, 1] in cells, shorter towards the vertex, where feet meet.
int set_knots(const FootPiece& c, FootFrame::Knot* knots) {
  const double bb = glm::dot(c.b, c.b);
  const double vertex = bb > 0.0 ? -0.5 * glm::dot(c.a2, c.b) / bb : -1.0;
  const bool is_straight = bb == 0.0 && !c.tapers();
  const int each = is_straight ? 1 : c.tapers() ? 10 : 5;
  int cells = 0;
  knots[0].t = 0.0;
  if (vertex > 0.0 && vertex < 1.0) {
    for (int i = each - 1; i >= 0; --i) knots[++cells].t = vertex - vertex * i * i / (each * each);
    for (int i = 1; i < each; ++i)
      knots[++cells].t = vertex + (1.0 - vertex) * i * i / (each * each);
  } else {
    for (int i = 1; i < each; ++i) knots[++cells].t = double(i) / each;
  }
  knots[++cells].t = 1.0;
  return cells;
}

bool powers_fit(const FootPiece& c) {
  const double far = std::max({larger_side(c.p0), larger_side(c.p2), std::abs(c.w0)});
  const double size =
      std::max({larger_side(c.a2), larger_side(c.b), std::abs(c.w1), std::abs(c.w2)});
  return far < 0x1p200 && size < 0x1p200 && (size == 0.0 || size > 0x1p-200);
}

}  // namespace

FootFrame foot_frame(const FootPiece& c) {
  FootFrame f{c, powers_fit(c), norm(c.a2) + norm(c.b)};
  f.box = around(around(around(Box2{}, c.p0), c.p0 + 0.5 * c.a2), c.p2);
  f.reach = std::max({c.w0, c.w0 + 0.5 * c.w1, c.w_end}) +
            0x1p-40 * (f.size + larger_side(c.p0) + larger_side(c.p2) + c.w0 + c.w_end);
  f.cells = set_knots(c, f.knots);
  const auto speed_at = [&](double t) { return c.a2 + 2.0 * t * c.b; };
  for (int i = 0; i <= f.cells; ++i) {
    FootFrame::Knot& knot = f.knots[i];
    const double t = knot.t;
    const glm::dvec2 on = i == f.cells ? c.p2 - c.p0 : t * (c.a2 + t * c.b), g = speed_at(t);
    knot.x = on.x, knot.y = on.y;
    knot.gx = g.x, knot.gy = g.y, knot.gg = glm::dot(g, g);
    knot.widening = c.w1 + 2.0 * t * c.w2;
  }
  const double bb = glm::dot(c.b, c.b);
  const double turn = bb > 0.0 ? -0.5 * glm::dot(c.a2, c.b) / bb : 0.0;
  for (int i = 0; i < f.cells; ++i) {
    FootFrame::Knot &knot = f.knots[i], &next = f.knots[i + 1];
    const double v = knot.widening, w = next.widening;
    knot.h = next.t - knot.t;
    knot.slow = norm(speed_at(std::clamp(turn, knot.t, next.t)));
    knot.fast = std::sqrt(std::max(knot.gg, next.gg));
    knot.least = v * w > 0.0 ? std::min(std::abs(v), std::abs(w)) : 0.0;
    knot.widest = std::max(std::abs(v), std::abs(w));
  }
  const double fastest2 = std::max(f.knots[0].gg, f.knots[f.cells].gg);
  const double widens = std::max(std::abs(c.w1), std::abs(c.w1 + 2.0 * c.w2));
  f.bends = 6.0 * std::sqrt(bb * fastest2) + 4.0 * std::abs(c.w2) * std::sqrt(fastest2) +
            2.0 * widens * std::sqrt(bb);
  f.kinks = widens * fastest2;
  for (const int end : {0, 1}) {
    FootFrame::Knot& knot = f.knots[end * f.cells];
    const double length = norm(c.way[end]), sign = end ? 1.0 : -1.0;
    f.out[end] = length > 0.0 ? sign * c.way[end] / length : glm::dvec2{1.0, 0.0};
    if (glm::dvec2{knot.gx, knot.gy} != c.way[end] && c.tapers()) f.fits = false;
    knot.gx = c.way[end].x, knot.gy = c.way[end].y;
  }
  return f;
}

}  // namespace mien
