#include "render/shade/paint_table.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kLeast = 1e-9;  // [px] gradients shorter than that are sudden changes
// Of one ramp in a picture: means by its integral cost less than more outlines than that. They cost next to nothing
// along a line, more where level lines bend, and most under light.
constexpr int kMostStraight = 8, kMostBent = 40, kMostAlong = 3, kMostLit = 96;
constexpr double kEven = 1e4;  // periods across a pixel, whose mean then is theirs to within 1e-4

}  // namespace

/// Makes paints, each in the place of one of the picture before: its memory is kept.
class PaintMaker {
 public:
  PaintMaker(const Scene& scene, const View& view, Depth depth, PaintTable& to)
      : scene_(scene),
        view_(view),
        map_(grid_from_face(scene.canvas(), view)),
        tolerance_(depth == Depth::u8 ? 0.3 / 255 : 0.06 / 255),
        to_(to) {}

  PaintedLayer layer(const Layer& layer) {
    PaintedLayer made{.program = to_.programs.add(layer.area)};
    const Paint& paint = layer.paint;
    made.mix = mix_from_color(paint.color, view_.blend);
    if (!paint.gradient && !paint.relief) return made;
    VariedPaint& varied = next();
    varied.paint.color = made.mix;
    if (paint.gradient) {
      if (varied.paint.ramp)
        varied.paint.ramp->make(*paint.gradient, paint.color.a, view_.blend);
      else
        varied.paint.ramp.emplace(*paint.gradient, paint.color.a, view_.blend);
      const bool straight = std::holds_alternative<LinearGradient>(paint.gradient->along);
      const bool around = std::holds_alternative<DistanceGradient>(paint.gradient->along);
      most_ = paint.relief ? kMostLit : straight ? kMostStraight : around ? kMostAlong : kMostBent;
      std::visit([&](const auto& along) { field(along, varied); }, paint.gradient->along);
    }
    if (!paint.gradient) varied.paint.ramp.reset();
    const bool by_distance =
        varied.paint.ramp && varied.paint.field.kind == PaintField::Kind::distance;
    if (paint.relief)
      relief(*paint.relief, layer.area, varied);
    else if (by_distance)
      varied.paint.relief.emplace(GridRelief{.lamp = Lamp(light(), 0.0, 1.0)});  // a level one
    else
      varied.paint.relief.reset();
    if (!varied.paint.ramp && !varied.paint.relief) {
      made.mix = varied.paint.color, --varied_;
      return made;
    }
    if (varied.paint.relief) varied.lit = 0;
    made.varied = int(varied_) - 1;
    return made;
  }

  /// Drops what is left of the picture before.
  void finish() {
    to_.varied.resize(varied_);
    to_.distances.resize(distances_);
  }

 private:
  VariedPaint& next() {
    if (varied_ == to_.varied.size()) to_.varied.emplace_back();
    VariedPaint& varied = to_.varied[varied_++];
    varied.paint.field = {};
    varied.kinks.clear(), varied.levels.clear(), varied.domes.clear();
    varied.by_integral = false;
    varied.tolerance = tolerance_, varied.linear = view_.blend == Blend::linear;
    varied.lowest = varied.highest = 0, varied.lit = -1;
    return varied;
  }

  /// The places t between lo and hi, a whole picture's, where outlines are made of the ramp's kinks; t changes by at
  /// least so much per pixel. Too many for that: none.
  const std::vector<double>& places(VariedPaint& varied, double lo, double hi, double per_pixel) {
    const Ramp& ramp = *varied.paint.ramp;
    varied.lowest = lo, varied.highest = hi;
    if (ramp.kinks(lo, hi, most_, to_.kinks_)) return to_.kinks_;
    varied.by_integral = true, varied.integral.make(ramp);
    if (ramp.extend() != Extend::pad && !(per_pixel < kEven * varied.integral.period()))
      one_color(varied, varied.integral.mean());
    // [px] Ends that outlines do not keep apart are none.
    constexpr double kApart = 0x1p-16;
    if (to_.kinks_.size() == 2 && to_.kinks_[1] - to_.kinks_[0] < kApart * per_pixel)
      to_.kinks_.clear();
    return to_.kinks_;
  }

  /// Instead of the gradient.
  static void one_color(VariedPaint& varied, Mix mix) {
    varied.paint.color = mix;
    varied.paint.ramp.reset(), varied.by_integral = false;
    varied.paint.field = {};
  }

