#pragma once
#include <mien/scene.h>

#include "tests/support/random.h"

namespace mien::test {

/// The scene with one thing of it changed, or none: a shape moved, a layer's colour, gradient or
/// relief, a layer left out or doubled, a group's opacity, the ground, the light.
Scene changed_scene(const Scene& scene, Random& random);

}  // namespace mien::test
