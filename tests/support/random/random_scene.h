#pragma once
// Scenes of every shape, operator, paint and transparency, by a seed.

#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// A shape of a random kind, about the size of the picture (2 × 2 units) or much smaller, in five
/// layers by random combinations; gradients, groups and clips of groups among them.
Scene random_painted_scene(std::uint64_t seed);

}  // namespace mien::test
