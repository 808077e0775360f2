#include <mien/render/tile/tape.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <utility>

namespace mien {
namespace {

using Kind = Step::Kind;

/// Takes shapes apart into outlines that are smooth wherever they are not ends of strokes, so that
/// corners become combinations of bits. Only without an offset: the offset outline of a corner is
/// round.
class ShapeSteps {
 public:
  explicit ShapeSteps(Tape& tape) : tape_(tape) {}

  void add(const Shape& shape, double offset) {
    if (has_no_width(shape, offset))
      step(Kind::nothing);
    else if (offset == 0.0)
      std::visit([&](const auto& s) { parts(s); }, shape);
    else
      outline(shape, offset);
  }

  /// A polyline by its lines, taken to pixels one by one.
  void add(const Polyline& s, const Map<PixelSpace, FaceSpace>& map, double offset) {
    const double half_width = s.half_width * map.scale();
    if (s.points.empty()) return step(Kind::nothing);
    if (s.points.size() == 1) return add(Disc{map(s.points[0]), half_width}, offset);
    for (std::size_t i = 1; i < s.points.size(); ++i) {
      add(Line{map(s.points[i - 1]), map(s.points[i]), half_width}, offset);
      if (i > 1) step(Kind::or_);
    }
  }

 private:
  /// Strokes without width cover no area.
  static bool has_no_width(const Shape& shape, double offset) {
    if (const auto* s = std::get_if<TaperedStroke>(&shape)) {
      const double* w = s->half_width;  // between its ends a quadratic is below its control values
      return std::max({w[0], w[1], w[2]}) + offset <= 0.0;
    }
    if (const auto* s = std::get_if<QuadStroke>(&shape)) return s->half_width + offset <= 0.0;
    if (const auto* s = std::get_if<Line>(&shape)) return s->half_width + offset <= 0.0;
    return false;
  }

  void step(Kind kind) { tape_.steps.push_back({kind}); }

  void outline(const Shape& shape, double offset = 0.0) {
    tape_.steps.push_back({Kind::outline, int(tape_.outlines.size())});
    tape_.outlines.push_back({shape, offset});
  }

  template <class Other>
  void parts(const Other& s) {
    outline(s);
  }
  void parts(const Band& s) {
    outline(s.lower);
    outline(s.upper);
    step(Kind::and_);
  }
  void parts(const CutDisc& s) {
    outline(Disc{s.center, s.radius});
    const double middle = glm::dot(s.center, s.up);
    outline(HalfPlane{s.up, middle + s.upper * s.radius});
    step(Kind::and_);
    outline(HalfPlane{-s.up, -middle + s.lower * s.radius});
    step(Kind::and_);
  }
  void parts(const Triangle& s) {
    const glm::dvec2 ab = s.b - s.a, ac = s.c - s.a;
    const double turn = ab.x * ac.y - ab.y * ac.x;
    if (turn == 0.0) return step(Kind::nothing);
    const auto side = [&](glm::dvec2 from, glm::dvec2 to) {
      const glm::dvec2 along = glm::normalize(turn > 0.0 ? to - from : from - to);
      const glm::dvec2 normal{along.y, -along.x};  // right of a loop that runs left
      outline(HalfPlane{normal, glm::dot(normal, from)});
    };
    side(s.a, s.b);
    side(s.b, s.c);
    step(Kind::and_);
    side(s.c, s.a);
    step(Kind::and_);
  }
  Tape& tape_;
};

/// Writes the program of an area. With f the area's distance by its CSG tree, "f − offset <= 0" is pushed down:
///   either, both: to both operands          complement: −a <= o  is  not (a <= −o)
///   offset m:     a <= o + m                shell m:    |a| <= o + m =: k  is  a <= k and not (a <= −k)
/// Works off a stack of its own: trees may be a hundred thousand deep.
class AreaSteps {
 public:
  using Task = TapeMaker::Task;
  using Range = TapeMaker::Range;

  AreaSteps(const Scene& scene, const Map<PixelSpace, FaceSpace>& map, Tape& tape,
            std::vector<Task>& todo, std::vector<Range>& written)
      : scene_(scene), map_(map), tape_(tape), todo_(todo), written_(written) {
    todo_.clear();
    written_.assign(scene.shapes().size(), {});
  }

