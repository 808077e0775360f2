#include <mien/scene_from_face.h>

#include <mien/face_model.h>
#include <mien/feature_at.h>
#include "draw_face_private.h"
#include "feature_areas_private.h"
#include "feature_paint_private.h"
#include "outline_pen_private.h"

#include <glm/geometric.hpp>
#include <utility>

namespace mien {
namespace {

std::string layer_name(const Feature& feature, std::string_view ending) {
  return std::string(feature.name).append(ending);
}

/// Which way in the picture the lamp does not shine; down, if it shines straight.
glm::dvec2 away_from_lamp(const FaceModel& model) {
  const glm::dvec2 to{model.light.direction.x,
                      model.light.direction.y * (model.canvas.y_up ? 1 : -1)};
  const double length = glm::length(to);
  return length > 0 ? -to / length : glm::dvec2{0, model.canvas.y_up ? -1 : 1};
}

Light light_of(const FaceLight& light) {
  return {.direction = light.direction, .ambient = light.ambient};
}

/// The line along a feature's outline.
Area contour_of(const Feature& feature, const Surroundings::Contour& line, Area area,
                const Face& face, const FeatureAreas& areas, SceneBuilder& build) {
  if (line.by == FaceContour::By::none) return contour(build, area, line.thin);
  if (line.by == FaceContour::By::angle)
    return pen_contour(build, area, line.thin, line.thick, away_from_lamp(*face.model));
  Area all = build.shape(Path{});
  for (Shape& piece : outline_pen(feature.figure, face, line.thin, line.thick))
    all = build.unite(all, build.shape(std::move(piece)));
  return areas.clipped(all, feature);
}

void draw_feature(Index<Feature> i, const Face& face, const FeatureAreas& areas,
                  SceneBuilder& build) {
  const Feature& feature = i.in(face.model->features);
  Surroundings around = surroundings_of(feature, face);
  if (around.shadow) {
    if (around.shadow_on) around.shadow->on = areas.of(around.shadow_on);
    soft_shadow(build, layer_name(feature, kShadowLayer), areas.of(i), *around.shadow);
  }
  if (around.glow) glow(build, layer_name(feature, kGlowLayer), areas.of(i), *around.glow);
  if (feature.painted())
    build.layer(std::string(feature.name), areas.of(i), paint_of(feature, face, areas.figure(i)));
  if (around.contour)
    build.layer(layer_name(feature, kContourLayer),
                contour_of(feature, *around.contour, areas.of(i), face, areas, build),
                {around.contour->color});
}

}  // namespace

SceneBuilder begin_face(const Face& face) {
  const FaceModel& model = *face.model;
  return {{model.canvas.box, model.canvas.y_up}, color_of(face, model.background)};
}

void draw_face(const Face& face, SceneBuilder& build) {
  const FaceModel& model = *face.model;
  FeatureAreas areas(face, build);
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
                         opened.clip ? areas.of(opened.clip) : Area{}, opened.mix);
      }
    }
    areas.add(i);
    draw_feature(i, face, areas, build);
  }
  if (group) build.close_group();
}

Scene scene_from_face(const Face& face) {
  SceneBuilder build = begin_face(face);
  draw_face(face, build);
  return std::move(build).finish();
}

}  // namespace mien
