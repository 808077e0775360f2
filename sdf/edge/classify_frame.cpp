#include <mien/sdf/edge/classify_frame.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

bool in_range(double x) {
  return x > 0x1p-40 && x < 0x1p40;
}
double sum(glm::dvec2 v) {
  return std::abs(v.x) + std::abs(v.y);
}

/// Rounded up, so that it still bounds.
float up(double x) {
  return float(x * (1 + 0x1p-22));
}

ClassifyFrame segment(glm::dvec2 a, glm::dvec2 b, double half_width) {
  const double length = glm::length(b - a);
  const glm::dvec2 t = length > 0 ? (b - a) / length : glm::dvec2{1.0, 0.0};
  return SegmentSquares{float(a.x),
                        float(a.y),
                        float(t.x),
                        float(t.y),
                        float(length),
                        float(half_width),
                        up(sum(a) + length + std::abs(half_width))};
}

/// The largest |w'| / |B'|: how fast the half-width can change along the spine's chords. The chord
/// from t to t' is (t' − t) B'(m), m their middle, and w likewise; so pieces of [0, 1] in which
/// |w'| is largest at an end and |B'| is bounded by its vertex will do.
double steepest(const QuadBezier& spine, double wa2, double wb) {
  const glm::dvec2 velocity = tangent(spine, 0.0), pull = bend(spine);
  const double pp = glm::dot(pull, pull);
  const double slowest = pp > 0 ? -glm::dot(velocity, pull) / pp : 0.0;
  constexpr int kPieces = 16;
  double most = 0;
  for (int i = 0; i < kPieces; ++i) {
    const double from = double(i) / kPieces, to = double(i + 1) / kPieces;
    const double rate = std::max(std::abs(wa2 + 2 * wb * from), std::abs(wa2 + 2 * wb * to));
    const double speed = glm::length(velocity + std::clamp(slowest, from, to) * pull);
    if (rate > 0) most = std::max(most, rate / speed);
  }
  return most;
}

struct FrameOf {
  const OffsetShape& whole;
  glm::dvec2 origin;

  ClassifyFrame any() const { return AnySquares{whole, origin}; }

  ClassifyFrame stroke(QuadBezier spine, double w0, double w1, double w2) const {
    spine = {spine.p0 - origin, spine.p1 - origin, spine.p2 - origin};
    const double wa = w1 - w0, wb = (w2 - w1) - wa;
    const double top = wb < 0 ? std::clamp(-wa / wb, 0.0, 1.0) : 0.0;
    const double widest = std::max({w0, w2, w0 + top * (2 * wa + top * wb)});
    if (spine.p0 == spine.p1 && spine.p1 == spine.p2) return segment(spine.p0, spine.p0, widest);
    const auto exponent = batch::scale_exponent(spine);
    if (!exponent) return any();
    const double size = sum(spine.p0) + sum(spine.p1) + sum(spine.p2) + std::abs(w0) +
                        2 * std::abs(wa) + std::abs(wb);
    return StrokeSquares{batch::quad_bezier_frame<float>(spine, *exponent),
                         float(w0),
                         float(2 * wa),
                         float(wb),
                         up(widest),
                         float(std::max(-1.0, 1 - 2 * steepest(spine, 2 * wa, wb)) - 0x1p-22),
                         up(size)};
  }

  ClassifyFrame operator()(const HalfPlane& s) const {
    const double offset = s.offset + whole.offset - glm::dot(origin, s.normal);
    return HalfPlaneSquares{float(s.normal.x), float(s.normal.y), float(offset),
                            up(std::abs(offset))};
  }
  ClassifyFrame operator()(const ParabolaSide& s) const {
    const glm::dvec2 v = s.vertex - origin;
    if (whole.offset != 0 || !(std::abs(s.bend) < 0x1p40)) return any();
    return ParabolaSquares{float(v.x),      float(v.y),    float(s.axis.x),
                           float(s.axis.y), float(s.bend), up(sum(v))};
  }
  ClassifyFrame operator()(const Ellipse& s) const {
    const glm::dvec2 c = s.center - origin, u = s.axis / s.radii.x,
                     v = glm::dvec2{-s.axis.y, s.axis.x} / s.radii.y;
    if (whole.offset != 0 || !in_range(s.radii.x) || !in_range(s.radii.y)) return any();
    const double small = std::min(s.radii.x, s.radii.y);
    return EllipseSquares{float(c.x),        float(c.y),        float(u.x),
                          float(u.y),        float(v.x),        float(v.y),
                          up(1 / s.radii.x), up(1 / s.radii.y), up(1 / (small * small)),
                          up(sum(c))};
  }
  ClassifyFrame operator()(const Disc& s) const {
    return segment(s.center - origin, s.center - origin, s.radius + whole.offset);
  }
  ClassifyFrame operator()(const Line& s) const {
    return segment(s.a - origin, s.b - origin, s.half_width + whole.offset);
  }
  ClassifyFrame operator()(const QuadStroke& s) const {
    const double w = s.half_width + whole.offset;
    return stroke(s.spine, w, w, w);
  }
  ClassifyFrame operator()(const TaperedStroke& s) const {
    const double* w = s.half_width;
    return stroke(s.spine, w[0] + whole.offset, w[1] + whole.offset, w[2] + whole.offset);
  }
  ClassifyFrame operator()(const Path& s) const {
    if (whole.offset != 0) return any();
    PathSquares squares{s, {}, 0};
    double size = 0;
    for (Path::Loop& loop : squares.path.loops)
      for (QuadBezier& c : loop.sides) {
        c = {c.p0 - origin, c.p1 - origin, c.p2 - origin};
        if (!batch::scale_exponent(c)) return any();
        size = std::max(size, sum(c.p0) + sum(c.p1) + sum(c.p2));
        squares.sides.push_back(c);
      }
    squares.size = up(size);
    return squares;
  }
  template <class Other>
  ClassifyFrame operator()(const Other&) const {
    return any();
  }
};

}  // namespace

ClassifyFrame classify_frame(const OffsetShape& shape, glm::dvec2 origin) {
  return std::visit(FrameOf{shape, origin}, shape.shape);
}

}  // namespace mien
