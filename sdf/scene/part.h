#pragma once
// A scene of some layers of another one: what a window of a crowded picture needs.

#include <mien/scene.h>

#include <span>
#include <unordered_map>

namespace mien {

/// A layer of the whole scene.
struct PartLayer {
  int layer;
  bool covers = false;  ///< it covers the whole part that is seen, so it needs no outline there
};

/// Makes such scenes; keeps its scratch.
class ScenePart {
 public:
  /// `layers`: rising. Groups stay as they are; areas that were shared are
  /// shared.
  Scene make(const Scene& whole, std::span<const PartLayer> layers, const Canvas& canvas);

 private:
  Area copy(Area area);
  Paint copy(const Paint& paint);
  void open_groups_of(int group);

  const Scene* whole_ = nullptr;
  SceneBuilder* build_ = nullptr;
  std::unordered_map<int, Area> known_;  ///< by the whole scene's node
  std::vector<int> todo_;
  std::vector<int> open_, chain_;  ///< groups, from the outside in
};

}  // namespace mien
