// One place at a time: each piece's minima, then the two lowest of all.

#include "lib/math/norm.h"
#include "lib/math/unit_zeros.h"
#include "sdf/distance/feet/foot_pieces_private.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// A piece seen from a place, at a scale at which powers of lengths stay in range.
struct SeenPiece {
  double scale = 1.0;  ///< lengths here are the piece's times this
  glm::dvec2 q0, q2, a2, b;
  double w0, w1, w2, w_end;

  SeenPiece(const FootPiece& c, glm::dvec2 p) : q0(c.p0 - p), q2(c.p2 - p) {
    const auto larger = [](glm::dvec2 v) { return larger_side(v); };
    const double size = std::max({larger(q0), larger(q2), larger(c.a2), larger(c.b), std::abs(c.w0),
                                  std::abs(c.w1), std::abs(c.w2)});
    if (size > 0.0 && !(size > 0x1p-200 && size < 0x1p200))
      scale = std::ldexp(1.0, -std::clamp(std::ilogb(size), -1000, 1000));
    q0 *= scale, q2 *= scale, a2 = scale * c.a2, b = scale * c.b;
    w0 = scale * c.w0, w1 = scale * c.w1, w2 = scale * c.w2, w_end = scale * c.w_end;
  }

  /// B − p, exact at both ends.
  glm::dvec2 at(double t) const { return t == 1.0 ? q2 : q0 + t * (a2 + t * b); }
  glm::dvec2 speed(double t) const { return a2 + 2.0 * t * b; }
  double width(double t) const { return t == 1.0 ? w_end : w0 + t * (w1 + t * w2); }
  double widening(double t) const { return w1 + 2.0 * t * w2; }

  /// f = |q| times the slope of |q| − w, and f'.
  ValueSlope slope(double t) const {
    const glm::dvec2 q = at(t), g = speed(t);
    const double along = glm::dot(q, g), rise = glm::dot(g, g) + 2.0 * glm::dot(q, b);
    if (w1 == 0.0 && w2 == 0.0) return {along, rise};
    const double r = norm(q), w = widening(t);
    return {along - w * r, rise - 2.0 * w2 * r - (r > 0.0 ? w * along / r : 0.0)};
  }
};

/// Finds every t at which f of a tapered piece rises through 0: stretches are halved until bounds say how f goes.
class RisingZeros {
 public:
  RisingZeros(const SeenPiece& seen, UnitZeros& to) : seen_(seen), to_(to) {}

  void search(double lo, double f_lo, double hi, double f_hi) {
    const bool falls_lo = !(f_lo > 0.0), falls_hi = !(f_hi > 0.0), rises = falls_lo && !falls_hi;
    const Going going = going_between(lo, f_lo, hi, f_hi);
    constexpr int kMostCells = 4000;
    constexpr double kShortest = 0x1p-40;
    const bool is_leaf = hi - lo < kShortest || ++cells_ > kMostCells;
    if (going == Going::up || (is_leaf && going == Going::unknown)) {
      if (rises && to_.count < int(to_.t.size())) {
        const auto f = [&](double t) { return seen_.slope(t); };
        to_.t[to_.count++] = f_lo < 0.0 ? unit_zero_between(f, lo, hi, f_lo, f_hi) : lo;
      }
      return;
    }
    if (going != Going::unknown) return;
    const double mid = 0.5 * (lo + hi), f_mid = seen_.slope(mid).value;
    search(lo, f_lo, mid, f_mid), search(mid, f_mid, hi, f_hi);
  }

 private:
  enum class Going { up, down, nowhere_zero, unknown };

