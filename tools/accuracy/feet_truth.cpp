// The true feet, in binary128, by the roots of polynomials.

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/accuracy/feet.h"
#include "tools/accuracy/roots.h"

namespace mien::accuracy {
namespace {

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0);
  for (size_t i = 0; i < a.size(); ++i)
    for (size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}
Polynomial plus(Polynomial a, const Polynomial& b, Quad factor = 1) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
  return a;
}
Polynomial slope_of(const Polynomial& p) {
  Polynomial d;
  for (size_t i = 1; i < p.size(); ++i) d.push_back(p[i] * Quad(double(i)));
  return d;
}

/// A stretch of an outline, seen from the place: (x, y) / over is the way there, w the half-width.
struct Stretch {
  int piece;
  Polynomial x, y, over, w;
  Quad lo, hi;
  Quad (*t_of)(Quad);  ///< the figure's parameter

  struct Figures {
    Quad qx, qy, gx, gy, r, w, w1;
  };
  Figures at(Quad t) const {
    const Quad o = value(over, t), o1 = over.size() > 1 ? value(slope_of(over), t) : Quad(0);
    const Quad vx = value(x, t), vy = value(y, t);
    const Quad gx = (value(slope_of(x), t) * o - vx * o1) / (o * o);
    const Quad gy = (value(slope_of(y), t) * o - vy * o1) / (o * o);
    const Quad qx = vx / o, qy = vy / o;
    return {qx,
            qy,
            gx,
            gy,
            square_root(qx * qx + qy * qy),
            value(w, t),
            w.size() > 1 ? value(slope_of(w), t) : Quad(0)};
  }
  Quad key(Quad t) const {
    const Figures f = at(t);
    return f.r - f.w;
  }
  /// |q| times the slope of the key.
  Quad slope(Quad t) const {
    const Figures f = at(t);
    return f.qx * f.gx + f.qy * f.gy - f.w1 * f.r;
  }
  /// Where the slope changes its sign between a and b: the polynomial's coefficients lose what is close to the spine.
  Quad sign_change(Quad a, Quad b) const {
    const bool rises = slope(b) > 0;
    for (int i = 0; i < 120; ++i) {
      const Quad middle = (a + b) / 2;
      ((slope(middle) > 0) == rises ? b : a) = middle;
    }
    return (a + b) / 2;
  }
  /// Every t within at which the slope may change its sign.
  std::vector<Quad> turns() const {
    // Along a rational curve the slope's numerator: (x over − …) leaves one factor.
    const Polynomial dx = plus(times(slope_of(x), over), times(x, slope_of(over)), -1);
    const Polynomial dy = plus(times(slope_of(y), over), times(y, slope_of(over)), -1);
    const Polynomial along = plus(times(x, dx), times(y, dy));
    if (w.size() < 2 || (w[1] == 0 && (w.size() < 3 || w[2] == 0)))
      return sign_changes(along, lo, hi);
    const Polynomial w1 = slope_of(w), square = plus(times(x, x), times(y, y));
    std::vector<Quad> all =
        sign_changes(plus(times(along, along), times(times(w1, w1), square), -1), lo, hi);
    // Close to the spine those vanish in rounding: its own foot is there, too. And a grid, to be sure.
    for (const Quad t : sign_changes(along, lo, hi)) all.push_back(t);
    for (int i = 1; i < 64; ++i) all.push_back(lo + (hi - lo) * Quad(i / 64.0));
    std::sort(all.begin(), all.end());
    return all;
  }
};

Quad same(Quad t) {
  return t;
}

Polynomial quadratic(double p0, double p1, double p2, double from) {
  return {Quad(p0) - from, 2 * (Quad(p1) - p0), Quad(p0) - 2 * Quad(p1) + p2};
}

