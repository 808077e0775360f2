#pragma once
#include <mien/scene.h>

#include <cstdint>

#include "tests/support/random/random.h"

namespace mien::test {

/// The scene with one thing of it changed, or none: a shape moved, a layer's colour, gradient or
/// relief, a layer left out or doubled, a group's opacity or mode, the ground, the light.
Scene changed_scene(const Scene& scene, Random& random);

/// The scene with groups that mix by every mode, more often opaque than not. Where it has no groups, some of its
/// layers become one.
Scene mixed_scene(const Scene& scene, std::uint64_t seed);

}  // namespace mien::test
