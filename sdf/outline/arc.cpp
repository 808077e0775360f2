#include "arc_private.h"
#include "cross_private.h"

#include <mien/lib/math/norm.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kCircle = 6.283185307179586;
/// [rad] The most a piece turns, however coarse the tolerance.
constexpr double kMostTurn = 1.3;
/// Beyond this number of pieces an arc's numbers have no pixels left: what is 10¹³ px large.
constexpr int kMostPieces = 1 << 14;
/// Arcs of more pieces are asked by eighths of a circle whether the window sees them at all.
constexpr int kLong = 16;
constexpr double kEighth = kCircle / 8.0;
/// A bow flatter than this share of the tolerance is drawn straight.
constexpr double kFlat = 0.25;

int pieces_for(double radius, double turn, double tolerance) {
  const double h = std::sqrt(std::sqrt(128.0 * 15.0 / 8.0 * tolerance / radius));
  const double n = std::ceil(std::abs(turn) / std::min(h, kMostTurn));
  return n > 1.0 ? static_cast<int>(std::min(n, double(kMostPieces))) : 1;
}

/// An arc in n pieces of the angle h each, beginning at center + u.
struct Turning {
  glm::dvec2 center, u, v;
  int n;
  double h, ch, sh;  ///< cosine and sine of h/2
  double out, ends;  ///< how far out control points and ends lie

  Turning(glm::dvec2 c, glm::dvec2 u_, glm::dvec2 v_, int n_, double turn)
      : center(c), u(u_), v(v_), n(n_), h(turn / n_), ch(std::cos(0.5 * h)), sh(std::sin(0.5 * h)) {
    const double excess = 0.5 * (ch + 1.0 / ch) - 1.0;
    ends = 1.0 - 8.0 / 15.0 * excess;
    out = ends / ch;
  }
  glm::dvec2 at(double radius, double c, double s) const {
    return center + (radius * c) * u + (radius * s) * v;
  }

  /// Pieces i to j; the arc's last one ends at `to`.
  void write(OutlineLoop& loop, int i, int j, glm::dvec2 to) const {
    double c = 1.0, s = 0.0;
    if (i > 0) c = std::cos(i * h), s = std::sin(i * h);
    for (; i < j; ++i) {
      const double mc = c * ch - s * sh, ms = c * sh + s * ch;
      c = mc * ch - ms * sh, s = mc * sh + ms * ch;
      loop.quad(at(out, mc, ms), i + 1 < n ? at(ends, c, s) : to);
    }
  }

  /// The same for many pieces: what the window does not see is passed by.
  void write_seen(OutlineLoop& loop, glm::dvec2 to) const {
    const int step = std::max(1, static_cast<int>(kEighth / std::abs(h)));
    for (int i = 0; i < n; i += step) {
      const int j = std::min(n, i + step);
      const double middle = 0.5 * (i + j) * h, wide = 1.01 / std::cos(0.5 * (j - i) * h);
      const glm::dvec2 end = j < n ? at(ends, std::cos(j * h), std::sin(j * h)) : to;
      const Box2 box = around(Box2{glm::min(loop.at(), end), glm::max(loop.at(), end)},
                              at(wide, std::cos(middle), std::sin(middle)));
      if (loop.beyond(box)) {
        loop.beyond_to(end);
      } else {
        write(loop, i, j, to);
      }
    }
  }
};

void write_turning(OutlineLoop& loop, const Turning& arc, glm::dvec2 to) {
  if (arc.n <= kLong) {
    arc.write(loop, 0, arc.n, to);
  } else {
    arc.write_seen(loop, to);
  }
}

}  // namespace

void write_ellipse(OutlineLoop& loop, glm::dvec2 center, glm::dvec2 u, glm::dvec2 v) {
  if (!(std::abs(cross(u, v)) > 0.0)) return;
  const glm::dvec2 half{norm({u.x, v.x}), norm({u.y, v.y})};
  if (loop.beyond({center - half, center + half})) return;
  // Conjugate half-axes anew: the first to the ellipse's rightmost point, where x turns anyway.
  const double c = u.x / half.x, s = v.x / half.x;
  glm::dvec2 right = c * u + s * v, across = c * v - s * u;
  across.x = 0.0;
  if (across.y < 0.0) across.y = -across.y;
  const int n = 4 * pieces_for(std::max(norm(u), norm(v)), 0.25 * kCircle, loop.tolerance());
  const Turning arc(center, right, across, n, kCircle);
  const glm::dvec2 start = arc.at(arc.ends, 1.0, 0.0);
  loop.begin(start);
  write_turning(loop, arc, start);
  loop.close();
}

void write_arc(OutlineLoop& loop, glm::dvec2 center, double radius, glm::dvec2 from, double turn,
               glm::dvec2 to) {
  if (loop.beyond({center - radius, center + radius})) return loop.beyond_to(to);
  if (std::abs(radius * turn * turn) <= 8.0 * kFlat * loop.tolerance()) return loop.line(to);
  const int n = pieces_for(radius, turn, loop.tolerance());
  write_turning(loop, Turning(center, radius * from, radius * turned(from), n, turn), to);
}

}  // namespace mien