Stretch stretch_of(const QuadBezier& c, Polynomial w, int piece, glm::dvec2 p) {
  return {piece,
          quadratic(c.p0.x, c.p1.x, c.p2.x, p.x),
          quadratic(c.p0.y, c.p1.y, c.p2.y, p.y),
          {1, 0},
          std::move(w),
          0,
          1,
          same};
}
Stretch stretch_of(const QuadBezier& c, int piece, glm::dvec2 p) {
  return stretch_of(c, {0}, piece, p);
}
Stretch stretch_of(const Line& l, int piece, glm::dvec2 p) {
  return {piece,
          {Quad(l.a.x) - p.x, Quad(l.b.x) - l.a.x},
          {Quad(l.a.y) - p.y, Quad(l.b.y) - l.a.y},
          {1, 0},
          {l.half_width},
          0,
          1,
          same};
}
Stretch stretch_of(const TaperedStroke& s, int piece, glm::dvec2 p) {
  const double* w = s.half_width;
  return stretch_of(s.spine, quadratic(w[0], w[1], w[2], 0), piece, p);
}

struct Joint {
  glm::dvec2 at;
  double w;
  friend bool operator==(const Joint&, const Joint&) = default;
};
std::array<Joint, 2> ends_of(const QuadBezier& c) {
  return {{{c.p0, 0}, {c.p2, 0}}};
}
std::array<Joint, 2> ends_of(const Line& l) {
  return {{{l.a, l.half_width}, {l.b, l.half_width}}};
}
std::array<Joint, 2> ends_of(const TaperedStroke& s) {
  return {{{s.spine.p0, s.half_width[0]}, {s.spine.p2, s.half_width[2]}}};
}

/// Stretches one after the other, as far as they are joined.
struct Chain {
  std::vector<Stretch> stretches;
  bool is_closed = false;
};

template <class Figure>
std::vector<Chain> chains_of(const std::vector<Figure>& figures, glm::dvec2 p) {
  std::vector<Chain> chains;
  Joint begin{}, end{};
  for (size_t i = 0; i < figures.size(); ++i) {
    const auto ends = ends_of(figures[i]);
    if (chains.empty() || !(ends[0] == end)) {
      chains.push_back({}), begin = ends[0];
    }
    chains.back().stretches.push_back(stretch_of(figures[i], int(i), p));
    end = ends[1], chains.back().is_closed = end == begin;
  }
  return chains;
}

Quad right_angle(Quad u) {
  return std::atan(double(u)) * 2;
}
Quad left_angle(Quad u) {
  const double angle = std::atan(double(u)) * 2;
  return angle > 0 ? angle - std::acos(-1.0) : angle + std::acos(-1.0);
}

/// Two halves, by the tangent of half the angle.
std::vector<Chain> chains_of(const Ellipse& e, glm::dvec2 p) {
  const Quad ax = e.axis.x, ay = e.axis.y, n = square_root(ax * ax + ay * ay);
  const Quad dx = Quad(p.x) - e.center.x, dy = Quad(p.y) - e.center.y;
  const Quad x = (dx * ax + dy * ay) / n, y = (dy * ax - dx * ay) / n;
  const Quad a = e.radii.x, b = e.radii.y;
  const Polynomial over{1, 0, 1};
  Chain round{{}, true};
  round.stretches.push_back(
      {0, plus({a, 0, -a}, over, -x), plus({0, 2 * b}, over, -y), over, {0}, -1, 1, right_angle});
  round.stretches.push_back(
      {0, plus({-a, 0, a}, over, -x), plus({0, -2 * b}, over, -y), over, {0}, -1, 1, left_angle});
  return {round};
}

std::vector<Chain> chains_of(const FeetCase& k) {
  return std::visit([&](const auto& figure) { return chains_of(figure, k.p); }, k.figure);
}

/// A minimum or a maximum of the key along a chain.
struct Turn {
  size_t stretch;
  Quad t, key;
  bool is_end, is_least;
};