  /// f'' is at most 3 |B'||B''| + 2 |w''||B'| + |w'| (|B'|²/|q| + |B''|).
  Going going_between(double lo, double f_lo, double hi, double f_hi) const {
    const double h = hi - lo, bb = glm::dot(seen_.b, seen_.b);
    const double turn = bb > 0.0 ? -0.5 * glm::dot(seen_.a2, seen_.b) / bb : lo;
    const double slow = norm(seen_.speed(std::clamp(turn, lo, hi)));
    const double fast = std::max(norm(seen_.speed(lo)), norm(seen_.speed(hi)));
    const double v_lo = seen_.widening(lo), v_hi = seen_.widening(hi);
    const double widest = std::max(std::abs(v_lo), std::abs(v_hi));
    const double least = v_lo * v_hi > 0.0 ? std::min(std::abs(v_lo), std::abs(v_hi)) : 0.0;
    const double bend = 2.0 * std::sqrt(bb), widens = 2.0 * std::abs(seen_.w2);
    const double r = norm(seen_.at(lo)) + norm(seen_.at(hi));
    const double r_least = 0.5 * (r - fast * h), r_most = 0.5 * (r + fast * h);
    if (slow * slow > r_most * (bend + widens) + widest * fast) return Going::up;
    const bool alike = (f_lo > 0.0) == (f_hi > 0.0);
    if (alike && least > fast) return Going::nowhere_zero;  // the width outruns the spine
    if (!(r_least > 0.0)) return Going::unknown;
    const double most =
        3.0 * fast * bend + 2.0 * widens * fast + widest * (fast * fast / r_least + bend);
    const double s_lo = seen_.slope(lo).slope, s_hi = seen_.slope(hi).slope;
    if (s_lo + s_hi > most * h) return Going::up;
    if (-s_lo - s_hi > most * h) return Going::down;
    const double away = std::min(std::abs(f_lo), std::abs(f_hi));
    return alike && away > 0.125 * most * h * h ? Going::nowhere_zero : Going::unknown;
  }

  const SeenPiece& seen_;
  UnitZeros& to_;
  int cells_ = 0;
};

/// Newton's method from a zero that is nearly one, as long as it comes nearer: beside a centre of curvature f' is small,
/// beside the spine of a stroke |q| turns within |q| / |B'|.
double settled(const SeenPiece& seen, double t) {
  ValueSlope at = seen.slope(t);
  for (int i = 0; i < 20; ++i) {
    const double next = std::clamp(t - at.value / at.slope, 0.0, 1.0);
    const ValueSlope then = seen.slope(next);
    if (!(std::abs(then.value) < std::abs(at.value))) break;
    t = next, at = then;
  }
  return t;
}

/// The sign of the distance's slope right beside an end.
double slope_at_end(const FootPiece& c, const SeenPiece& seen, int end) {
  const glm::dvec2 q = end ? seen.q2 : seen.q0;
  return seen.scale * (glm::dot(q, c.way[end]) - c.widening[end] * norm(q));
}

/// A foot and what it is ranked by: |q| − w, its place along the list, and how low a joint beside it is no barrier.
struct RankedFoot {
  double key = std::numeric_limits<double>::infinity(), place = -1e300;
  Foot foot;
  double joint = key;
};

RankedFoot foot_at(const FootPiece& c, const SeenPiece& seen, int index, double t, bool at_end) {
  const glm::dvec2 q = seen.at(t);
  const FootFigures figures = foot_figures(q, seen.speed(t), seen.b, seen.widening(t), seen.w2);
  RankedFoot found{(figures.r - seen.width(t)) / seen.scale, c.place(t), {index, t}};
  Foot& foot = found.foot;
  foot.distance = found.key, foot.normal = figures.normal + 0.0;  // no −0
  foot.bend = (at_end ? 1.0 / figures.r : figures.bend) * seen.scale;
  if (c.is_joined()) {
    const glm::dvec2 end = t > 0.5 ? seen.q2 : seen.q0;
    const double width = t > 0.5 ? seen.w_end : seen.w0, away = norm(end);
    const double size = away + (norm(seen.a2) + norm(seen.b));
    found.joint = (away - width - kNoBarrier * size) / seen.scale;
  }
  if (!at_end) return found;
  const glm::dvec2 out = (t == 0.0 ? -1.0 : 1.0) * c.way[t != 0.0];
  const double length = norm(out);
  if (figures.r > 0.0)
    foot.normal = -q / figures.r;
  else
    foot.normal = length > 0.0 ? out / length : glm::dvec2{1.0, 0.0};
  foot.normal += 0.0;
  return found;
}

bool are_one(const RankedFoot& now, const RankedFoot& best) {
  if (!(std::abs(now.place - best.place) < kOneFoot)) return false;
  const bool at_joint = std::abs(now.foot.t - best.foot.t) > 0.5;
  return !at_joint || !(std::max(now.key, best.key) < now.joint);
}

void rank(const RankedFoot& now, RankedFoot& best, RankedFoot& next) {
  if (are_one(now, best)) {
    if (now.key < best.key) best = now;
  } else if (now.key < best.key) {
    next = best, best = now;
  } else if (now.key < next.key) {
    next = now;
  }
}