  void field(const LinearGradient& g, VariedPaint& varied) {
    PaintField& f = varied.paint.field;
    const glm::dvec2 from = map_(g.from), way = map_(g.to) - from;
    if (way == glm::dvec2{0.0}) return one_color(varied, varied.paint.ramp->mixes().back());
    const double own = std::hypot(way.x, way.y), length = std::max(own, kLeast);
    f.kind = PaintField::Kind::linear;
    f.across = own < kLeast ? way / own / kLeast : way / (length * length),
    f.shift = -glm::dot(from, f.across);
    f.per_pixel = glm::length(f.across);
    const glm::dvec2 half{0.5 * view_.width, 0.5 * view_.height};
    const double middle = f.at(half, 0.0), reach = f.per_pixel * glm::length(half);
    const glm::dvec2 ahead = (g.to - g.from) / std::hypot(g.to.x - g.from.x, g.to.y - g.from.y);
    for (const double t : places(varied, middle - reach, middle + reach, f.per_pixel))
      varied.kinks.push_back({to_.programs.add(HalfPlane{
                                  ahead, glm::dot(g.from, ahead) + t * glm::length(g.to - g.from)}),
                              false, t});
  }

  void field(const RadialGradient& g, VariedPaint& varied) {
    if (!(g.radii.x > 0.0 && g.radii.y > 0.0))
      return one_color(varied, varied.paint.ramp->mixes().back());
    PaintField& f = varied.paint.field;
    f.kind = PaintField::Kind::radial, f.center = map_(g.center);
    f.unit = unit(g.radii, g.axis);
    f.per_pixel = 1.0 / (map_.scale() * std::max(std::min(g.radii.x, g.radii.y), kLeast));
    double most = 0.0;
    for (const double x : {0.0, double(view_.width)})
      for (const double y : {0.0, double(view_.height)}) most = std::max(most, f.at({x, y}, 0.0));
    const double least = 1.0 / (map_.scale() * std::max({g.radii.x, g.radii.y, kLeast}));
    for (const double t : places(varied, 0.0, most, least))
      varied.kinks.push_back(
          {to_.programs.add(Ellipse{g.center, t * glm::max(g.radii, kLeast / map_.scale()),
                                    glm::normalize(g.axis)}),
           false, t});
  }

  void field(const DistanceGradient& g, VariedPaint& varied) {
    PaintField& f = varied.paint.field;
    const double length = (g.to - g.from) * map_.scale();
    f.kind = PaintField::Kind::distance, f.distance = distance(g.area);
    f.from = g.from * map_.scale();
    f.scale = 1.0 / (std::abs(length) > kLeast ? length : std::copysign(kLeast, length));
    if (g.to == g.from) varied.paint.ramp->pad();
    f.per_pixel = std::abs(f.scale);
    if (most_ == kMostAlong && varied.paint.ramp->jumps()) most_ = kMostBent;
    // A distance is at most that of the picture's middle and half a diagonal.
    const glm::dvec2 half{0.5 * view_.width, 0.5 * view_.height};
    const double middle = f.at(half, to_.distances[std::size_t(f.distance)].at(half)),
                 reach = f.per_pixel * glm::length(half);
    for (const double t : places(varied, middle - reach, middle + reach, f.per_pixel))
      varied.kinks.push_back(
          {to_.programs.add(g.area, (f.from + t / f.scale) / map_.scale()), f.scale < 0.0, t});
  }

  /// Takes an ellipse's points, seen from its centre, to the unit circle.
  glm::dmat2 unit(glm::dvec2 radii, glm::dvec2 axis) const {
    const glm::dvec2 u = glm::normalize(map_.linear * axis), v{-u.y, u.x};
    const double a = map_.scale() * std::max(radii.x, kLeast),
                 b = map_.scale() * std::max(radii.y, kLeast);
    return glm::dmat2{u.x / a, v.x / b, u.y / a, v.y / b};  // columns
  }

