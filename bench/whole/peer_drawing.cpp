#include "bench/whole/peer_drawing.h"

#include "lib/picture/srgb.h"
#include "render/shade/paint_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace mien::bench {
namespace {

struct Refusal {
  std::string why;
};

Color encoded(const Color& c) {
  return {srgb_from_linear(c.r), srgb_from_linear(c.g), srgb_from_linear(c.b), c.a};
}

void move(PathSteps& to, glm::dvec2 p) {
  to.push_back({PathStep::Kind::move, {p}});
}
void line(PathSteps& to, glm::dvec2 p) {
  to.push_back({PathStep::Kind::line, {p}});
}
void close(PathSteps& to) {
  to.push_back({PathStep::Kind::close});
}

/// A quadratic as the same curve of degree three.
void quad(PathSteps& to, const QuadBezier& q) {
  to.push_back({PathStep::Kind::cubic,
                {q.p0 + 2.0 / 3.0 * (q.p1 - q.p0), q.p2 + 2.0 / 3.0 * (q.p1 - q.p2), q.p2}});
}

/// An arc as cubics of at most 45 degrees, 5e-6 radii off at most.
void arc(PathSteps& to, glm::dvec2 center, double radius, double from, double until) {
  const int pieces = int(std::ceil(std::fabs(until - from) / 0.785398163397448 - 1e-9));
  const double step = (until - from) / pieces, pull = 4.0 / 3.0 * std::tan(step / 4);
  const auto on = [&](double a) { return glm::dvec2{std::cos(a), std::sin(a)}; };
  const auto along = [&](double a) { return glm::dvec2{-std::sin(a), std::cos(a)}; };
  for (int i = 0; i < pieces; ++i) {
    const double a = from + i * step, b = a + step;
    to.push_back({PathStep::Kind::cubic,
                  {center + radius * (on(a) + pull * along(a)),
                   center + radius * (on(b) - pull * along(b)), center + radius * on(b)}});
  }
}

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// A parabola as a curve over u = cross(axis, p − vertex), and its quadratic between two of them.
struct Parabola {
  ParabolaSide side;

