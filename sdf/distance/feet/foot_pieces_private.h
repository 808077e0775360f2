#pragma once
// What the scalar form of nearest_feet and its lanes share: pieces made ready, and how feet are ranked.

#include <mien/feet.h>

#include <vector>

namespace mien {

/// A piece of a list: B = p0 + t (a2 + t b), with the half-width w0 + t (w1 + t w2).
struct FootPiece {
  glm::dvec2 p0, p2, a2, b;
  double w0, w1, w2;
  double w_end;  ///< at t = 1, unrounded
  /// B' and w' at both ends; where both vanish, the way in which the piece sets out or arrives.
  glm::dvec2 way[2];
  double widening[2];
  int before = -1;     ///< the piece that this one continues
  bool ends = true;    ///< nothing continues it
  bool exists = true;  ///< a joint's point, or what has a NaN or infinite coordinate, does not
  /// Where t = 0 lies along the list: joined pieces share the places of their joints, and no others do.
  double start = 0.0;
  double wrap =
      0.0;  ///< of the last piece of a closed chain: how far along its end lies behind its beginning

  bool is_joined() const { return before >= 0 || !ends; }
  bool tapers() const { return w1 != 0.0 || w2 != 0.0; }
  double place(double t) const { return start + t - (t > 0.5 ? wrap : 0.0); }
};

std::vector<FootPiece> foot_pieces(std::span<const QuadBezier> curves);
std::vector<FootPiece> foot_pieces(std::span<const Line> lines);
std::vector<FootPiece> foot_pieces(std::span<const TaperedStroke> strokes);

/// Minima nearer than this along a piece are one: the barrier between them is about the fourth power of that. Beside a
/// joint they are, if the joint is no barrier: higher than the higher one by at most this of |q| and the piece's size.
inline constexpr double kOneFoot = 0x1p-20, kNoBarrier = 0x1p-50;

/// How the distance goes right beside the ends of a piece. Who asks decides, so that rounding loses no joint's foot
/// between two pieces.
struct FootEnds {
  bool rises_at_begin, falls_at_end;
};
FootEnds foot_ends(const FootPiece& piece, glm::dvec2 p);

/// Where the distance from p is least along a piece, ascending.
struct FootParameters {
  static constexpr int kMost = 6;
  int count = 0;
  double t[kMost];
  bool at_end[kMost];
};
/// `falls`: the distance falls towards t = 0 along the piece before, or there is none.
FootParameters foot_parameters(const FootPiece& piece, glm::dvec2 p, bool falls, FootEnds ends);

/// |p − B(t)| − w(t).
double foot_depth(const FootPiece& piece, glm::dvec2 p, double t);

Feet nearest_feet(std::span<const FootPiece> pieces, glm::dvec2 p);

/// What a foot within a curve says: q = B − p, B', B''/2, w', w''/2 there.
struct FootFigures {
  double r;     ///< |q|
  double hand;  ///< 1 to the right of the curve or on it, −1 to its left
  glm::dvec2 normal;
  double bend;
};
FootFigures foot_figures(glm::dvec2 q, glm::dvec2 speed, glm::dvec2 b, double w1, double w2);

/// The angle of (c, s), of length 1: atan(w) by its series, after two halvings that leave w at most tan(π/16). The C
/// library's is not the same everywhere.
struct AngleSeries {
  static constexpr int kTerms = 12;
};
double angle_of(double c, double s);

/// A piece made ready for many places: how it goes at knots, its vertex among them, and between two of them.
struct FootFrame {
  static constexpr int kMost = 24;
  struct Knot {
    double t, x, y;               ///< of B − p0
    double gx, gy, gg, widening;  ///< B', its square, w'
    double h, slow, fast;         ///< as far as the next knot: t, the least and the largest speed
    double least, widest;         ///< and |w'|
  };
  FootPiece piece;
  bool fits;            ///< sizes whose powers stay in range, and both ends set out
  double size;          ///< |a2| + |b|
  double bends, kinks;  ///< the most that f'' is, and what the width adds to it, times |q|
  Box2 box;             ///< of the control points
  double reach;         ///< the widest half-width, and some rounding
  glm::dvec2 out[2];    ///< unit, out of either end
  int cells;
  Knot knots[kMost + 1];
};
FootFrame foot_frame(const FootPiece& piece);

}  // namespace mien
