#include "sdf/outline/outline_maker.h"

#include "sdf/outline/curve/boundary_private.h"
#include "sdf/outline/stroke/ribbon_private.h"
#include "sdf/outline/stroke/stroke_private.h"

#include <algorithm>

namespace mien {
namespace {

FillRule rule_of(const Shape& shape) {
  const Path* path = std::get_if<Path>(&shape);
  return path ? path->rule : FillRule::nonzero;
}

}  // namespace

/// Fills: what bounds a shape, or the discs of its pen.
struct OutlineMaker::Filler : BoundaryWriter {
  OutlineMaker& maker;

  explicit Filler(OutlineMaker& m) : BoundaryWriter{m.loop_, m.map_, m.scale_}, maker(m) {}

  using BoundaryWriter::operator();
  void operator()(const Line& s) const {
    const glm::dvec2 points[] = {map(s.a), map(s.b)};
    write_polyline(maker.loop_, points, scale * s.half_width, maker.sides_);
  }
  void operator()(const Polyline& s) const {
    maker.points_.clear();
    for (const glm::dvec2 p : s.points) maker.points_.push_back(map(p));
    write_polyline(maker.loop_, maker.points_, scale * s.half_width, maker.sides_);
  }
  void operator()(const QuadStroke& s) const { (*this)(*tapered(s)); }
  void operator()(const TaperedStroke& s) const { write_stroke(maker.loop_, pen(s)); }

  Pen pen(const TaperedStroke& s) const {
    const QuadBezier spine{map(s.spine.p0), map(s.spine.p1), map(s.spine.p2)};
    return {spine, scale * s.half_width[0], scale * s.half_width[1], scale * s.half_width[2]};
  }
};

/// Rims of what bounds a shape: ribbons along it.
struct OutlineMaker::Recorder : BoundaryWriter {
  using BoundaryWriter::operator();
  template <class Stroke>
  void operator()(const Stroke&) const {}  // strokes have wider and narrower strokes instead
};

void OutlineMaker::begin(const OutlineFrame& frame, Outlines& to) {
  to.clear();
  map_ = frame.grid_from_face;
  scale_ = map_.scale();
  loop_.frame(frame.window, frame.tolerance, to);
}

int OutlineMaker::fill(const Shape& shape) {
  const int index = loop_.outline(rule_of(shape));
  loop_.set_may_run_back(std::holds_alternative<Path>(shape));
  std::visit(Filler(*this), shape);
  return index;
}

int OutlineMaker::add(const AreaPrograms& programs, const OutlineSource& source) {
  const Shape& shape = programs.shape(source);
  if (source.rim) return rim(shape, source.amount);
  if (source.count == 1)
    return source.amount == 0.0 ? fill(shape) : fill(*offset_shape(shape, source.amount));
  const int index = loop_.outline(FillRule::nonzero);
  loop_.set_may_run_back(false);
  StrokeRow row(loop_);
  for (int i = 0; i < source.count; ++i) {
    TaperedStroke stroke = *tapered(programs.shape({source.shape + i, 0.0, false}));
    for (double& w : stroke.half_width) w += source.amount;
    row.add(Filler(*this).pen(stroke));
  }
  row.end();
  return index;
}

int OutlineMaker::rim(const Shape& shape, double half_width) {
  const int index = loop_.outline(FillRule::nonzero);
  loop_.set_may_run_back(false);
  if (!(half_width > 0.0)) return index;
  const auto wider = offset_shape(shape, half_width), narrower = offset_shape(shape, -half_width);
  if (wider && narrower) {
    std::visit(Filler(*this), *wider);
    loop_.set_backwards(true);
    std::visit(Filler(*this), *narrower);
    loop_.set_backwards(false);
  } else {
    ribbons(shape, scale_ * half_width);
  }
  return index;
}

/// Half of the tolerance is for the shape's boundary, half for the rims along it.
void OutlineMaker::ribbons(const Shape& shape, double width) {
  const double tolerance = loop_.tolerance();
  list_.frame(grown(loop_.window(), width), 0.5 * tolerance);
  std::visit(Recorder{{list_, map_, scale_}}, shape);
  loop_.set_tolerance(0.5 * tolerance);
  for (std::size_t i = 0; i < list_.loops(); ++i) write_ribbon(loop_, list_.loop(i), width);
  loop_.set_tolerance(tolerance);
}

}  // namespace mien
