#include "rim_private.h"

#include "sdf/outline/curve/cross_private.h"

#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// Halvings: a rim as wide as 10⁹ px needs ten to reach its tolerance; cusps and round tips need two for each
/// factor of four.
constexpr int kRimHalvings = 64;
/// Pieces of one rim. A rim that needs more is drawn as well as these can.
constexpr int kMostRimPieces = 2048;
/// The sine of the most that a piece turns.
constexpr double kMostRimTurn = 0.9;
/// Tangents meet not nearer to an end than this share of the chord, or the bend changes.
constexpr double kLeastLeg = 0.15;

/// s² (1 − s)² / q(s) is at most this, q > 0 on (0, 1) in Bernstein form. From q >= min(q0, q1, q2),
/// q >= s min(2q1, q2), q >= (1 − s) min(q0, 2q1), q >= 2 s (1 − s) q1.
double most_over(double q0, double q1, double q2) {
  if (!(std::min({q0, q1, q2}) >= 0.0)) return std::numeric_limits<double>::infinity();
  const double floor = std::max({16.0 * std::min({q0, q1, q2}), 6.75 * std::min(2.0 * q1, q2),
                                 6.75 * std::min(q0, 2.0 * q1), 8.0 * q1});
  return 1.0 / floor;
}

class RimWriter {
 public:
  RimWriter(OutlineLoop& loop, const Pen& pen, double toward)
      : loop_(loop), pen_(pen), toward_(toward) {}

  void write(const Rim& a, const Rim& b, double t0, double t1, int halvings) {
    const Pen part = pen_.part(t0, t1);
    if (loop_.beyond(part.box())) return loop_.beyond_to(b.point);
    glm::dvec2 control;
    double error = std::numeric_limits<double>::infinity();
    if (joined(a, b, control)) {
      error = deviation(part, a, b, control);
      if (error <= loop_.tolerance()) return emit(control, b.point);
    }
    if (halvings == 0 || pieces_ > kMostRimPieces || !std::isfinite(b.speed))
      return emit(0.5 * (a.point + b.point), b.point);
    if (std::isfinite(error)) return write_parts(a, b, t0, t1, error, halvings - 1);
    const double squared = (t1 - t0) * (t1 - t0);
    if (longest(part, a.speed * squared, b.speed * squared) <= 2.0 * loop_.tolerance())
      return emit(0.5 * (a.point + b.point), b.point);
    const double t = middle(a, b, t0, t1);
    if (t == t0 || t == t1) return emit(0.5 * (a.point + b.point), b.point);
    const Rim m = rim_at(pen_, toward_, t);
    write(a, m, t0, t, halvings - 1);
    write(m, b, t, t1, halvings - 1);
  }

 private:
  void emit(glm::dvec2 control, glm::dvec2 to) {
    ++pieces_;
    loop_.quad(control, to);
  }

