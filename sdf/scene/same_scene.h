#pragma once
// Scenes that are the same, number for number, and what two of them have in common: most of a face
// stands still from frame to frame. Names do not count.

#include <mien/scene.h>

#include <vector>

namespace mien {

/// Whether they are the same picture in every number. Ends at the first that differs.
bool same_scene(const Scene& a, const Scene& b);

/// What two scenes have in common at the same places of their lists.
class InCommon {
 public:
  /// They are referred to. Whether all is the same but for shapes, areas and layers, and there are equally many of
  /// these; if not, no more is found.
  bool find(const Scene& a, const Scene& b);

  /// Whether a layer has the same area's number, group and paint, and the areas that its paint reads are the same.
  bool layer(std::size_t i) const;

 private:
  bool area(Area a) const { return a.node < 0 || same_[std::size_t(a.node)]; }

  const Scene *a_ = nullptr, *b_ = nullptr;
  std::vector<char> same_;  ///< by node
};

}  // namespace mien