template <class Figure, class Piece>
std::vector<FootPiece> chained(std::span<const Figure> figures, Piece piece_of) {
  std::vector<FootPiece> pieces;
  pieces.reserve(figures.size());
  int first = -1, last = -1;  // of the chain so far
  double place = 0.0;
  const auto is_point = [](const FootPiece& c) {
    return c.a2 == glm::dvec2{0.0} && c.b == glm::dvec2{0.0} && !c.tapers();
  };
  const auto meets = [&](int a, const FootPiece& c) {
    return pieces[a].p2 == c.p0 && pieces[a].w_end == c.w0;
  };
  const auto close = [&] {
    if (first < 0 || is_point(pieces[first]) || !meets(last, pieces[first])) return;
    pieces[first].before = last, pieces[last].ends = false;
    pieces[last].wrap = pieces[last].start + 1.0 - pieces[first].start;
  };
  for (const Figure& figure : figures) {
    FootPiece c = piece_of(figure);
    const int now = int(pieces.size());
    const double sum =
        c.p0.x + c.p0.y + c.p2.x + c.p2.y + c.a2.x + c.a2.y + c.b.x + c.b.y + (c.w0 + c.w1 + c.w2);
    c.exists = std::isfinite(sum);
    if (c.exists && last >= 0 && meets(last, c)) {
      c.exists = !is_point(c);
      if (c.exists) place += 1.0;
      if (c.exists && is_point(pieces[last]))
        pieces[last].exists = false, first = now;
      else if (c.exists)
        c.before = last, pieces[last].ends = false;
    } else if (c.exists) {
      close();
      first = now, place += 2.0;
    }
    c.start = place;
    pieces.push_back(c);
    if (c.exists) last = now;
  }
  close();
  return pieces;
}

void set_ways(FootPiece& c) {
  for (const int end : {0, 1}) {
    c.way[end] = c.a2 + 2.0 * end * c.b, c.widening[end] = c.w1 + 2.0 * end * c.w2;
    if (c.way[end] != glm::dvec2{0.0} || c.widening[end] != 0.0) continue;
    const double sign = end ? -1.0 : 1.0;
    c.way[end] = sign * c.b, c.widening[end] = sign * c.w2;
  }
}

FootPiece piece_along(const QuadBezier& c, double w0, double w1, double w2) {
  const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
  const double wa = w1 - w0;
  FootPiece piece{c.p0, c.p2, 2.0 * a, b, w0, 2.0 * wa, (w2 - w1) - wa, w2};
  return set_ways(piece), piece;
}

}  // namespace

std::vector<FootPiece> foot_pieces(std::span<const QuadBezier> curves) {
  return chained(curves, [](const QuadBezier& c) { return piece_along(c, 0.0, 0.0, 0.0); });
}
std::vector<FootPiece> foot_pieces(std::span<const Line> lines) {
  return chained(lines, [](const Line& line) {
    FootPiece piece{line.a, line.b, line.b - line.a, glm::dvec2{0.0}, line.half_width,
                    0.0,    0.0,    line.half_width};
    return set_ways(piece), piece;
  });
}
std::vector<FootPiece> foot_pieces(std::span<const TaperedStroke> strokes) {
  return chained(strokes, [](const TaperedStroke& s) {
    return piece_along(s.spine, s.half_width[0], s.half_width[1], s.half_width[2]);
  });
}

FootFigures foot_figures(glm::dvec2 q, glm::dvec2 g, glm::dvec2 b, double w1, double w2) {
  const double r = norm(q), speed = norm(g);
  FootFigures found{r, 1.0, {1.0, 0.0}, 0.0};
  double across = 0.0;  // √(B'² − w'²)
  if (speed > 0.0) {
    // n · B' = −w': right on the curve, too, where the way to the foot is all rounding.
    const glm::dvec2 along = g / speed, right{along.y, -along.x};
    const double lean = -w1 / speed, rest = std::sqrt(std::max(0.0, (1.0 - lean) * (1.0 + lean)));
    found.hand = glm::dot(q, right) > 0.0 ? -1.0 : 1.0;
    found.normal = lean * along + found.hand * rest * right, across = speed * rest;
  }
  if (r > across) found.normal = -q / r;
  const double m = 2.0 * (glm::dot(found.normal, b) + w2);
  const double steep = std::max((speed - w1) * (speed + w1) - r * m, 1e-300);
  if (m != 0.0) found.bend = -m / steep;
  return found;
}

