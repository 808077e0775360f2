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
  Area of(int feature) { return areas_[std::size_t(feature)]; }
  /// Its figure alone.
  Area figure(int feature) { return figures_[std::size_t(feature)]; }

  void add(int feature) {
    const Feature& f = face_.model->features[std::size_t(feature)];
    Area& area = areas_[std::size_t(feature)];
    Area& figure = figures_[std::size_t(feature)];
    if (f.clip >= 0 && covers_its_clip(f)) {
      area = of(f.clip);  // the very same outline: no seam, and no second outline to resolve
      figure = figures_[std::size_t(f.clip)];
      return;
    }
    area = figure = own(f);
    if (f.clip >= 0) area = build_.intersect(figure, of(f.clip));
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
    return same_figure(f.figure, face_.model->features[std::size_t(f.clip)].figure, face_);
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
  int group = -1;
  for (int i = 0; i < int(model.features.size()); ++i) {
    const Feature& feature = model.features[std::size_t(i)];
    if (feature.group != group) {
      if (group >= 0) build.close_group();
      group = feature.group;
      if (group >= 0) {
        const FaceGroup& opened = model.groups[std::size_t(group)];
        build.open_group(opened.name, opacity_of(face, opened.opacity),
                         opened.clip < 0 ? Area{} : areas.of(opened.clip));
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
  if (group >= 0) build.close_group();
}

Scene scene_from_face(const Face& face) {
  SceneBuilder build = begin_face(face);
  draw_face(face, build);
  return std::move(build).finish();
}

}  // namespace mien
