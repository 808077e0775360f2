#pragma once
#include <mien/scene.h>

#include <cstdint>

namespace mien::test {

/// Random shapes and combinations of them under a lamp: reliefs of every profile, dents and domes,
/// over gradients, in groups, translucent, of areas other than their own. A seed is always the same
/// scene.
Scene random_lit_scene(std::uint64_t seed);

}  // namespace mien::test
