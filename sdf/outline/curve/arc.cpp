#include "arc_private.h"
#include "cross_private.h"

#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mien {
namespace {

constexpr double kCircle = 6.283185307179586;
/// [rad] The most a piece turns, however coarse the tolerance.
constexpr double kMostTurn = 1.3;
/// An arc of more pieces than this would be 10¹³ px large, where coordinates no longer resolve a pixel.
constexpr int kMostPieces = 1 << 14;
/// For arcs of more pieces the window is asked first, by eighths of a circle, whether it sees them at all.
constexpr int kLong = 64;
constexpr double kEighth = kCircle / 8.0;
/// A bow flatter than this share of the tolerance is drawn straight.
constexpr double kFlat = 0.25;

/// (c + 1/c)/2 − 1, c = cos x.
double excess(double x) {
  const double c = std::cos(x);
  return 0.5 * (1.0 - c) * (1.0 - c) / c;
}

/// The error of balanced pieces, as a share of the excess, at their ends. Beside a given end it is a little more,
/// found by trying places along it.
constexpr double kShare = 8.0 / 15.0, kShareByEnds = 0.56;

/// `share` of the excess: the largest error of a piece.
int pieces_for(double radius, double turn, double tolerance, double share) {
  const double most = tolerance / (share * radius);
  const double h = std::min(std::sqrt(std::sqrt(128.0 * most)), kMostTurn);
  double n = std::ceil(std::abs(turn) / h);
  if (h > 0.5 && excess(0.5 * turn / n) > most) n += 1.0;  // beyond the leading term
  return n > 1.0 ? static_cast<int>(std::min(n, double(kMostPieces))) : 1;
}

/// An arc in n pieces of the angle h each, beginning at center + u. Ends that are given cannot be drawn in, so the
/// control points beside them make up for it.
struct Turning {
  glm::dvec2 center, u, v;
  int n;
  double h, ch, sh;  ///< cosine and sine of h/2
  double pull;       ///< by which share ends are drawn in
  int fixed;         ///< given ends: 0 or 2

  Turning(glm::dvec2 c, glm::dvec2 u_, glm::dvec2 v_, int n_, double turn, int fixed_)
      : center(c), u(u_), v(v_), n(n_), h(turn / n_), fixed(fixed_) {
    ch = std::cos(0.5 * h), sh = std::sin(0.5 * h);
    pull = kShare * excess(0.5 * h);
  }
  glm::dvec2 at(double radius, double c, double s) const {
    return center + (radius * c) * u + (radius * s) * v;
  }
  glm::dvec2 end(double c, double s) const { return at(1.0 - pull, c, s); }
  /// How far out the i-th control point lies. The mean of a piece's excess less p at its ends and q
  /// at its control point is 0 where (p0 + p1 + q)/3 is 8/15 of the excess.
  double out(int i) const {
    const int given = fixed == 0 ? 0 : (i == 0) + (i == n - 1);
    return (1.0 - (1 + given) * pull) / ch;
  }

  /// Pieces i to j; the arc's last one ends at `to`.
  void write(CurvePen& pen, int i, int j, glm::dvec2 to) const {
    double c = 1.0, s = 0.0;
    if (i > 0) c = std::cos(i * h), s = std::sin(i * h);
    for (; i < j; ++i) {
      const double mc = c * ch - s * sh, ms = c * sh + s * ch;
      c = mc * ch - ms * sh, s = mc * sh + ms * ch;
      pen.quad(at(out(i), mc, ms), i + 1 < n ? end(c, s) : to);
    }
  }

  /// The same for many pieces; those that the window does not see are skipped.
  void write_seen(CurvePen& pen, glm::dvec2 to) const {
    const int step = std::max(1, static_cast<int>(kEighth / std::abs(h)));
    for (int i = 0; i < n; i += step) {
      const int j = std::min(n, i + step);
      const double middle = 0.5 * (i + j) * h, wide = 1.01 / std::cos(0.5 * (j - i) * h);
      const glm::dvec2 stop = j < n ? end(std::cos(j * h), std::sin(j * h)) : to;
      const Box2 box = around(Box2{glm::min(pen.at(), stop), glm::max(pen.at(), stop)},
                              at(wide, std::cos(middle), std::sin(middle)));
      if (pen.beyond(box)) {
        pen.beyond_to(stop);
      } else {
        write(pen, i, j, to);
      }
    }
  }
};

/// A whole turn by quarters; those beyond a side of the window are skipped.
void write_quarters(CurvePen& pen, const Turning& arc) {
  constexpr double kAround = 1.01;  // of an ellipse, to hold its pieces
  const int quarter = arc.n / 4;
  glm::dvec2 u = arc.u, v = arc.v;
  for (int i = 0; i < arc.n; i += quarter, u = std::exchange(v, -u)) {
    const glm::dvec2 a = kAround * u, b = kAround * v, corner = a + b;
    const Box2 box{arc.center + glm::min(glm::min(a, b), corner),
                   arc.center + glm::max(glm::max(a, b), corner)};
    const glm::dvec2 stop = arc.center + (1.0 - arc.pull) * v;
    if (pen.beyond(box))
      pen.beyond_to(stop);
    else
      arc.write(pen, i, i + quarter, stop);
  }
}

void write_turning(CurvePen& pen, const Turning& arc, glm::dvec2 to) {
  if (arc.n <= kLong) {
    arc.write(pen, 0, arc.n, to);
  } else {
    arc.write_seen(pen, to);
  }
}

}  // namespace

void write_ellipse(CurvePen& pen, glm::dvec2 center, glm::dvec2 u, glm::dvec2 v) {
  if (!(std::abs(cross(u, v)) > 0.0)) return;
  const glm::dvec2 half{norm({u.x, v.x}), norm({u.y, v.y})};
  if (pen.beyond({center - half, center + half})) return;
  // New conjugate half-axes: the first to the ellipse's rightmost point, where x turns anyway.
  const double c = u.x / half.x, s = v.x / half.x;
  glm::dvec2 right = c * u + s * v, across = c * v - s * u;
  across.x = 0.0;
  if (across.y < 0.0) across.y = -across.y;
  const int n = 4 * pieces_for(std::max(norm(u), norm(v)), 0.25 * kCircle, pen.tolerance(), kShare);
  const Turning arc(center, right, across, n, kCircle, 0);
  const glm::dvec2 start = arc.end(1.0, 0.0);
  pen.begin(start);
  if (n <= kLong)
    write_quarters(pen, arc);
  else
    arc.write_seen(pen, start);
  pen.close();
}

void write_arc(CurvePen& pen, glm::dvec2 center, double radius, glm::dvec2 from, double turn,
               glm::dvec2 to) {
  if (pen.beyond({center - radius, center + radius})) return pen.beyond_to(to);
  if (std::abs(radius * turn * turn) <= 8.0 * kFlat * pen.tolerance()) return pen.line(to);
  const int n = pieces_for(radius, turn, pen.tolerance(), kShareByEnds);
  write_turning(pen, Turning(center, radius * from, radius * turned(from), n, turn, 2), to);
}

}  // namespace mien
