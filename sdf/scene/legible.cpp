#include "sdf/scene/legible.h"
#include "sdf/shape/shape_distances.h"
#include "sdf/shape/shape_outlines.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace mien {
namespace {

/// More makes blotches of hair and lashes.
constexpr double kMostWider = 3;

/// What becomes of a line that is `width` wide.
struct LegibleLine {
  LegibleLine(double width, double least) {
    if (!(width > 0 && width < least)) return;
    wider = std::min(kMostWider, least / width);
    seen = wider * width / least;
  }
  double wider = 1;  ///< factor
  double seen = 1;   ///< share of its opacity
};

/// Widens lines in place; the value is how much is seen of the shape.
class LegibleShape {
 public:
  explicit LegibleShape(double least) : least_(least) {}

  double operator()(Line& s) const { return widen(&s.half_width, 1); }
  double operator()(Polyline& s) const { return widen(&s.half_width, 1); }
  double operator()(QuadStroke& s) const { return widen(&s.half_width, 1); }
  double operator()(TaperedStroke& s) const { return widen(s.half_width, 3); }
  double operator()(const HalfPlane&) const { return 1; }
  double operator()(const ParabolaSide&) const { return 1; }
  template <class Area>
  double operator()(const Area& s) const {
    const Box2 box = bounds(Shape(s));
    if (box.empty()) return 1;  // all of the plane, as a complement
    const glm::dvec2 size = box.size();
    return std::min(1.0, size.x * size.y / (least_ * least_));
  }

 private:
  double widen(double* half_widths, int count) const {
    // The middle of three is a Bézier's, which reaches half of it.
    double width = 2 * std::max(half_widths[0], half_widths[count - 1]);
    if (count == 3)
      width = std::max(width, 0.5 * half_widths[0] + half_widths[1] + 0.5 * half_widths[2]);
    const LegibleLine line(width, least_);
    for (int i = 0; i < count; ++i) half_widths[i] *= line.wider;
    return line.seen;
  }

  double least_;
};

Color faded(Color color, double seen) {
  color.a *= seen;
  return color;
}

/// With a gradient the opacity of `color` counts for all of it.
Paint faded(Paint paint, double seen) {
  paint.color = faded(paint.color, seen);
  return paint;
}

}  // namespace

Scene legible_scene(const Scene& scene, double least) {
  if (!(least > 0)) return scene;
  Scene::Data data = *scene.data_;
  std::vector<double> seen_shapes;
  for (Shape& shape : data.shapes)
    seen_shapes.push_back(std::visit([&](auto& s) { return LegibleShape(least)(s); }, shape));
  std::vector<double> seen;  // by node
  for (Node& node : data.nodes) {
    const auto of = [&](int operand) { return seen[std::size_t(operand)]; };
    switch (node.op) {
      case Op::shape:
        seen.push_back(seen_shapes[std::size_t(node.a)]);
        break;
      case Op::unite:
        seen.push_back(std::max(of(node.a), of(node.b)));
        break;
      case Op::intersect:
        seen.push_back(std::min(of(node.a), of(node.b)));
        break;
      case Op::subtract:
      case Op::offset:
        seen.push_back(of(node.a));
        break;
      case Op::complement:
        seen.push_back(1);
        break;
      case Op::shell: {
        const LegibleLine line(2 * node.amount, least);
        node.amount *= line.wider;
        seen.push_back(line.seen);
        break;
      }
    }
  }
  for (Layer& layer : data.layers)
    layer.paint = faded(std::move(layer.paint), seen[std::size_t(layer.area.node)]);
  data.asked = std::make_shared<const ShapeDistances>(data.shapes.size());
  data.outlines = std::make_shared<const ShapeOutlines>(data.shapes.size());
  Scene made;
  made.data_ = std::make_shared<const Scene::Data>(std::move(data));
  return made;
}

}  // namespace mien
