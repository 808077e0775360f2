#include "rim_private.h"

#include "sdf/outline/curve/cross_private.h"

#include "lib/math/norm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Halvings: a rim as wide as 10⁹ px needs ten to reach its tolerance; cusps and round tips need two for each
/// factor of four.
constexpr int kRimHalvings = 64;
/// Pieces of one rim. A rim that needs more is drawn as well as these can.
constexpr int kMostRimPieces = 2048;
/// By how much the error of a piece may exceed its estimate, which leaves out how it changes along the piece.
constexpr double kReserve = 1.1;
/// Tangents meet not nearer to an end than this share of the chord, or the bend changes.
constexpr double kLeastLeg = 0.15;

/// c0 + s (2 c1 + s c2), and its size between two s: not less, 0 or less where it may vanish, and not more.
struct Bow {
  double c0, c1, c2;

  double at(double s) const { return c0 + s * (2.0 * c1 + s * c2); }
  double sag(double s, double u) const { return 0.25 * (u - s) * (u - s) * std::abs(c2); }
  double least(double s, double u) const {
    const double p = at(s), q = at(u);
    return p * q > 0.0 ? std::min(std::abs(p), std::abs(q)) - sag(s, u) : 0.0;
  }
  double most(double s, double u) const {
    return std::max(std::abs(at(s)), std::abs(at(u))) + sag(s, u);
  }
};

/// A straight spine may begin or end with no speed; its direction is that of the rest.
glm::dvec2 direction_at(const Pen& pen, double t) {
  const glm::dvec2 v = pen.velocity(t);
  return v == glm::dvec2(0.0) ? pen.velocity(0.5) : v;
}

/// `ahead` is |B'|.
Rim rim_with(const Pen& pen, double toward, double t, glm::dvec2 normal, double ahead) {
  const double width = pen.width(t), rate = pen.rate(t);
  return {t, pen.center(t) + width * normal, normal, -toward * turned(normal),
          (ahead - rate) * (ahead + rate) - 2.0 * width * (glm::dot(normal, pen.b) + pen.wb)};
}

/// x above `from` where a growing function is y, all but.
template <class F>
double where(const F& f, double y, double from) {
  double lo = from, hi = 1.0;
  for (int i = 0; i < 8; ++i) (f(0.5 * (lo + hi)) < y ? lo : hi) = 0.5 * (lo + hi);
  return 0.5 * (lo + hi);
}

class RimWriter {
 public:
  RimWriter(OutlineLoop& loop, const Pen& pen, double toward)
      : loop_(loop), pen_(pen), toward_(toward) {
    const Box2 box = pen.box();
    seen_ = loop.window().contains(box.lo) && loop.window().contains(box.hi);
  }

