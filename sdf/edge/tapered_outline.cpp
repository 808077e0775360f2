// The sides of a stroke of varying width, fitted by quadratic curves.

#include <mien/sdf/edge/outline_form.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// A point of one side: E(t) = B + w n with n·B' = −w', n left of the spine or right of it.
struct Rim {
  glm::dvec2 point, normal;
  glm::dvec2 way;  ///< unit, across the normal, along the spine
  double speed;    ///< |E'|, signed along `way`
  bool regular;    ///< discs do not swallow their neighbours, and the rim runs forward
};

class Side {
 public:
  Side(const TaperedStroke& s, double offset, double toward) : s_(s), toward_(toward) {
    const double* w = s.half_width;
    w0_ = w[0] + offset, wa_ = w[1] - w[0], wb_ = (w[2] - w[1]) - wa_;
  }

  Rim at(double t) const {
    const glm::dvec2 velocity = tangent(s_.spine, t), pull = bend(s_.spine);
    const double width = w0_ + t * (2.0 * wa_ + t * wb_), rate = 2.0 * (wa_ + t * wb_);
    const double speed = glm::length(velocity), lean = rate / speed;
    const glm::dvec2 ahead = velocity / speed, left{-ahead.y, ahead.x};
    const double upright = std::sqrt(1.0 - lean * lean);
    Rim rim;
    rim.normal = toward_ * upright * left - lean * ahead;
    rim.way = {toward_ * rim.normal.y, -toward_ * rim.normal.x};
    rim.point = point(s_.spine, t) + width * rim.normal;
    // n turns by omega = −(n·B'' + w'')/q per t, q = way·B' (see tapered_edges.cpp).
    const double q = glm::dot(rim.way, velocity);
    const double omega = -(glm::dot(rim.normal, pull) + 2.0 * wb_) / q;
    rim.speed = q + width * omega;
    constexpr double kLeast = 0.02;  // of the speed along the spine: short of a cusp
    rim.regular = std::abs(lean) < 0.98 && width >= 0.0 && rim.speed > kLeast * speed;
    return rim;
  }

 private:
  const TaperedStroke& s_;
  double toward_, w0_, wa_, wb_;
};

/// The curve from rim a to rim b that has their tangents. False if those do not meet in between.
bool joined(const Rim& a, const Rim& b, QuadBezier& quad) {
  const glm::dvec2 chord = b.point - a.point;
  const double length = glm::length(chord);
  if (!(length > 0.0)) return false;
  const auto cross = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; };
  const double turn = cross(a.way, b.way), lead = cross(chord, b.way), trail = cross(a.way, chord);
  constexpr double kStraight = 1e-9;
  if (std::abs(turn) < kStraight && std::abs(trail) < kStraight * length) {
    quad = {a.point, 0.5 * (a.point + b.point), b.point};
    return glm::dot(a.way, chord) > 0.0;
  }
  constexpr double kMostTurn = 0.9;  // sine
  const double ahead = lead / turn, back = trail / turn;
  // Tangents that meet at one end rather than in the middle: a change of bend.
  if (!(std::abs(turn) < kMostTurn) || !(ahead > 0.2 * length) || !(back > 0.2 * length))
    return false;
  quad = {a.point, a.point + ahead * a.way, b.point};
  return true;
}

/// How far the fit is from the rim, at three of its points, by the rim's points abreast of them.
bool fits(const Side& side, const QuadBezier& quad, double t0, double t1, double tolerance) {
  for (const double s : {0.25, 0.5, 0.75}) {
    const glm::dvec2 p = point(quad, s), way = glm::normalize(tangent(quad, s));
    double t = t0 + s * (t1 - t0);
    Rim rim = side.at(t);
    constexpr int kSteps = 3;
    for (int step = 0; step < kSteps; ++step) {
      if (!rim.regular) return false;
      t += glm::dot(p - rim.point, way) / (rim.speed * std::max(0.5, glm::dot(rim.way, way)));
      if (!(t >= t0 && t <= t1)) return false;
      rim = side.at(t);
    }
    const glm::dvec2 off = p - rim.point;
    // The error is s² (1−s)² times a function that changes slowly: twice what three points show.
    if (!(2.0 * glm::length(off) <= tolerance)) return false;
  }
  return true;
}

bool fit(const Side& side, const Rim& a, const Rim& b, double t0, double t1, double tolerance,
         int depth, std::vector<QuadBezier>& out) {
  if (!a.regular || !b.regular) return false;
  QuadBezier quad;
  if (joined(a, b, quad) && fits(side, quad, t0, t1, tolerance)) {
    out.push_back(quad);
    return true;
  }
  if (depth == 0) return false;
  const double middle = 0.5 * (t0 + t1);
  const Rim m = side.at(middle);
  return fit(side, a, m, t0, middle, tolerance, depth - 1, out) &&
         fit(side, m, b, middle, t1, tolerance, depth - 1, out);
}

}  // namespace

std::optional<TaperedOutline> tapered_outline(const TaperedStroke& s, double offset,
                                              double tolerance) {
  TaperedOutline outline;
  constexpr int kHalvings = 8;
  for (const double toward : {-1.0, 1.0}) {
    const Side side(s, offset, toward);
    auto& quads = toward < 0.0 ? outline.right : outline.left;
    if (!fit(side, side.at(0.0), side.at(1.0), 0.0, 1.0, tolerance, kHalvings, quads)) return {};
  }
  std::reverse(outline.left.begin(), outline.left.end());
  for (QuadBezier& q : outline.left) q = reversed(q);
  outline.begin_radius = s.half_width[0] + offset;
  outline.end_radius = s.half_width[2] + offset;
  return outline;
}

}  // namespace mien
