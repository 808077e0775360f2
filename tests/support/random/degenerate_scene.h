#pragma once
// Scenes whose points all lie on a small lattice, or nearly so, by a seed: what general position
// leaves out. Vertices shared by many shapes, fans, coincident, reversed and collinear edges, tangent
// circles, paths over themselves, strokes with cusps, widths and radii of zero.

#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// Eight shapes and nine layers of them and of their combinations, in plain colours, some translucent,
/// on a canvas of 16 × 16 units. `jitter`: how far points and sizes may leave the lattice.
Scene degenerate_scene(std::uint64_t seed, double jitter);

}  // namespace mien::test
