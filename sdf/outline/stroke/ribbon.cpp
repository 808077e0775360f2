#include "ribbon_private.h"

#include "rim_private.h"
#include "sdf/outline/curve/arc_private.h"
#include "sdf/outline/curve/cross_private.h"

#include "lib/math/norm.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [px] Points nearer than this are one.
constexpr double kSame = 1e-7;
/// [px] A ribbon thinner than this is none, and so is a bend this flat.
constexpr double kThin = 1e-9;
constexpr double kHalfCircle = 3.141592653589793;

/// One rim of a chain, there or back.
class RimChain {
 public:
  RimChain(OutlineLoop& loop, double width) : loop_(loop), width_(width) {}

  void side(const QuadBezier& c) {
    const glm::dvec2 a = c.p1 - c.p0, b = (c.p2 - c.p1) - a;
    const double size = std::max(norm(a), norm(b));
    if (!(std::abs(cross(a, b)) <= kThin * size)) return curve(c, size);
    // A straight side may run beyond its end and back.
    const double turn = -glm::dot(a, b) / glm::dot(b, b);
    if (turn > 0.0 && turn < 1.0) {
      const glm::dvec2 there = c.p0 + turn * (2.0 * a + turn * b);
      straight(c.p0, there);
      straight(there, c.p2);
    } else {
      straight(c.p0, c.p2);
    }
  }

  /// Half a circle around the end of the chain.
  void around() {
    if (!begun_) return;
    end_straight();
    write_arc(loop_, end_, width_, out_, kHalfCircle, end_ - width_ * out_);
    out_ = -out_, ahead_ = -ahead_;
  }

  bool begun() const { return begun_; }

 private:
  /// Its own end is written when the next corner is known.
  void straight(glm::dvec2 a, glm::dvec2 b) {
    const double length = norm(b - a);
    if (length <= kSame) return;
    const glm::dvec2 ahead = (b - a) / length;
    corner(a, ahead, length);
    end_ = b, ahead_ = ahead, out_ = -turned(ahead), length_ = length;
  }

  void curve(const QuadBezier& c, double size) {
    if (size <= kSame) return;
    const Pen pen(c, width_, width_, width_);
    corner(c.p0, glm::normalize(c.p1 - c.p0), 0.0);
    write_rim(loop_, pen, -1.0, rim_at(pen, -1.0, 0.0), rim_at(pen, -1.0, 1.0));
    end_ = c.p2, ahead_ = glm::normalize(c.p2 - c.p1), out_ = -turned(ahead_), length_ = 0.0;
  }

  void end_straight() {
    if (length_ > 0.0) loop_.line(end_ + width_ * out_);
  }

  /// From the side before to one that leaves `at` towards `ahead`, straight for `length`.
  void corner(glm::dvec2 at, glm::dvec2 ahead, double length) {
    const glm::dvec2 out = -turned(ahead), to = at + width_ * out;
    if (!begun_) {
      begun_ = true;
      return loop_.begin(to);
    }
    const double sine = cross(ahead_, ahead), cosine = glm::dot(ahead_, ahead);
    // 1 + cosine, which cancels where the chain all but turns back.
    const double cosine_and_one = cosine < 0.0 ? sine * sine / (1.0 - cosine) : 1.0 + cosine;
    if (sine >= 0.0) {
      end_straight();
      write_arc(loop_, at, width_, out_, std::atan2(std::abs(sine), cosine), to);
    } else if (-sine * width_ <= 0.5 * std::min(length, length_) * cosine_and_one) {
      // Both sides are long enough for their rims to meet: the short cut takes the kite between
      // them, which both strips hold, once less.
      loop_.line(at + width_ / cosine_and_one * (out_ + out));
    } else {
      end_straight();
      // Hardly a corner: straight on.
      if (!(-sine * width_ <= 0.25 * loop_.tolerance() && cosine > 0.0)) loop_.line(at);
      loop_.line(to);
    }
  }

  OutlineLoop& loop_;
  double width_;
  bool begun_ = false;
  glm::dvec2 end_{0.0}, ahead_{0.0}, out_{0.0};  ///< of the side before
  double length_ = 0.0;                          ///< its length, if it is straight
};

}  // namespace

void write_ribbon(OutlineLoop& loop, std::span<const QuadBezier> sides, double width) {
  if (sides.empty() || !(width > kThin)) return;
  Box2 box;
  for (const QuadBezier& c : sides) box = around(around(around(box, c.p0), c.p1), c.p2);
  if (loop.beyond(grown(box, width))) return;
  RimChain rims(loop, width);
  for (const QuadBezier& c : sides) rims.side(c);
  if (!rims.begun()) return write_disc(loop, sides[0].p0, width);
  rims.around();
  for (std::size_t i = sides.size(); i-- > 0;) rims.side(reversed(sides[i]));
  rims.around();
  loop.close();
}

void write_polyline(OutlineLoop& loop, std::span<const glm::dvec2> points, double width,
                    std::vector<QuadBezier>& sides) {
  sides.clear();
  if (points.empty()) return;
  glm::dvec2 last = points[0];
  for (const glm::dvec2 p : points) {
    if (norm(p - last) <= kSame) continue;
    sides.push_back({last, 0.5 * (last + p), p});
    last = p;
  }
  if (sides.empty()) sides.push_back({last, last, last});
  write_ribbon(loop, sides, width);
}

}  // namespace mien