  /// Cut where x or y turns, which the normal tells at once.
  void write(const Rim& a, const Rim& b) {
    std::array<Rim, 4> turns;
    int count = 0;
    for (const glm::dvec2 normal : {glm::dvec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
      const double t = place_of(normal);
      if (!((t - a.t) * (t - b.t) < 0.0 && toward_ * cross(pen_.velocity(t), normal) > 0.0))
        continue;
      int i = count++;
      for (; i > 0 && (t - a.t) * (t - turns[i - 1].t) < 0.0; --i) turns[i] = turns[i - 1];
      turns[i] = rim_with(pen_, toward_, t, normal, norm(pen_.velocity(t)));
    }
    const Rim* from = &a;
    for (int i = 0; i < count; from = &turns[i++]) write(*from, turns[i], kRimHalvings);
    write(*from, b, kRimHalvings);
  }

 private:
  /// In as many pieces as the estimate asks for, at equal shares of it. Where that is more than a few, or no number,
  /// each part is asked again.
  void write(const Rim& a, const Rim& b, int halvings) {
    constexpr int kMost = 32, kParts = 8;
    // As flat as an arc of one piece.
    const glm::dvec2 chord = b.point - a.point, turn = b.way - a.way;
    const double turned2 = glm::dot(turn, turn), arc = 128.0 * loop_.tolerance();
    if (glm::dot(chord, chord) * (turned2 * turned2 * turned2) <= arc * arc)
      return fit(a, b, halvings);
    // Pieces wanted up to x: a parabola for their density through three places.
    const double dt = b.t - a.t, f0 = density(a), f2 = density(b),
                 f1 = density(rim_at(pen_, toward_, a.t + 0.5 * dt));
    const double c1 = 4.0 * f1 - 3.0 * f0 - f2, c2 = 2.0 * (f0 - 2.0 * f1 + f2);
    const double scale = std::abs(dt) * std::sqrt(std::sqrt(kReserve / loop_.tolerance()));
    const auto wanted = [&](double x) { return scale * x * (f0 + x * (c1 / 2.0 + x * c2 / 3.0)); };
    const double all = wanted(1.0);
    if (!(all > 1.0 && std::max(f0, f2) < 8.0 * f1)) return fit(a, b, halvings);
    const int n = all < kMost ? int(all) + 1 : kParts;
    Rim from = a;
    double x = 0.0;
    for (int i = 1; i <= n; ++i) {
      x = i < n ? where(wanted, all * i / n, x) : 1.0;
      const Rim to = i < n ? rim_at(pen_, toward_, a.t + x * dt) : b;
      if (all < kMost || !halvings)
        fit(from, to, halvings);
      else if (loop_.beyond(pen_.part(from.t, to.t).box()))
        loop_.beyond_to(to.point);
      else
        write(from, to, halvings - 1);
      from = to;
    }
  }

  /// One piece, or halves until they are near enough.
  void fit(const Rim& a, const Rim& b, int halvings) {
    const Pen part = pen_.part(a.t, b.t);
    if (!seen_ && loop_.beyond(part.box())) return loop_.beyond_to(b.point);
    glm::dvec2 control;
    if (joined(a, b, control) &&
        deviation(part, a, b, control, loop_.tolerance()) <= loop_.tolerance())
      return emit(control, b.point);
    const double squared = (b.t - a.t) * (b.t - a.t), t = middle(a, b);
    if (halvings == 0 || pieces_ > kMostRimPieces || !std::isfinite(b.speed) || t == a.t ||
        t == b.t || longest(part, a.speed * squared, b.speed * squared) <= 2.0 * loop_.tolerance())
      return emit(0.5 * (a.point + b.point), b.point);
    const Rim m = rim_at(pen_, toward_, t);
    write(a, m, halvings - 1);
    write(m, b, halvings - 1);
  }

  void emit(glm::dvec2 control, glm::dvec2 to) {
    ++pieces_;
    loop_.quad(control, to);
  }

  /// Where the normal is this one: the rim's tangent lines touch the discs at one t each.
  double place_of(glm::dvec2 normal) const {
    return -(glm::dot(pen_.a, normal) + pen_.wa) / (glm::dot(pen_.b, normal) + pen_.wb);
  }

  /// The fourth root of the error of a piece of the length dt, by dt.
  double density(const Rim& r) const {
    const double bend = glm::dot(pen_.b, r.normal) + pen_.wb, along = glm::dot(pen_.b, r.way);
    const double ahead = glm::dot(pen_.velocity(r.t), r.way), rate = pen_.rate(r.t);
    const double one = rate * bend - along * ahead, two = one - along * ahead;
    const double squared = ahead * ahead;
    const double all = r.speed * r.speed * bend * bend + 4.0 * squared * one * one -
                       r.speed * (two * two + squared * bend * (bend - 2.0 * pen_.wb));
    return std::sqrt(std::sqrt(std::abs(bend * all / (16.0 * r.speed))) / squared);
  }

  /// Where the rims' tangents meet; false where that is not between them.
  static bool joined(const Rim& a, const Rim& b, glm::dvec2& control) {
    const glm::dvec2 chord = b.point - a.point;
    const double length = norm(chord), turn = cross(a.way, b.way);
    const double lead = cross(chord, b.way), trail = cross(a.way, chord);
    control = 0.5 * (a.point + b.point);
    constexpr double kParallel = 1e-9;
    if (std::abs(turn) < kParallel && std::abs(trail) <= kParallel * length) return true;
    const double ahead = lead / turn, back = trail / turn;
    control = a.point + ahead * a.way;
    return glm::dot(a.way, b.way) > -kParallel && ahead * back > 0.0 &&
           std::min(std::abs(ahead), std::abs(back)) > kLeastLeg * length;
  }

  /// An upper bound of a rim's length between a and b, cusps included; the speeds are those of `q`.
  static double longest(const Pen& q, double speed0, double speed1) {
    const glm::dvec2 v0 = q.velocity(0.0), v1 = q.velocity(1.0);
    const double r0 = q.rate(0.0), r1 = q.rate(1.0);
    const double slowest = std::min(
        {glm::dot(v0, v0) - r0 * r0, glm::dot(v0, v1) - r0 * r1, glm::dot(v1, v1) - r1 * r1});
    if (!(slowest > 0.0)) return std::numeric_limits<double>::infinity();
    const double pull = 2.0 * norm(q.b), swell = 2.0 * std::abs(q.wb), ahead = std::sqrt(slowest);
    const double change =
        2.0 * (std::max(norm(v0), norm(v1)) * pull + std::max(std::abs(r0), std::abs(r1)) * swell) +
        (std::max(std::abs(r0), std::abs(r1)) + q.widest() * pull / ahead) * (pull + swell);
    return (std::max(std::abs(speed0), std::abs(speed1)) + 0.5 * change) / ahead;
  }

  /// A bound of |min over t of |Q(s) − B(t)| − w(t)| along the piece. Infinite where the second
  /// derivative along t may vanish: at a cusp. A bound up to `enough` may be better.
  static double deviation(const Pen& q, const Rim& begin, const Rim& end, glm::dvec2 control,
                          double enough) {
    // Q − B = d + s (2da + s db).
    const glm::dvec2 d = begin.point - q.p, da = (control - begin.point) - q.a;
    const glm::dvec2 db = ((end.point - control) - (control - begin.point)) - q.b;
    const double c = glm::dot(db, db) - q.wb * q.wb;
    // A quarter of the derivative: s (1 − s) (h1 − s h3).
    const double h1 = glm::dot(d, q.b) + 2.0 * glm::dot(da, q.a) + q.w * q.wb + 2.0 * q.wa * q.wa;
    const double h3 = glm::dot(db, q.b) + q.wb * q.wb;
    const double h = std::max(std::abs(h1), std::abs(h1 - h3));
    // Half the second derivative, and by how much it changes: at the ends it is the rim's speed.
    const double ab = glm::dot(q.a, q.b) - q.wa * q.wb, bb = glm::dot(q.b, q.b) - q.wb * q.wb;
    const double dt = end.t - begin.t, k0 = dt * dt * begin.speed, kk = 4.0 * bb - 2.0 * h3;
    const Bow k{k0, 0.5 * (dt * dt * end.speed - k0 - kk), kk};
    const double change = 12.0 * std::max(std::abs(ab), std::abs(ab + bb));
    const double least = k.least(0.0, 1.0);
    // All the way to the foot half of it is kept.
    const double kept = 1.0 - (change + 6.0 * std::abs(bb) * h / least) * h / (least * least);
    if (!(least > 0.0 && kept >= 0.5)) return std::numeric_limits<double>::infinity();
    // At the foot φ is s² (1 − s)² times m/k, and what its third and fourth derivatives add.
    const double way = h / (least * kept),
                 added = (2.0 / 3.0 * change + std::abs(bb) * way) * way * way * way;
    const Bow m{c * k.c0 - 4.0 * h1 * h1, c * k.c1 + 4.0 * h1 * h3, c * k.c2 - 4.0 * h3 * h3};
    const Bow width{q.w, q.wa, q.wb};
    const double mid = 2.0 * (q.w + q.wa), last = q.w + 2.0 * q.wa + q.wb;
    /// With s (1 − s) <= reach from u to v, and where that is an end s² (1 − s)²/w <= by_rise.
    const auto bound = [&](double u, double v, double reach, double by_rise) {
      const double phi = m.most(u, v) / std::max(k.least(u, v), least) + added,
                   w = std::max(width.least(u, v), 0.0);
      const double x = phi * std::min(reach * reach / w, by_rise);
      const double left = x < w ? std::sqrt(1.0 - x / w) : 0.0;
      return std::min(x / (1.0 + left), reach * std::sqrt(phi));
    };
    const double whole = bound(0.0, 1.0, 0.25, HUGE_VAL);
    if (whole <= enough) return whole;
    const auto rise = [&](double w) { return 9.0 / 64.0 / std::max(std::min(mid, w), 0.0); };
    return std::max({bound(0.0, 0.25, 3.0 / 16.0, rise(last)), bound(0.25, 0.5, 0.25, HUGE_VAL),
                     bound(0.5, 0.75, 0.25, HUGE_VAL), bound(0.75, 1.0, 3.0 / 16.0, rise(q.w))});
  }

  /// Where to halve: at a cusp, or half-way round.
  double middle(const Rim& a, const Rim& b) const {
    if (a.speed * b.speed < 0.0)
      if (const double t = cusp(a.speed, a.t, b.t); (t - a.t) * (t - b.t) < 0.0) return t;
    constexpr double kShare = 1.0 / 16.0;
    const double share = (place_of(glm::normalize(a.normal + b.normal)) - a.t) / (b.t - a.t);
    return a.t + (share > 0.0 && share < 1.0 ? std::clamp(share, kShare, 1.0 - kShare) : 0.5) *
                     (b.t - a.t);
  }

  /// Where the speed changes its sign.
  double cusp(double speed0, double t0, double t1) const {
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i) {
      const double t = 0.5 * (t0 + t1);
      if (t == t0 || t == t1) break;
      ((rim_at(pen_, toward_, t).speed > 0.0) == (speed0 > 0.0) ? t0 : t1) = t;
    }
    return 0.5 * (t0 + t1);
  }

  OutlineLoop& loop_;
  const Pen& pen_;
  double toward_;
  bool seen_;  ///< all of it is in the window
  int pieces_ = 0;
};

}  // namespace

double lean_at(const Pen& pen, double t) {
  return std::clamp(pen.rate(t) / norm(direction_at(pen, t)), -1.0, 1.0);
}

Rim rim_at(const Pen& pen, double toward, double t) {
  const glm::dvec2 v = direction_at(pen, t);
  const double speed = norm(v), lean = std::clamp(pen.rate(t) / speed, -1.0, 1.0);
  const double across = toward * std::sqrt((1.0 - lean) * (1.0 + lean));
  return rim_with(pen, toward, t, (across * turned(v) - lean * v) / speed, speed);
}

void write_rim(OutlineLoop& loop, const Pen& pen, double toward, const Rim& from, const Rim& to) {
  RimWriter(loop, pen, toward).write(from, to);
}

}  // namespace mien
