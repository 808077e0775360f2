#include <mien/scene_from_face.h>

#include <mien/face_model.h>
#include "draw_face_private.h"
#include "feature_paint_private.h"
#include "figure_shape_private.h"

#include <span>
#include <utility>
#include <vector>

namespace mien {
namespace {

/// The areas of features, built when first asked for.
class Areas {
 public:
  Areas(const Face& face, SceneBuilder& build)
      : face_(face),
        build_(build),
        areas_(face.model->features.size()),
        figures_(face.model->features.size()) {}

  /// Everything of the feature that may be painted: its figure within its clip. Clips are earlier
  /// features, so one pass in order meets them before it needs them.
  Area of(Index<Feature> feature) { return areas_[std::size_t(feature.at)]; }
  /// Its figure alone.
  Area figure(Index<Feature> feature) { return figures_[std::size_t(feature.at)]; }

  void add(Index<Feature> feature) {
    const Feature& f = feature.in(face_.model->features);
    Area& area = areas_[std::size_t(feature.at)];
    Area& figure = figures_[std::size_t(feature.at)];
    if (f.clip && covers_its_clip(f)) {
      area = of(f.clip);  // the very same outline: no seam, and no second outline to resolve
      figure = this->figure(f.clip);
      return;
    }
    area = figure = own(f);
    if (f.clip) area = build_.intersect(figure, of(f.clip));
  }

 private:
  Area own(const Feature& f) {
    std::vector<Shape> pieces = pieces_of(f.figure, face_);
    if (pieces.empty()) return build_.shape(shape_of(f.figure, face_));
    Area all = build_.shape(std::move(pieces[0]));
    for (std::size_t i = 1; i < pieces.size(); ++i)
      all = build_.unite(all, build_.shape(std::move(pieces[i])));
    return all;
  }

  /// Whether the feature has the same outline as the one it is clipped to, number for number.
  bool covers_its_clip(const Feature& f) const {
    return same_figure(f.figure, f.clip.in(face_.model->features).figure, face_);
  }

  const Face& face_;
  SceneBuilder& build_;
  std::vector<Area> areas_, figures_;
};

Light light_of(const FaceLight& light) {
  return {.direction = light.direction, .ambient = light.ambient};
}

}  // namespace

SceneBuilder begin_face(const Face& face) {
  const FaceModel& model = *face.model;
  return {{model.canvas.box, model.canvas.y_up}, color_of(face, model.background)};
}

void draw_face(const Face& face, SceneBuilder& build) {
  const FaceModel& model = *face.model;
  Areas areas(face, build);
  build.light(light_of(model.light));
  Index<FaceGroup> group;
  for (Index<Feature> i{0}; i.at < int(model.features.size()); ++i.at) {
    const Feature& feature = i.in(model.features);
    if (feature.group != group) {
      if (group) build.close_group();
      group = feature.group;
      if (group) {
        const FaceGroup& opened = group.in(model.groups);
        build.open_group(opened.name, opacity_of(face, opened.opacity),
                         opened.clip ? areas.of(opened.clip) : Area{});
      }
    }
    areas.add(i);
    const Surroundings around = surroundings_of(feature, face);
    if (around.shadow) soft_shadow(build, feature.name + "/shadow", areas.of(i), *around.shadow);
    if (around.glow) glow(build, feature.name + "/glow", areas.of(i), *around.glow);
    if (feature.painted())
      build.layer(feature.name, areas.of(i), paint_of(feature, face, areas.figure(i)));
    if (around.contour)
      build.layer(feature.name + "/contour",
                  contour(build, areas.of(i), around.contour->half_width), {around.contour->color});
  }
  if (group) build.close_group();
}

Scene scene_from_face(const Face& face) {
  SceneBuilder build = begin_face(face);
  draw_face(face, build);
  return std::move(build).finish();
}

}  // namespace mien
