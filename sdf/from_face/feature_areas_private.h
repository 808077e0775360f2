#pragma once
// The areas of a face's features, in a scene that is being built.

#include <mien/face.h>
#include <mien/feature.h>
#include <mien/scene.h>

#include <vector>

namespace mien {

/// What is made of features is made of earlier ones, so one pass in order meets them before it needs them.
class FeatureAreas {
 public:
  FeatureAreas(const Face& face, SceneBuilder& build);

  /// Makes the area of the next feature.
  void add(Index<Feature> feature);

  /// Everything of the feature that may be painted: its figure where its clips let it.
  Area of(Index<Feature> feature) const { return areas_[std::size_t(feature.at)]; }
  /// Its figure alone.
  Area figure(Index<Feature> feature) const { return figures_[std::size_t(feature.at)]; }

  /// What is left of an area where the feature's clips let it be.
  Area clipped(Area area, const Feature& feature) const;

 private:
  Area own(const Feature& feature) const;
  Area made_of(const AreaFigure& figure) const;

  const Face& face_;
  SceneBuilder& build_;
  std::vector<Area> areas_, figures_;
};

}  // namespace mien