  void add(Area area) {
    todo_.push_back({.node = area.node});
    while (!todo_.empty()) {
      const Task task = todo_.back();
      todo_.pop_back();
      if (task.node < 0)
        tape_.steps.push_back({task.kind});
      else
        expand(scene_.nodes()[std::size_t(task.node)], task.offset);
    }
  }

 private:
  void visit_next(int node, double offset) { todo_.push_back({.node = node, .offset = offset}); }
  void write_after(Kind kind) { todo_.push_back({.kind = kind}); }

  /// The stack runs backwards: last pushed is done first.
  void expand(const Node& n, double o) {
    switch (n.op) {
      case Op::shape:
        return shape(n.a, o);
      case Op::either:
      case Op::both:
        write_after(n.op == Op::either ? Kind::or_ : Kind::and_);
        visit_next(n.b, o);
        return visit_next(n.a, o);
      case Op::without:
        write_after(Kind::and_);
        write_after(Kind::not_);
        visit_next(n.b, -o);
        return visit_next(n.a, o);
      case Op::complement:
        write_after(Kind::not_);
        return visit_next(n.a, -o);
      case Op::offset:
        return visit_next(n.a, o + n.amount);
      case Op::shell: {
        const double k = o + n.amount;
        if (!(k >= 0.0)) return write_after(Kind::nothing);
        write_after(Kind::and_);
        write_after(Kind::not_);
        visit_next(n.a, -k);
        return visit_next(n.a, k);
      }
    }
  }

  /// A shape met again at the same offset is the same outline: it is written once and its bits are
  /// shared.
  void shape(int index, double offset) {
    const Shape& shape = scene_.shapes()[std::size_t(index)];
    Range& written =
        offset == 0.0 ? written_[std::size_t(index)] : written_grown_[std::pair(index, offset)];
    if (written.first >= 0) {
      for (int i = 0; i < written.count; ++i)
        tape_.steps.push_back(tape_.steps[std::size_t(written.first + i)]);
      return;
    }
    written.first = int(tape_.steps.size());
    if (const auto* line = std::get_if<Polyline>(&shape))
      ShapeSteps(tape_).add(*line, map_, offset * map_.scale());
    else
      ShapeSteps(tape_).add(transformed(map_, shape), offset * map_.scale());
    written.count = int(tape_.steps.size()) - written.first;
  }

  const Scene& scene_;
  const Map<PixelSpace, FaceSpace>& map_;
  Tape& tape_;
  std::vector<Task>& todo_;
  std::vector<Range>& written_;
  std::map<std::pair<int, double>, Range> written_grown_;
};

/// Makes paints ready; a distance asked for twice is kept once.
class PaintMaker {
 public:
  PaintMaker(const Scene& scene, const View& view, const Map<PixelSpace, FaceSpace>& map,
             Tape& tape)
      : scene_(scene), view_(view), map_(map), tape_(tape) {}

  void add(const Paint& paint, TapeLayer& layer) {
    if (!paint.gradient && !paint.relief) {
      layer.mix = mix_from_color(paint.color, view_.blend);
      return;
    }
    TapePaint made{.color = mix_from_color(paint.color, view_.blend)};
    if (paint.gradient) {
      made.ramp.emplace(*paint.gradient, paint.color.a, view_.blend);
      made.field =
          std::visit([&](const auto& along) { return field(along); }, paint.gradient->along);
    }
    if (paint.relief) made.relief = relief(*paint.relief);
    layer.paint = int(tape_.paints.size());
    layer.mix = {0.0, 0.0, 0.0, made.least_opacity()};
    tape_.paints.push_back(std::move(made));
  }

 private:
  static constexpr double kLeast = 1e-9;  ///< [px] gradients shorter than that are sudden changes

  PaintField field(const LinearGradient& g) const {
    const glm::dvec2 from = map_(g.from), way = map_(g.to) - from;
    const double length = std::max(glm::length(way), kLeast);
    PaintField made{.kind = PaintField::Kind::linear};
    if (way == glm::dvec2{0.0})
      made.shift = 1.0;
    else
      made.across = way / (length * length), made.shift = -glm::dot(from, made.across);
    made.per_pixel = glm::length(made.across);
    return made;
  }
  PaintField field(const RadialGradient& g) const {
    PaintField made{.kind = PaintField::Kind::radial, .center = map_(g.center)};
    made.unit = unit(g.radii, g.axis);
    made.per_pixel = 1.0 / (map_.scale() * std::max(std::min(g.radii.x, g.radii.y), kLeast));
    return made;
  }
  PaintField field(const DistanceGradient& g) {
    const double length = (g.to - g.from) * map_.scale();
    PaintField made{.kind = PaintField::Kind::distance, .distance = distance(g.area)};
    made.from = g.from * map_.scale();
    made.scale = 1.0 / (std::abs(length) > kLeast ? length : kLeast);
    made.per_pixel = std::abs(made.scale);
    return made;
  }

