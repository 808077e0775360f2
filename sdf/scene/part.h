#pragma once
// A scene of some layers of another one: what a window of a crowded picture needs.

#include <mien/scene.h>

#include <span>
#include <unordered_map>

namespace mien {

/// A step of an area's program, in postfix order: a shape's {distance <= level}, or Op::complement, intersect, unite.
struct PartStep {
  Op op;
  int shape = -1;    ///< of the whole scene, for Op::shape
  double level = 0;  ///< [face units]
};

/// A layer of the whole scene.
struct PartLayer {
  int layer;
  /// What its area is in the part that is seen: as it is; everywhere there; or `steps`.
  enum class In : unsigned char { own, everywhere, steps } in = In::own;
  std::span<const PartStep> steps = {};
};

/// Makes such scenes; keeps its scratch.
class ScenePart {
 public:
  /// `layers`: rising. Groups stay as they are; areas that were shared are
  /// shared.
  Scene make(const Scene& whole, std::span<const PartLayer> layers, const Canvas& canvas);

 private:
  Area copy(Area area);
  Area shape(int index);
  Area made_of(std::span<const PartStep> steps);
  Area everywhere();
  Paint copy(const Paint& paint);
  void open_groups_of(int group);

  const Scene* whole_ = nullptr;
  SceneBuilder* build_ = nullptr;
  std::unordered_map<int, Area> known_;   ///< by the whole scene's node
  std::unordered_map<int, Area> shapes_;  ///< by the whole scene's shape
  std::vector<Area> stack_;
  Area everywhere_;
  std::vector<int> todo_;
  std::vector<int> open_, chain_;  ///< groups, from the outside in
};

}  // namespace mien