/// Where the sign of the slope changes, from stretch to stretch. Between two of its zeros it is that of the middle.
std::vector<Turn> turns_of(const Chain& chain) {
  struct Interval {
    size_t stretch;
    Quad lo;
    int sign;
  };
  std::vector<Interval> all;
  for (size_t i = 0; i < chain.stretches.size(); ++i) {
    const Stretch& s = chain.stretches[i];
    std::vector<Quad> at = s.turns();
    at.insert(at.begin(), s.lo), at.push_back(s.hi);
    Quad middle = s.lo;
    for (size_t j = 0; j + 1 < at.size(); ++j) {
      if (!(at[j + 1] > at[j])) continue;
      const Quad before = middle;
      middle = (at[j] + at[j + 1]) / 2;
      const Quad f = s.slope(middle);
      const bool turns =
          !all.empty() && all.back().stretch == i && (all.back().sign > 0) != (f > 0);
      if (f != 0) all.push_back({i, turns ? s.sign_change(before, middle) : at[j], f > 0 ? 1 : -1});
    }
  }
  std::vector<Turn> turns;
  int before = chain.is_closed && !all.empty() ? all.back().sign : -1;
  for (const Interval& one : all) {
    const Stretch& s = chain.stretches[one.stretch];
    if (one.sign != before)
      turns.push_back({one.stretch, one.lo, s.key(one.lo), one.lo == s.lo, one.sign > 0});
    before = one.sign;
  }
  const Stretch& last = chain.stretches.back();
  if (all.empty() || (!chain.is_closed && before < 0))
    turns.push_back({chain.stretches.size() - 1, last.hi, last.key(last.hi), true, true});
  return turns;
}

/// How far a minimum's neighbours rise above it; beyond an open end everything does.
Quad barrier_at(const std::vector<Turn>& turns, size_t i, bool is_closed) {
  const auto rise = [&](int step) -> Quad {
    for (size_t n = 1; n < turns.size(); ++n) {
      const long at = long(i) + step * long(n), size = long(turns.size());
      if (!is_closed && (at < 0 || at >= size)) break;
      const Turn& turn = turns[size_t(((at % size) + size) % size)];
      if (!turn.is_least) return turn.key - turns[i].key;
    }
    return Quad(0x1p1000L);
  };
  return std::min(rise(-1), rise(1));
}

TrueFoot foot_of(const Chain& chain, const Turn& turn, const FeetFigure& figure, bool is_inside) {
  const Stretch& s = chain.stretches[turn.stretch];
  const Stretch::Figures f = s.at(turn.t);
  const Quad g2 = f.gx * f.gx + f.gy * f.gy, g = square_root(g2);
  const double sign = is_inside ? -1 : 1;
  const Quad lean = -f.w1 / g, rest = square_root(1 - lean * lean);
  TrueFoot found{{s.piece, double(s.t_of(turn.t)), sign * double(turn.key)},
                 turn.key,
                 0,
                 0,
                 0,
                 double(f.r),
                 double(g * rest),
                 0,
                 {}};
  // On the curve itself the way there is no direction.
  const bool is_left = f.qx * f.gy - f.qy * f.gx > 0,
             is_on = f.r <= Quad(0x1p-60L) * g && !turn.is_end;
  const Quad side = is_left ? -rest : rest;
  Quad nx = -f.qx / f.r, ny = -f.qy / f.r;
  if (is_on || f.r == 0) nx = (lean * f.gx + side * f.gy) / g, ny = (lean * f.gy - side * f.gx) / g;
  const bool is_ellipse = std::holds_alternative<Ellipse>(figure);
  // The bend by how the slope grows: see docs/derivations/feet.md.
  const Quad h = Quad(0x1p-30L);
  const auto speed = [&](Quad t) { return s.at(t); };
  const Stretch::Figures up = speed(turn.t + h), down = speed(turn.t - h);
  const Quad bx = (up.gx - down.gx) / (2 * h), by = (up.gy - down.gy) / (2 * h),
             wb = (up.w1 - down.w1) / (2 * h);
  const Quad m = nx * bx + ny * by + wb, steep = g2 - f.w1 * f.w1 - f.r * m;
  found.foot.bend = sign * (turn.is_end && !is_ellipse ? double(1 / f.r)
                            : m == 0                   ? 0
                                                       : double(-m / steep));
  found.foot.normal = {sign * double(nx), sign * double(ny)};
  const Quad flip = 2 * (nx * f.gy - ny * f.gx) / g2;
  found.mirrored = {sign * double(nx - flip * f.gy), sign * double(ny + flip * f.gx)};
  found.x = f.qx, found.y = f.qy;
  const auto apart = [&](Quad t) {
    const Stretch::Figures end = s.at(t);
    return double(
        square_root((end.qx - f.qx) * (end.qx - f.qx) + (end.qy - f.qy) * (end.qy - f.qy)));
  };
  found.from_end = is_ellipse ? 1e300 : std::min(apart(s.lo), apart(s.hi));
  if (const auto* e = std::get_if<Ellipse>(&figure))
    for (glm::dvec2* n : {&found.foot.normal, &found.mirrored})
      *n = n->x * e->axis + n->y * glm::dvec2(-e->axis.y, e->axis.x);
  return found;
}

