#include "sdf/distance/grid/grid_tile.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien::batch {

/// The curve relative to a point, at t: residual q = B − p, half the velocity u, and half the slope of
/// |q|² with two derivatives.
struct TileCertifier::At {
  glm::dvec2 q, u;
  double f, f1, f2;
};

TileCertifier::TileCertifier(const QuadBezierFrame<double>& frame) : f_(frame) {
  const glm::dvec2 a(0.5 * frame.ax2, 0.5 * frame.ay2), b(frame.bx, frame.by);
  const double bb = glm::dot(b, b);
  const double turn = bb > 0 ? std::clamp(-glm::dot(a, b) / bb, 0.0, 1.0) : 0.0;
  c_ = {a, b, bb, std::sqrt(bb), turn, std::hypot(f_.px, f_.py), std::hypot(f_.sx, f_.sy)};
}

TileCertifier::At TileCertifier::at(glm::dvec2 d, double t) const {
  const glm::dvec2 u = c_.a + t * c_.b, q = d + t * (c_.a + u);
  return {q, u, glm::dot(q, u), 2 * glm::dot(u, u) + glm::dot(q, c_.b), 6 * glm::dot(u, c_.b)};
}

/// Whether |B(t) − p|² is convex on [0, 1] for every p of the tile. Its second derivative is a parabola
/// in t, least where |B'| is, and changes by |b| per unit of p.
bool TileCertifier::convex(glm::dvec2 d, double reach) const {
  return at(d, c_.turn).f1 > reach * c_.b_length;
}

/// Whether S2 keeps its sign: then the nearest point of the whole parabola is, for every p of the tile,
/// the only root on that side of the vertex.
bool TileCertifier::one_sided(glm::dvec2 d, double reach) const {
  if (f_.straight) return false;
  const double x = d.x * f_.sx, y = d.y * f_.sy, s = x + y + f_.s1;
  const double rounding = 0x1p-40 * (std::abs(x) + std::abs(y) + std::abs(f_.s1));
  return std::abs(s) > reach * c_.s_change + rounding;
}

/// That root for the middle: descends from a bound above it.
double TileCertifier::main_root(glm::dvec2 d) const {
  const double s = d.x * f_.sx + d.y * f_.sy + f_.s1, p = this->p(d);
  double x = std::sqrt(std::max(0.0, -3 * p)) + std::cbrt(std::abs(s));
  for (int i = 0; i < 30; ++i) {
    const double step = ((x * x + 3 * p) * x - std::abs(s)) / (3 * (x * x + p));
    if (!(step > 0x1p-12 * x)) break;
    x -= step;
  }
  return std::copysign(x, s) - f_.vertex;
}

double TileCertifier::p(glm::dvec2 d) const {
  return d.x * f_.px + d.y * f_.py + f_.p1;
}

/// Newton's method from t to where f = 0; false if it does not get there.
bool TileCertifier::settle(glm::dvec2 d, double& t) const {
  for (int i = 0; i < 5; ++i) {
    const At now = at(d, t);
    if (!(now.f1 > 0)) return false;
    const double step = now.f / now.f1;
    t -= step;
    if (std::abs(step) <= 0x1p-14)
      return true;  // Newton squares that; the remainder is bounded later
  }
  return false;
}

/// Bounds for all p of the tile and all t within `span` of a root for the middle. Span 0: even around the root
/// itself nothing could be bounded.
struct TileCertifier::Branch {
  At at;
  double t, span, f1, f2, u;
  bool inside() const { return span > 0 && t - span >= 0 && t + span <= 1; }
  bool beyond() const { return span > 0 && (t + span < 0 || t - span > 1); }
};

TileCertifier::Branch TileCertifier::branch(glm::dvec2 d, double reach, double t) const {
  Branch b{at(d, t), t, 0, 0, 0, 0};
  if (!(b.at.f1 > 0)) return b;
  const double u_length = glm::length(b.at.u);
  const double span = 1.5 * reach * u_length / b.at.f1 + 0x1p-18;
  b.u = u_length + span * c_.b_length;
  b.f2 = std::abs(b.at.f2) + 6 * c_.bb * span;
  b.f1 = b.at.f1 - span * b.f2 - reach * c_.b_length;
  if (b.f1 > 0 && reach * b.u / b.f1 <= span) b.span = span;
  return b;
}

