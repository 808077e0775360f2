#pragma once
// Scenes that are the same, number for number, and what two of them have in common: most of a face
// stands still from frame to frame. Names do not count.

#include <mien/scene.h>

#include <cstdint>
#include <vector>

namespace mien {

/// Whether they are the same picture in every number. Ends at the first that differs.
bool same_scene(const Scene& a, const Scene& b);

/// How many shapes are the same in both at the same place of their lists.
int shapes_in_common(const Scene& a, const Scene& b);

/// A fingerprint of every layer's paint and of the areas that it depends on: gradient, relief and colour. Different
/// layers have different ones, even if their paints are equal.
class PaintFingerprints {
 public:
  /// `seed` stands for all else that paints depend on.
  void make(const Scene& scene, std::uint64_t seed);
  std::uint64_t of_layer(std::size_t i) const { return paints_[i]; }

 private:
  std::vector<std::uint64_t> areas_;  ///< by node
  std::vector<std::uint64_t> paints_, sorted_;
};

}  // namespace mien