double angle_of(double c, double s) {
  const double x = std::abs(c), y = std::abs(s);
  const double u = std::min(x, y) / std::max(x, y);
  const double v = u / (1.0 + std::sqrt(1.0 + u * u)), w = v / (1.0 + std::sqrt(1.0 + v * v));
  double series = 0.0;
  for (int i = AngleSeries::kTerms - 1; i >= 0; --i) series = 1.0 / (2 * i + 1) - w * w * series;
  constexpr double kPi = 3.14159265358979323846;
  double angle = 4.0 * w * series;
  if (y > x) angle = 0.5 * kPi - angle;
  if (c < 0.0) angle = kPi - angle;
  return std::copysign(angle, s);
}

FootEnds foot_ends(const FootPiece& piece, glm::dvec2 p) {
  const SeenPiece seen(piece, p);
  return {slope_at_end(piece, seen, 0) > 0.0, !(slope_at_end(piece, seen, 1) > 0.0)};
}

FootParameters foot_parameters(const FootPiece& piece, glm::dvec2 p, bool falls, FootEnds ends) {
  const SeenPiece seen(piece, p);
  FootParameters found;
  const auto depth = [&](double t) { return norm(seen.at(t)) - seen.width(t); };
  const auto add = [&](double t, bool at_end) {
    int& n = found.count;
    const bool is_known = n > 0 && std::abs(t - found.t[n - 1]) < kOneFoot;
    if (is_known && !(depth(t) < depth(found.t[n - 1]))) return;
    n += !is_known;
    found.at_end[n - 1] = at_end, found.t[n - 1] = t;
  };
  const double begin = slope_at_end(piece, seen, 0), end = slope_at_end(piece, seen, 1);
  if (falls && ends.rises_at_begin) add(0.0, true);
  if (!ends.rises_at_begin && begin > 0.0) add(0.0, false);
  UnitZeros zeros;
  if (piece.tapers()) {
    const double at_once = seen.slope(0.0).value;
    const double first = at_once != 0.0 ? at_once : begin > 0.0 ? 1e-300 : -1e-300;
    RisingZeros(seen, zeros).search(0.0, first, 1.0, end);
  } else {
    const double c1 = 0.5 * glm::dot(seen.a2, seen.a2) + glm::dot(seen.q0, seen.b);
    const auto half_slope = [&](double t) {
      const ValueSlope full = seen.slope(t);
      return ValueSlope{0.5 * full.value, 0.5 * full.slope};
    };
    zeros = unit_zeros<Zeros::rising>(glm::dot(seen.b, seen.b), 1.5 * glm::dot(seen.a2, seen.b), c1,
                                      half_slope);
    if (falls && begin == 0.0 && seen.slope(0.0).slope > 0.0) add(0.0, false);
  }
  for (int i = 0; i < zeros.count; ++i) {
    const double t = settled(seen, zeros.t[i]);
    // Right at an end it is for the ends to say.
    if (!(t <= 0.0 && ends.rises_at_begin) && !(t >= 1.0 && ends.falls_at_end)) add(t, false);
  }
  if (!ends.falls_at_end && !(end > 0.0)) add(1.0, false);
  if (ends.falls_at_end && piece.ends) add(1.0, true);
  return found;
}

double foot_depth(const FootPiece& piece, glm::dvec2 p, double t) {
  const SeenPiece seen(piece, p);
  return (norm(seen.at(t)) - seen.width(t)) / seen.scale;
}

Feet nearest_feet(std::span<const FootPiece> pieces, glm::dvec2 p) {
  if (!(std::isfinite(p.x) && std::isfinite(p.y))) return {};
  RankedFoot best, next;
  bool falls = true;  // at the end of the piece before
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const FootPiece& c = pieces[i];
    if (!c.exists) continue;
    const SeenPiece seen(c, p);
    if (c.before >= int(i)) falls = foot_ends(pieces[c.before], p).falls_at_end;
    const FootEnds ends = foot_ends(c, p);
    const FootParameters at = foot_parameters(c, p, falls || c.before < 0, ends);
    for (int k = 0; k < at.count; ++k)
      rank(foot_at(c, seen, int(i), at.t[k], at.at_end[k]), best, next);
    falls = ends.falls_at_end;
  }
  return {best.foot, next.foot};
}

Feet nearest_feet(std::span<const QuadBezier> curves, glm::dvec2 p) {
  return nearest_feet(foot_pieces(curves), p);
}
Feet nearest_feet(std::span<const Line> lines, glm::dvec2 p) {
  return nearest_feet(foot_pieces(lines), p);
}
Feet nearest_feet(std::span<const TaperedStroke> strokes, glm::dvec2 p) {
  return nearest_feet(foot_pieces(strokes), p);
}

}  // namespace mien
