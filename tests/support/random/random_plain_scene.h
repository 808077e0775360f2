#pragma once
// Scenes of every shape and operator in plain colours, some of them translucent, by a seed.

#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// Six shapes of random kinds, about the size of the picture (2 × 2 units) or much smaller, and five
/// layers of random combinations of them.
Scene random_plain_scene(std::uint64_t seed);

}  // namespace mien::test