  void relief(const Relief& r, Area layer, VariedPaint& varied) {
    const Lamp lamp(light(), r.specular, r.shininess);
    if (!varied.paint.relief) varied.paint.relief.emplace(GridRelief{.lamp = lamp});
    GridRelief& made = *varied.paint.relief;
    made.lamp = lamp, made.profile = r.profile, made.distance = -1;
    made.own = r.area.node == layer.node;
    if (r.area.node >= 0 && r.profile != Profile::flat) made.distance = distance(r.area);
    if (r.profile == Profile::custom && r.table.size() < 2) made.profile = Profile::flat;
    made.width = std::max(r.width * map_.scale(), kLeast);
    made.height = r.height * map_.scale();
    made.table = r.table;
    made.domes.clear();
    for (const Dome& dome : r.domes) {
      if (dome.height == 0.0) continue;
      made.domes.push_back({map_(dome.center), unit(dome.radii, dome.axis),
                            dome.height * map_.scale(),
                            map_.scale() * std::max(dome.radii.x, dome.radii.y)});
      varied.domes.push_back(
          to_.programs.add(Ellipse{dome.center, dome.radii, glm::normalize(dome.axis)}));
    }
  }

  Light light() const {
    Light light = scene_.light();
    if (view_.light) light.direction = *view_.light;
    return light;
  }

  int distance(Area area) {
    int& known = to_.distance_[std::size_t(area.node)];
    if (known >= 0) return known;
    known = int(distances_++);
    if (to_.distances.size() < distances_) to_.distances.emplace_back();
    to_.distances[std::size_t(known)].make(
        scene_, area, Map<PixelSpace, FaceSpace>{map_.linear, map_.shift}, to_.place_);
    return known;
  }

  const Scene& scene_;
  const View& view_;
  const Map<GridSpace, FaceSpace> map_;
  const double tolerance_;  ///< of means
  PaintTable& to_;
  int most_ = 0;                            ///< kinks of the gradient at hand that may be outlines
  std::size_t varied_ = 0, distances_ = 0;  ///< made so far
};

/// The groups that count, and for every group of the scene the nearest of those it is in.
void PaintTable::make_groups(const Scene& scene) {
  groups.clear(), nearest_.clear();
  ground_.assign(scene.groups().size(), 0);
  for (const Group& group : scene.groups())
    if (group.mix != MixMode::normal && group.parent >= 0) ground_[std::size_t(group.parent)] = 1;
  for (const Group& group : scene.groups()) {
    const int parent = group.parent < 0 ? -1 : nearest_[std::size_t(group.parent)];
    if (group.opacity >= 1.0 && group.mix == MixMode::normal && !ground_[nearest_.size()]) {
      nearest_.push_back(parent);  // its layers look the same as on their own
      continue;
    }
    nearest_.push_back(int(groups.size()));
    groups.push_back({parent, group.opacity > 0.0 ? std::min(group.opacity, 1.0) : 0.0, group.mix});
  }
}

Map<GridSpace, FaceSpace> grid_from_face(const Canvas& canvas, const View& view) {
  const Map<PixelSpace, FaceSpace> map = pixel_from_face(canvas, view);
  return {map.linear, map.shift + glm::dvec2{0.5 * view.width, 0.5 * view.height}};
}

void PaintTable::make(const Scene& scene, const View& view, Depth depth) {
  programs.begin(scene);
  layers.clear();
  distance_.assign(scene.nodes().size(), -1);
  blend = view.blend;
  background = mix_from_color(view.background.value_or(scene.background()), view.blend);
  make_groups(scene);
  PaintMaker maker(scene, view, depth, *this);
  for (const Layer& layer : scene.layers()) {
    layers.push_back(maker.layer(layer));
    if (layer.group >= 0) layers.back().group = nearest_[std::size_t(layer.group)];
  }
  maker.finish();
  make_lit(scene, view, depth);
}

/// What is left of them once nothing moves in memory any more: lit paints refer to the others.
void PaintTable::make_lit(const Scene& scene, const View& view, Depth depth) {
  // [levels of 255] A mean may be off by so much: half of what a level's rounding leaves.
  const double tolerance = depth == Depth::u8 ? 0.3 : 0.02;
  const double scale = grid_from_face(scene.canvas(), view).scale();
  std::size_t made = 0;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].varied < 0) continue;
    VariedPaint& paint = varied[std::size_t(layers[i].varied)];
    if (paint.lit < 0) continue;
    paint.lit = int(made++);
    if (lit.size() < made) lit.emplace_back();
    LitPaint& now = lit[made - 1];
    now.make(paint.paint, distances, blend, glm::dvec2{0.0}, tolerance, paint.lit);
    for (const double level : now.levels())
      paint.levels.push_back(programs.add(scene.layers()[i].paint.relief->area, level / scale));
  }
  lit.resize(made);
}

}  // namespace mien
