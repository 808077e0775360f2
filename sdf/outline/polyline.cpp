#include "polyline_private.h"

#include "arc_private.h"
#include "cross_private.h"

#include <mien/lib/math/norm.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

/// [px] Points nearer than this are one.
constexpr double kSame = 1e-7;
/// [px] Thinner than this there is no line.
constexpr double kThin = 1e-9;

void drop_repeated(std::vector<glm::dvec2>& points) {
  std::size_t kept = 1;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(norm(points[i] - points[kept - 1]) <= kSame)) points[kept++] = points[i];
  points.resize(kept);
}

/// One side of the line, there or back.
class SideWriter {
 public:
  SideWriter(OutlineLoop& loop, double width) : loop_(loop), width_(width) {}

  /// Along the piece from `a` to `b`: what comes before it, and the corner at a. Its own end is
  /// written when the next corner is known.
  void piece(glm::dvec2 a, glm::dvec2 b) {
    const double length = norm(b - a);
    const glm::dvec2 ahead = (b - a) / length, out = -turned(ahead);
    if (begun_) {
      corner(a, ahead, out, length);
    } else {
      loop_.begin(a + width_ * out);
      begun_ = true;
    }
    end_ = b, ahead_ = ahead, out_ = out, length_ = length;
  }

  /// Half a circle around the line's end.
  void around() {
    loop_.line(end_ + width_ * out_);
    write_arc(loop_, end_, width_, out_, kHalfCircle, end_ - width_ * out_);
    out_ = -out_, ahead_ = -ahead_;
  }

 private:
  static constexpr double kHalfCircle = 3.141592653589793;

  void corner(glm::dvec2 at, glm::dvec2 ahead, glm::dvec2 out, double length) {
    const double sine = cross(ahead_, ahead), cosine = glm::dot(ahead_, ahead);
    const glm::dvec2 to = at + width_ * out;
    if (sine >= 0.0 && (sine > 0.0 || cosine < 0.0)) {
      loop_.line(at + width_ * out_);
      write_arc(loop_, at, width_, out_, std::atan2(std::abs(sine), cosine), to);
    } else if (-sine * width_ <= 0.5 * std::min(length, length_) * (1.0 + cosine)) {
      // Both pieces are long enough for their sides to meet: the short cut takes the kite between
      // them, which both strips hold, once less.
      loop_.line(at + width_ / (1.0 + cosine) * (out_ + out));
    } else {
      loop_.line(at + width_ * out_);
      loop_.line(at);
      loop_.line(to);
    }
  }

  OutlineLoop& loop_;
  double width_;
  bool begun_ = false;
  glm::dvec2 end_{0}, ahead_{0}, out_{0};  ///< of the piece before
  double length_ = 0;
};

}  // namespace

void write_polyline(OutlineLoop& loop, std::vector<glm::dvec2>& points, double half_width) {
  if (points.empty() || !(half_width > kThin)) return;
  Box2 box;
  for (const glm::dvec2 p : points) box = around(box, p);
  if (loop.beyond(grown(box, half_width))) return;
  drop_repeated(points);
  const std::size_t n = points.size();
  if (n == 1) return write_disc(loop, points[0], half_width);
  SideWriter side(loop, half_width);
  for (std::size_t i = 1; i < n; ++i) side.piece(points[i - 1], points[i]);
  side.around();
  for (std::size_t i = n - 1; i > 0; --i) side.piece(points[i], points[i - 1]);
  side.around();
  loop.close();
}

}  // namespace mien
