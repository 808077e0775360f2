#include <mien/sdf/from_face/scene_from_face.h>

#include <mien/lib/face/face_model.h>
#include "figure_shape_private.h"

#include <span>
#include <utility>
#include <vector>

namespace mien {
namespace {

Color color_of(const Face& face, int slice) {
  const double* c = &face.vector[std::size_t(face.model->layout[slice].begin)];
  return {c[0], c[1], c[2], c[3]};
}

/// The areas of features, built when first asked for.
class Areas {
 public:
  Areas(const Face& face, SceneBuilder& build)
      : face_(face), build_(build), areas_(face.model->features.size()) {}

  /// Everything of the feature that may be painted: its figure within its clip. Clips are earlier
  /// features, so one pass in order meets them before it needs them.
  Area of(int feature) { return areas_[std::size_t(feature)]; }

  void add(int feature) {
    const Feature& f = face_.model->features[std::size_t(feature)];
    Area& area = areas_[std::size_t(feature)];
    if (f.clip < 0)
      area = own(f);
    else if (covers_its_clip(f))
      area = of(f.clip);  // the very same outline: no seam, and no second outline to resolve
    else
      area = build_.both(own(f), of(f.clip));
  }

 private:
  Area own(const Feature& f) {
    std::vector<Shape> pieces = pieces_of(f.figure, face_);
    if (pieces.empty()) return build_.shape(shape_of(f.figure, face_));
    Area all = build_.shape(std::move(pieces[0]));
    for (std::size_t i = 1; i < pieces.size(); ++i)
      all = build_.either(all, build_.shape(std::move(pieces[i])));
    return all;
  }

  /// Whether the feature has the same outline as the one it is clipped to, number for number.
  bool covers_its_clip(const Feature& f) const {
    return same_figure(f.figure, face_.model->features[std::size_t(f.clip)].figure, face_);
  }

  const Face& face_;
  SceneBuilder& build_;
  std::vector<Area> areas_;
};

}  // namespace

Scene scene_from_face(const Face& face) {
  const FaceModel& model = *face.model;
  SceneBuilder build({model.canvas.box, model.canvas.y_up}, color_of(face, model.background));
  Areas areas(face, build);
  for (int i = 0; i < int(model.features.size()); ++i) {
    const Feature& feature = model.features[std::size_t(i)];
    areas.add(i);
    if (feature.paint >= 0) build.layer(feature.name, areas.of(i), {color_of(face, feature.paint)});
  }
  return std::move(build).finish();
}

}  // namespace mien
