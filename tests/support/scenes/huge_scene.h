#pragma once
// Scenes in which a third of all coordinates are far outside the picture, by a seed.

#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// Six layers of shapes on a canvas of 2 × 2 units; a third of their coordinates and sizes are up to
/// ±6000 units, a hundred thousand pixels beside a picture 32 pixels wide.
Scene huge_scene(std::uint64_t seed);

}  // namespace mien::test