  /// As many parts as the error asks for: it falls with the fourth power of their length.
  void write_parts(const Rim& a, const Rim& b, double t0, double t1, double error, int halvings) {
    constexpr double kMost = 8.0, kReserve = 1.1;
    const double wanted = std::sqrt(std::sqrt(kReserve * error / loop_.tolerance()));
    const int n = static_cast<int>(std::min(std::ceil(wanted), kMost));
    Rim from = a;
    for (int i = 0; i < n; ++i) {
      const double u = t0 + (i * (t1 - t0)) / n;
      const double v = i + 1 < n ? t0 + ((i + 1) * (t1 - t0)) / n : t1;
      const Rim to = i + 1 < n ? rim_at(pen_, toward_, v) : b;
      write(from, to, u, v, halvings);
      from = to;
    }
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
    return std::abs(turn) < kMostRimTurn && glm::dot(a.way, b.way) > 0.0 && ahead * back > 0.0 &&
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
  /// derivative along t may vanish: at a cusp.
  static double deviation(const Pen& q, const Rim& begin, const Rim& end, glm::dvec2 control) {
    // Q − B = d + s (2da + s db).
    const glm::dvec2 d = begin.point - q.p, da = (control - begin.point) - q.a;
    const glm::dvec2 db = ((end.point - control) - (control - begin.point)) - q.b;
    const double c = glm::dot(db, db) - q.wb * q.wb;
    // A quarter of the derivative: s (1 − s) (h1 − s h3).
    const double h1 = glm::dot(d, q.b) + 2.0 * glm::dot(da, q.a) + q.w * q.wb + 2.0 * q.wa * q.wa;
    const double h3 = glm::dot(db, q.b) + q.wb * q.wb;
    const double h = std::max(std::abs(h1), std::abs(h1 - h3));
    // Half the second derivative, in Bernstein form.
    const auto second = [&](double s) {
      const glm::dvec2 v = q.velocity(s), off = d + s * (2.0 * da + s * db);
      const double rate = q.rate(s);
      return glm::dot(v, v) - rate * rate - 2.0 * glm::dot(off, q.b) - 2.0 * q.width(s) * q.wb;
    };
    const double k0 = second(0.0), k2 = second(1.0), middle = second(0.5);
    const double k1 = 2.0 * middle - 0.5 * (k0 + k2);
    const double least = std::max(std::min({k0, k1, k2}), -std::max({k0, k1, k2}));
    if (!(least > 0.0)) return std::numeric_limits<double>::infinity();
    const auto third = [&](double s) {
      return 3.0 * std::abs(glm::dot(q.velocity(s), 2.0 * q.b) - q.rate(s) * 2.0 * q.wb);
    };
    // On the way to the foot the second derivative keeps half its size, and more where that lies on the piece.
    double kept = 1.0 - h * std::max(third(0.0), third(1.0)) / (least * least);
    if (!(kept >= 0.5)) return std::numeric_limits<double>::infinity();
    if (h > 0.25 * least) kept = 0.5;
    const double foot = std::copysign(4.0 * h * h / (least * kept), k0),
                 most = std::max(std::abs(c), std::abs(c - foot));
    // w − sqrt(w² − x w) = x / (1 + sqrt(1 − x/w)): of x, the most, about half where w is larger.
    const double w0 = q.w, w1 = q.w + q.wa, w2 = q.w + 2.0 * q.wa + q.wb;
    const double by_width = most * most_over(w0, w1, w2), narrowest = std::min({w0, w1, w2});
    const double left = by_width < narrowest ? std::sqrt(1.0 - by_width / narrowest) : 0.0;
    return std::min(by_width / (1.0 + left), 0.25 * std::sqrt(most));
  }

  /// Where to halve: in the middle of a large turn, at a cusp, or of t.
  double middle(const Rim& a, const Rim& b, double t0, double t1) const {
    const double half = 0.5 * (t0 + t1);
    const auto between = [&](double t) { return (t - t0) * (t - t1) < 0.0; };
    if (a.speed * b.speed < 0.0) {
      const double t = cusp(a.speed, t0, t1);
      if (between(t)) return t;
    }
    constexpr double kLarge = 0.75;  // cosine
    glm::dvec2 u = pen_.velocity(t0), v = pen_.velocity(t1);
    if (glm::dot(u, v) < kLarge * norm(u) * norm(v)) {
      u = glm::normalize(u), v = glm::normalize(v);
      const glm::dvec2 way = glm::dot(u, v) > -0.5 ? u + v : turned(u - v);
      const double t = -cross(pen_.a, way) / cross(pen_.b, way);
      if (between(t)) return t;
    }
    // A round tip, where |w'| comes up to |B'|: the rim runs with the square root of t there.
    const double e0 = upright(t0), e1 = upright(t1);
    if (e0 < 0.05 * e1) return 0.75 * t0 + 0.25 * t1;
    if (e1 < 0.05 * e0) return 0.25 * t0 + 0.75 * t1;
    return half;
  }

  double upright(double t) const {
    const glm::dvec2 v = pen_.velocity(t);
    const double rate = pen_.rate(t), squared = glm::dot(v, v);
    return std::max(0.0, squared - rate * rate) / squared;
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
  int pieces_ = 0;
};

}  // namespace

namespace {

/// A straight spine may begin or end with no speed; its direction is that of the rest.
glm::dvec2 direction_at(const Pen& pen, double t) {
  const glm::dvec2 v = pen.velocity(t);
  return v == glm::dvec2(0.0) ? pen.velocity(0.5) : v;
}

}  // namespace

double lean_at(const Pen& pen, double t) {
  return std::clamp(pen.rate(t) / norm(direction_at(pen, t)), -1.0, 1.0);
}

Rim rim_at(const Pen& pen, double toward, double t) {
  const glm::dvec2 v = direction_at(pen, t);
  const double width = pen.width(t), rate = pen.rate(t), speed = norm(v), lean = lean_at(pen, t);
  const glm::dvec2 ahead = v / speed;
  Rim rim;
  rim.normal = toward * std::sqrt((1.0 - lean) * (1.0 + lean)) * turned(ahead) - lean * ahead;
  rim.way = -toward * turned(rim.normal);
  rim.point = pen.center(t) + width * rim.normal;
  rim.speed =
      (speed - rate) * (speed + rate) - 2.0 * width * (glm::dot(rim.normal, pen.b) + pen.wb);
  return rim;
}

void write_rim(OutlineLoop& loop, const Pen& pen, double toward, double t0, double t1) {
  RimWriter(loop, pen, toward)
      .write(rim_at(pen, toward, t0), rim_at(pen, toward, t1), t0, t1, kRimHalvings);
}

}  // namespace mien