  glm::dvec2 blossom(double u, double v) const {
    const glm::dvec2 along{-side.axis.y, side.axis.x};
    return side.vertex + 0.5 * (u + v) * along + side.bend * u * v * side.axis;
  }
  double u_of(glm::dvec2 p) const { return cross(side.axis, p - side.vertex); }
  QuadBezier between(double u, double v) const {
    return {blossom(u, u), blossom(u, v), blossom(v, v)};
  }
};

PathSteps band_path(const Band& band) {
  const Parabola lower{band.lower}, upper{band.upper};
  const glm::dvec2 a = band.lower.axis, b = band.upper.axis;
  if (std::fabs(cross(a, b)) > 1e-12) throw Refusal{"a band whose axes are not parallel"};
  // Along the lower side, the upper's condition  dot(q, b) = bend_b · cross(b, q)²  is a quadratic.
  const double s = dot(a, b);  // ±1
  const glm::dvec2 d = band.lower.vertex - band.upper.vertex;
  const double e = cross(b, d);
  const double k2 = band.lower.bend * s - band.upper.bend, k1 = -2 * band.upper.bend * e * s,
               k0 = dot(d, b) - band.upper.bend * e * e;
  const double root = std::sqrt(k1 * k1 - 4 * k2 * k0);
  if (!(root > 0)) throw Refusal{"a band with nothing inside"};
  const double u = (-k1 - root) / (2 * k2), v = (-k1 + root) / (2 * k2);
  PathSteps path;
  move(path, lower.blossom(u, u));
  quad(path, lower.between(u, v));
  quad(path, upper.between(upper.u_of(lower.blossom(v, v)), upper.u_of(lower.blossom(u, u))));
  close(path);
  return path;
}

PathSteps cut_disc_path(const CutDisc& disc) {
  const double up = std::asin(std::fmin(1, disc.upper)), low = std::asin(std::fmin(1, disc.lower));
  const double turn = std::atan2(disc.up.y, disc.up.x), half = 1.5707963267948966;
  const auto on = [&](double a) {
    return disc.center + disc.radius * glm::dvec2{std::cos(a), std::sin(a)};
  };
  // Angles from `up`: the upper chord ends at ±(half − up), the lower one at ±(half + low).
  PathSteps path;
  move(path, on(turn + half - up));
  arc(path, disc.center, disc.radius, turn + half - up, turn + half + low);
  line(path, on(turn - half - low));
  arc(path, disc.center, disc.radius, turn - half - low, turn - half + up);
  close(path);
  return path;
}

PathSteps loops_path(const Path& from) {
  PathSteps path;
  for (const Path::Loop& loop : from.loops) {
    if (loop.sides.empty()) continue;
    move(path, loop.sides.front().p0);
    for (const QuadBezier& side : loop.sides) quad(path, side);
    close(path);
  }
  return path;
}

PathSteps ellipse_path(const Ellipse& s) {
  PathSteps path;
  move(path, {1, 0});
  arc(path, {0, 0}, 1, 0, 6.283185307179586);
  close(path);
  const glm::dvec2 across{-s.axis.y, s.axis.x};
  for (PathStep& step : path)
    for (glm::dvec2& p : step.p) p = s.center + p.x * s.radii.x * s.axis + p.y * s.radii.y * across;
  return path;
}

/// [px] How far outlines that mien fits for a peer may be off.
constexpr double kFitted = 0.01;

/// Its outline as fitted by mien. Nothing where it has no width.
PathSteps tapered_path(const TaperedStroke& s) {
  PathSteps path;
  constexpr double kFar = 1e6;  // [px] nothing is cut
  Outlines outlines;
  OutlineMaker maker;
  maker.begin({{}, {{-kFar, -kFar}, {kFar, kFar}}, kFitted}, outlines);
  maker.fill(s);
  maker.finish();
  // Down one chain, up the one that ends where it does, and down the one that begins where that does.
  std::vector<int> above(outlines.chains.size()), below = above;
  for (const OutlineEnd& e : outlines.ends) {
    std::vector<int>& with = e.begins ? above : below;
    with[std::size_t(e.chain)] = e.other, with[std::size_t(e.other)] = e.chain;
  }
  std::vector<char> taken(outlines.chains.size(), 0);
  for (std::size_t first = 0; first < outlines.chains.size(); ++first) {
    if (taken[first] || outlines.chains[first].turn < 0) continue;
    const OutlinePiece& begin = outlines.pieces[std::size_t(outlines.chains[first].first)];
    move(path, {begin.x0, begin.y0});
    for (std::size_t down = first; !taken[down];) {
      taken[down] = 1;
      const OutlineChain& there = outlines.chains[down];
      for (int i = there.first; i <= there.last; ++i) {
        const OutlinePiece& p = outlines.pieces[std::size_t(i)];
        quad(path, {{p.x0, p.y0}, {p.x0 + p.ax, p.y0 + p.ay}, {p.x1, p.y1}});
      }
      const std::size_t up = std::size_t(below[down]);
      const OutlineChain& back = outlines.chains[up];
      for (int i = back.last; i >= back.first; --i) {
        const OutlinePiece& p = outlines.pieces[std::size_t(i)];
        quad(path, {{p.x1, p.y1}, {p.x0 + p.ax, p.y0 + p.ay}, {p.x0, p.y0}});
      }
      down = std::size_t(above[up]);
    }
    close(path);
  }
  return path;
}

PathSteps lines_path(const std::vector<glm::dvec2>& points) {
  PathSteps path;
  move(path, points.front());
  for (std::size_t i = 1; i < points.size(); ++i) line(path, points[i]);
  return path;
}

struct FigureOf {
  PeerFigure operator()(const Band& s) const { return {PeerFigure::Kind::fill, band_path(s)}; }
  PeerFigure operator()(const CutDisc& s) const {
    return {PeerFigure::Kind::fill, cut_disc_path(s)};
  }
  PeerFigure operator()(const Disc& s) const {
    return {PeerFigure::Kind::ellipse, {}, 0, {s.center, {s.radius, s.radius}}};
  }
  PeerFigure operator()(const Ellipse& s) const { return {PeerFigure::Kind::ellipse, {}, 0, s}; }
  PeerFigure operator()(const Triangle& s) const {
    PeerFigure figure{PeerFigure::Kind::fill, lines_path({s.a, s.b, s.c})};
    close(figure.path);
    return figure;
  }
  PeerFigure operator()(const Line& s) const {
    return {PeerFigure::Kind::stroke, lines_path({s.a, s.b}), 2 * s.half_width};
  }
  PeerFigure operator()(const Polyline& s) const {
    return {PeerFigure::Kind::stroke, lines_path(s.points), 2 * s.half_width};
  }
  PeerFigure operator()(const QuadStroke& s) const {
    PeerFigure figure{PeerFigure::Kind::stroke, {}, 2 * s.half_width};
    move(figure.path, s.spine.p0);
    quad(figure.path, s.spine);
    return figure;
  }
  PeerFigure operator()(const Path& s) const {
    PeerFigure figure{PeerFigure::Kind::fill, loops_path(s)};
    figure.even_odd = s.rule == FillRule::even_odd;
    return figure;
  }
  PeerFigure operator()(const TaperedStroke& s) const {
    return {PeerFigure::Kind::fill, tapered_path(s)};
  }
  template <class Other>
  PeerFigure operator()(const Other& s) const {
    throw Refusal{"a " + std::string(shape_name(Shape(s)))};
  }
};

/// Whether a surface is level but for domes, as lids are: those are drawn without their light,
/// which changes a face's picture by far less than the light of a profile.
bool is_level(const Relief& relief) {
  return relief.profile == Profile::flat || relief.height == 0;
}

template <class Gradient>
bool has_no_extent(const Gradient& along) {
  if constexpr (std::is_same_v<Gradient, LinearGradient>) return along.from == along.to;
  if constexpr (std::is_same_v<Gradient, RadialGradient>)
    return !(along.radii.x > 0 && along.radii.y > 0);
  return false;
}

struct GradientOf {
  const Map<PixelSpace, FaceSpace>& pixels;