/// How many steps of Newton's method follow the branch over the tile.
GridTile TileCertifier::followed(const Branch& b, double reach) const {
  GridTile tile;
  // The foot's derivatives along a line through the tile.
  const double inverse = 1 / b.f1;
  const double t1 = b.u * inverse, t2 = (2 * c_.b_length + b.f2 * t1) * t1 * inverse;
  const double t3 = (3 * (c_.b_length + b.f2 * t1) * t2 + 6 * c_.bb * t1 * t1 * t1) * inverse;
  const double own =
      std::abs(b.at.f) * inverse + 0x1p-22;  // of t, and of the start's float rounding
  const double start = t3 * reach * reach * reach / 6 + own;
  if (!(t1 * reach + start <= b.span)) return tile;
  const double bent = 0.5 * b.f2 * inverse, one = bent * start * start, two = bent * one * one;
  if (!(2 * b.u * two <= kTolerance)) return tile;
  const double middle = 1 / b.at.f1, uneven = (b.at.f1 - b.f1) * middle;  // at most, of the slope
  const double series = one + 2 * uneven * uneven * uneven * start;
  using How = GridTile::How;
  tile.how = uneven < 0.25 && 2 * b.u * series <= kTolerance && b.inside() ? How::multiplied
             : 2 * b.u * one <= kTolerance                                 ? How::one_step
                                                                           : How::two_steps;
  tile.t = b.t;
  tile.inverse = 0.5 * middle;
  // t + w + w (z − k w), w = u·e / f1, z = b·e / f1, k = f2 / (2 f1).
  const double k = 0.5 * b.at.f2 * middle;
  tile.wx = b.at.u.x * middle, tile.wy = b.at.u.y * middle;
  tile.zx = c_.b.x * middle - k * tile.wx, tile.zy = c_.b.y * middle - k * tile.wy;
  return tile;
}

/// The main root lies beyond an end for all p. If it is the only root for all of them, that end is nearest. If
/// there are three roots for all of them, the opposite outer one competes with it, and whichever is nearer by more
/// than the tile's width stays nearer.
GridTile TileCertifier::beyond_an_end(glm::dvec2 d, double reach, const Branch& main) const {
  const double x = std::abs(main.t + f_.vertex), end = main.t > 1 ? 1 : 0;
  const double p = this->p(d), change = reach * c_.p_change + 0x1p-40 * std::abs(p);
  const double least = x - main.span, most = x + main.span;
  const GridTile at_end{GridTile::How::end, end};
  if (least > 0 && 4 * (p - change) > -least * least) return at_end;
  if (!(-4 * (p + change) > most * most)) return {};
  const double other_x = 0.5 * x + std::sqrt(std::max(0.0, -3 * p - 0.75 * x * x));
  double other = std::copysign(other_x, -(main.t + f_.vertex)) - f_.vertex;
  const double end_distance = glm::length(at(d, end).q);
  const double other_distance = glm::length(at(d, std::clamp(other, 0.0, 1.0)).q);
  if (end_distance + 2.001 * reach < other_distance) return at_end;
  if (!(other_distance + 2.001 * reach < end_distance) || !settle(d, other)) return {};
  const Branch b = branch(d, reach, other);
  if (b.beyond()) return {GridTile::How::end, 1 - end};
  return b.inside() ? followed(b, reach) : GridTile{};
}

GridTile TileCertifier::certify(glm::dvec2 middle, double reach) {
  const glm::dvec2 d = offset_to(middle);
  const GridTile tile = nearest_branch(d, middle, reach);
  if (tile.how == GridTile::How::uncertain) return tile;
  const glm::dvec2 q = at(d, tile.t).q;
  const bool is_close = reach < kClose && glm::dot(q, q) < (kClose - reach) * (kClose - reach);
  return is_close ? tile : GridTile{};
}

glm::dvec2 TileCertifier::offset_to(glm::dvec2 p) const {
  return glm::dvec2(f_.x0 + f_.x0_low, f_.y0 + f_.y0_low) - p;
}

GridTile TileCertifier::nearest_branch(glm::dvec2 d, glm::dvec2 middle, double reach) {
  const bool is_convex = convex(d, reach);
  if (is_convex) {
    const At begin = at(d, 0), end = at(d, 1);
    const bool to_begin = begin.f > reach * glm::length(begin.u);
    if (to_begin || end.f < -reach * glm::length(end.u)) {
      return {GridTile::How::end, to_begin ? 0.0 : 1.0};
    }
  }
  const bool sided = one_sided(d, reach);
  if (!is_convex && !sided) return {};
  const double side = d.x * f_.sx + d.y * f_.sy + f_.s1;
  const auto right = [&](double t) { return is_convex || (t + f_.vertex > 0) == (side > 0); };
  double t = last_t_ + glm::dot(last_w_, middle - last_middle_);
  if (!settle(d, t) || !right(t)) {
    t = sided ? main_root(d) : c_.turn;
    if (!settle(d, t) || !right(t)) return {};
  }
  const Branch main = branch(d, reach, t);
  last_t_ = t, last_middle_ = middle, last_w_ = (1 / main.at.f1) * main.at.u;
  // Convex on [0, 1] and around the root, and these stretches touch: f rises on both.
  const bool touches = main.span > 0 && main.t + main.span >= 0 && main.t - main.span <= 1;
  if (main.inside() || (is_convex && touches)) return followed(main, reach);
  return sided && main.beyond() ? beyond_an_end(d, reach, main) : GridTile{};
}

}  // namespace mien::batch