  /// Takes an ellipse's points, seen from its centre, to the unit circle.
  glm::dmat2 unit(glm::dvec2 radii, glm::dvec2 axis) const {
    const glm::dvec2 u = glm::normalize(map_.linear * axis), v{-u.y, u.x};
    const double a = map_.scale() * std::max(radii.x, kLeast),
                 b = map_.scale() * std::max(radii.y, kLeast);
    return glm::dmat2{u.x / a, v.x / b, u.y / a, v.y / b};  // columns
  }

  TapeRelief relief(const Relief& r) {
    TapeRelief made{.profile = r.profile, .lamp = Lamp(light(), r.specular, r.shininess)};
    if (r.area.node >= 0 && r.profile != Profile::flat) made.distance = distance(r.area);
    if (r.profile == Profile::custom && r.table.size() < 2) made.profile = Profile::flat;
    made.width = std::max(r.width * map_.scale(), kLeast);
    made.height = r.height * map_.scale();
    made.table = r.table;
    for (const Dome& dome : r.domes)
      made.domes.push_back({map_(dome.center), unit(dome.radii, dome.axis),
                            dome.height * map_.scale(),
                            map_.scale() * std::max(dome.radii.x, dome.radii.y)});
    return made;
  }

  Light light() const {
    Light light = scene_.light();
    if (view_.light) light.direction = *view_.light;
    return light;
  }

  int distance(Area area) {
    const auto [found, is_new] = distances_.try_emplace(area.node, int(tape_.distances.size()));
    if (is_new) tape_.distances.emplace_back(scene_, area, map_);
    return found->second;
  }

  const Scene& scene_;
  const View& view_;
  const Map<PixelSpace, FaceSpace>& map_;
  Tape& tape_;
  std::map<int, int> distances_;
};

/// The translucent groups, and for every group of the scene the nearest of those it is in.
void add_groups(const Scene& scene, Tape& tape, std::vector<int>& nearest) {
  nearest.clear();
  for (const Group& group : scene.groups()) {
    const int parent = group.parent < 0 ? -1 : nearest[std::size_t(group.parent)];
    const int depth = parent < 0 ? 1 : tape.groups[std::size_t(parent)].depth + 1;
    if (group.opacity >= 1.0) {
      nearest.push_back(parent);  // its layers are as good as on their own
      continue;
    }
    nearest.push_back(int(tape.groups.size()));
    tape.groups.push_back({parent, depth, group.opacity > 0.0 ? group.opacity : 0.0});
  }
}

}  // namespace

Tape tape_from_scene(const Scene& scene, const View& view) {
  Tape tape;
  TapeMaker().make(scene, view, tape);
  return tape;
}

void TapeMaker::make(const Scene& scene, const View& view, Tape& tape) {
  tape.outlines.clear(), tape.steps.clear(), tape.layers.clear();
  tape.paints.clear(), tape.distances.clear(), tape.groups.clear();
  tape.blend = view.blend;
  tape.dither = view.dither;
  tape.background = mix_from_color(view.background.value_or(scene.background()), view.blend);
  const auto map = pixel_from_face(scene.canvas(), view);
  AreaSteps areas(scene, map, tape, todo_, written_);
  PaintMaker paints(scene, view, map, tape);
  add_groups(scene, tape, groups_);
  for (std::size_t i = scene.layers().size(); i-- > 0;) {
    const Layer& layer = scene.layers()[i];
    const int first = int(tape.steps.size());
    areas.add(layer.area);
    TapeLayer made{.first = first, .count = int(tape.steps.size()) - first, .mix = Mix{0.0}};
    paints.add(layer.paint, made);
    if (layer.group >= 0) made.group = groups_[std::size_t(layer.group)];
    tape.layers.push_back(made);
  }
}

}  // namespace mien