  PeerGradient operator()(const LinearGradient& g) const { return {pixels(g.from), pixels(g.to)}; }
  PeerGradient operator()(const RadialGradient& g) const {
    return {
        pixels(g.center), {}, pixels.scale() * g.radii, pixels.direction(g.axis) / pixels.scale()};
  }
  PeerGradient operator()(const DistanceGradient&) const {
    throw Refusal{"a gradient by distance"};
  }
};

class Maker {
 public:
  Maker(const Scene& scene, const View& view)
      : scene_(scene), pixels_(pixel_from_face(scene.canvas(), view)) {
    // mien's pixels count from the picture's centre, a rasteriser's from its corner.
    pixels_.shift += 0.5 * glm::dvec2{view.width, view.height};
  }

  PeerFigure figure(Area area) const {
    const Node& node = scene_.nodes()[std::size_t(area.node)];
    if (node.op == Op::shape) {
      return std::visit(FigureOf{}, transformed(pixels_, scene_.shapes()[std::size_t(node.a)]));
    }
    if (node.op != Op::intersect) throw Refusal{"an area that is no intersection"};
    PeerFigure inner = figure({node.a});
    PeerFigure outer = figure({node.b});
    if (outer.kind == PeerFigure::Kind::ellipse) outer.path = ellipse_path(outer.ellipse);
    if (outer.kind == PeerFigure::Kind::stroke) throw Refusal{"a clip that is a stroke"};
    inner.clips.push_back(std::move(outer.path));
    for (PathSteps& clip : outer.clips) inner.clips.push_back(std::move(clip));
    return inner;
  }

  /// The figure with its paint. What has no extent is its last colour everywhere.
  PeerFigure painted(const Layer& layer) const {
    if (layer.paint.relief && !is_level(*layer.paint.relief)) throw Refusal{"a lit surface"};
    PeerFigure made = figure(layer.area);
    made.color = encoded(layer.paint.color);
    if (!layer.paint.gradient) return made;
    const Gradient& gradient = *layer.paint.gradient;
    PeerGradient peer = std::visit(GradientOf{pixels_}, gradient.along);
    peer.extend = gradient.extend;
    for (const Stop& stop : gradient.stops) {
      peer.stops.push_back({stop.at, encoded(stop.color)});
      peer.stops.back().color.a *= layer.paint.color.a;
    }
    if (std::visit([](const auto& along) { return has_no_extent(along); }, gradient.along))
      made.color = peer.stops.back().color;
    else
      made.gradient = std::move(peer);
    return made;
  }

 private:
  const Scene& scene_;
  Map<PixelSpace, FaceSpace> pixels_;
};

}  // namespace

std::optional<PeerDrawing> peer_drawing(const Scene& scene, const View& view, std::string& why) {
  try {
    const Maker maker(scene, view);
    PeerDrawing drawing{view.width, view.height, encoded(scene.background()), {}};
    for (const Group& group : scene.groups())
      if (group.opacity < 1 || group.mix != MixMode::normal)
        throw Refusal{"a group with an opacity or a mix"};
    for (const Layer& layer : scene.layers()) drawing.figures.push_back(maker.painted(layer));
    return drawing;
  } catch (const Refusal& refusal) {
    why = refusal.why;
    return {};
  }
}

void GivenOutlines::fit(const Scene& scene, const View& view) {
  const Box2 window{{0.0, 0.0}, {view.width, view.height}};
  maker_.begin({grid_from_face(scene.canvas(), view), window, kFitted}, outlines_);
  for (const Shape& shape : scene.shapes())
    if (std::holds_alternative<TaperedStroke>(shape)) maker_.fill(shape);
  maker_.finish();
}

}  // namespace mien::bench