bool is_inside(const FeetFigure& figure, glm::dvec2 p) {
  const auto* e = std::get_if<Ellipse>(&figure);
  if (!e) return false;
  const Quad dx = Quad(p.x) - e->center.x, dy = Quad(p.y) - e->center.y, ax = e->axis.x,
             ay = e->axis.y;
  const Quad x = (dx * ax + dy * ay) * e->radii.y, y = (dy * ax - dx * ay) * e->radii.x;
  const Quad ab = Quad(e->radii.x) * e->radii.y;
  return x * x + y * y < ab * ab * (ax * ax + ay * ay);
}

/// The way from p to the outline at a figure's own parameter, its derivative and the slope.
Stretch::Figures figures_at(const FeetCase& k, int piece, double t) {
  if (std::holds_alternative<Ellipse>(k.figure)) {
    const auto round = chains_of(k).front();
    const bool is_right = std::abs(t) <= std::acos(0.0);
    const double half = (is_right ? t : t > 0 ? t - std::acos(-1.0) : t + std::acos(-1.0)) / 2;
    return round.stretches[is_right ? 0 : 1].at(Quad(std::tan(half)));
  }
  for (const Chain& chain : chains_of(k))
    for (const Stretch& s : chain.stretches)
      if (s.piece == piece) return s.at(Quad(t));
  return {};
}

}  // namespace

std::vector<TrueFoot> true_feet(const FeetCase& k) {
  std::vector<TrueFoot> feet;
  const bool inside = is_inside(k.figure, k.p);
  for (const Chain& chain : chains_of(k)) {
    const std::vector<Turn> turns = turns_of(chain);
    for (size_t i = 0; i < turns.size(); ++i) {
      if (!turns[i].is_least) continue;
      TrueFoot foot = foot_of(chain, turns[i], k.figure, inside);
      foot.barrier = barrier_at(turns, i, chain.is_closed);
      feet.push_back(foot);
    }
  }
  std::stable_sort(feet.begin(), feet.end(),
                   [](const TrueFoot& a, const TrueFoot& b) { return a.key < b.key; });
  return feet;
}

bool is_nearly_foot(const FeetCase& k, int piece, double t, double by) {
  const Stretch::Figures f = figures_at(k, piece, t);
  const Quad slope = magnitude(f.qx * f.gx + f.qy * f.gy - f.w1 * f.r);
  const Quad speed = square_root(f.gx * f.gx + f.gy * f.gy) + magnitude(f.w1);
  return slope <= Quad(by) * speed;
}

double apart_from(const FeetCase& k, int piece, double t, const TrueFoot& foot) {
  const Stretch::Figures f = figures_at(k, piece, t);
  const Quad dx = f.qx - foot.x, dy = f.qy - foot.y;
  return double(square_root(dx * dx + dy * dy));
}

}  // namespace mien::accuracy
