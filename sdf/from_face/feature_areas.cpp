#include "feature_areas_private.h"

#include <mien/face_model.h>
#include "sdf/from_face/figure/face_numbers_private.h"
#include "sdf/from_face/figure/shape_private.h"

#include <algorithm>
#include <utility>

namespace mien {

FeatureAreas::FeatureAreas(const Face& face, SceneBuilder& build)
    : face_(face),
      build_(build),
      areas_(face.model->features.size()),
      figures_(face.model->features.size()) {}

void FeatureAreas::add(Index<Feature> feature) {
  const Feature& f = feature.in(face_.model->features);
  Area& area = areas_[std::size_t(feature.at)];
  Area& figure = figures_[std::size_t(feature.at)];
  const auto same = std::find_if(f.clips.begin(), f.clips.end(), [&](const FeatureClip& clip) {
    return !clip.outside &&
           same_figure(f.figure, clip.feature.in(face_.model->features).figure, face_);
  });
  if (same == f.clips.end()) {
    figure = own(f);
    area = clipped(figure, f);
    return;
  }
  // The very same outline: no seam, and no second outline to resolve.
  figure = this->figure(same->feature);
  Feature others;
  for (auto clip = f.clips.begin(); clip != f.clips.end(); ++clip)
    if (clip != same) others.clips.push_back(*clip);
  area = clipped(of(same->feature), others);
}

Area FeatureAreas::clipped(Area area, const Feature& feature) const {
  for (const FeatureClip& clip : feature.clips)
    area = clip.outside ? build_.subtract(area, of(clip.feature))
                        : build_.intersect(area, of(clip.feature));
  return area;
}

Area FeatureAreas::own(const Feature& f) const {
  if (const auto* area = std::get_if<AreaFigure>(&f.figure)) return made_of(*area);
  std::vector<Shape> pieces = pieces_of(f.figure, face_);
  if (pieces.empty()) {
    const Area core = build_.shape(shape_of(f.figure, face_));
    const auto* rounded = std::get_if<RoundedFigure>(&f.figure);
    return rounded ? build_.offset(core, corner_of(*rounded, face_)) : core;
  }
  Area all = build_.shape(std::move(pieces[0]));
  for (std::size_t i = 1; i < pieces.size(); ++i)
    all = build_.unite(all, build_.shape(std::move(pieces[i])));
  return all;
}

Area FeatureAreas::made_of(const AreaFigure& figure) const {
  Area area;
  for (const Index<Feature> f : figure.any)
    area = area.node < 0 ? of(f) : build_.unite(area, of(f));
  for (const Index<Feature> f : figure.all)
    area = area.node < 0 ? of(f) : build_.intersect(area, of(f));
  for (const Index<Feature> f : figure.minus) area = build_.subtract(area, of(f));
  return figure.grow < 0 ? area : build_.offset(area, FaceNumbers(face_)(figure.grow));
}

}  // namespace mien
