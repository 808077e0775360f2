#pragma once
// What shapes draw their outlines with: loops of lines and quadratic curves, in pixels.

#include <mien/box2.h>

#include <glm/vec2.hpp>

namespace mien {

class CurvePen {
 public:
  virtual void begin(glm::dvec2 p) = 0;
  virtual void line(glm::dvec2 to) = 0;
  virtual void quad(glm::dvec2 control, glm::dvec2 to) = 0;
  /// Back to the begin, straight.
  virtual void close() = 0;

  /// Goes to `to` by any path beyond the same side of the window as the pen is now.
  void beyond_to(glm::dvec2 to) { line(to); }
  glm::dvec2 at() const { return at_; }
  /// [px] by which curves may leave what they approximate.
  double tolerance() const { return tolerance_; }
  /// Curves matter only inside it.
  const Box2& window() const { return window_; }
  /// Whether all of a box lies beyond one side of the window.
  bool beyond(const Box2& box) const {
    return box.hi.x <= window_.lo.x || box.hi.y <= window_.lo.y || box.lo.x >= window_.hi.x ||
           box.lo.y >= window_.hi.y;
  }

 protected:
  ~CurvePen() = default;

  Box2 window_;
  double tolerance_ = 1.0;
  glm::dvec2 at_{0.0};
};

}  // namespace mien
