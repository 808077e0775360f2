#pragma once
// Scenes that are small as data and large as work, in the canvas [−1, 1]².

#include <mien/scene.h>

#include <string>
#include <vector>

namespace mien::test {

struct HostileScene {
  std::string name;
  Scene scene;
};

/// Paths on a lattice, paths without area, long strokes, reliefs, gradients and feathers along paths of many points,
/// each also cut to areas, in groups and under both fill rules. `size` 1: what the documents promise to draw.
std::vector<HostileScene> hostile_scenes(double size);

}  // namespace mien::test
