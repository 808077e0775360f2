#pragma once
// A pen that keeps what is drawn with it: the sides of closed loops, in order.

#include <mien/quad_bezier.h>
#include "sdf/outline/curve/curve_pen.h"

#include <cstddef>
#include <span>
#include <vector>

namespace mien {

class SideList final : public CurvePen {
 public:
  /// Forgets all.
  void frame(const Box2& window, double tolerance);

  void begin(glm::dvec2 p) override;
  void line(glm::dvec2 to) override { quad(0.5 * (at_ + to), to); }
  void quad(glm::dvec2 control, glm::dvec2 to) override;
  void close() override;

  /// Sides of no length are left out, except one where the loop is a point.
  std::span<const QuadBezier> loop(std::size_t i) const;
  std::size_t loops() const { return ends_.size(); }

 private:
  std::vector<QuadBezier> sides_;
  std::vector<std::size_t> ends_;
  glm::dvec2 start_{0.0};
};

}  // namespace mien
