#pragma once
// Scenes of strokes in rows, by a seed.

#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// Three layers of rows of tapered strokes, thick and as thin as 1/100 px, on a canvas of 2 × 2 units. Most strokes go
/// on as the one before, in place, way and width, some only in place; some rows are drawn a second time, mirrored, beside
/// themselves or at a level.
Scene stroke_scene(std::uint64_t seed);

}  // namespace mien::test
