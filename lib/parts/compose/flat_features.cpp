// What parts drew, found by name, and what moves with what.

#include "lib/parts/compose/flat_feature.h"

#include <algorithm>

namespace mien {

const FlatFeatures::One* FlatFeatures::find(std::string_view name) const {
  const int found = feature_of_.find(name, [&](int i) { return features_[std::size_t(i)].name; });
  return found < 0 ? nullptr : &features_[std::size_t(found)];
}

void FlatFeatures::add(One feature) {
  feature_of_.enter(feature.name, int(features_.size()));
  features_.push_back(feature);
}

void FlatFeatures::stand_still(std::string_view feature) {
  const int found =
      feature_of_.find(feature, [&](int i) { return features_[std::size_t(i)].name; });
  features_[std::size_t(found)].still = true;
  still_.push_back(feature);
}

void FlatFeatures::sort() {
  std::stable_sort(features_.begin(), features_.end(), drawn_before);
  feature_of_ = {};
  for (std::size_t i = 0; i < features_.size(); ++i) feature_of_.enter(features_[i].name, int(i));
}

void FlatFeatures::add_ride(std::string_view with, Ride ride) {
  const int made = int(rides_.size());
  rides_.push_back(ride);
  const int known = ridden_of_.find(with, [&](int i) { return ridden_[std::size_t(i)].slice; });
  if (known < 0) {
    ridden_of_.enter(with, int(ridden_.size()));
    ridden_.push_back({with, made, made});
    return;
  }
  Ridden& ridden = ridden_[std::size_t(known)];
  rides_[std::size_t(ridden.last)].next = made, ridden.last = made;
}

}  // namespace mien
