#pragma once
// Scenes of many shapes: what a picture costs as they grow in number.

#include <mien/scene.h>

#include <optional>
#include <span>
#include <string_view>

namespace mien::bench {

enum class Crowd {
  discs,        ///< opaque, radii 2 … 40 px
  translucent,  ///< the same discs, half-transparent
  strokes,      ///< bent lines 1 … 6 px wide, 20 … 120 px long
  text          ///< words of DejaVu Sans, 8 … 24 px
};

inline constexpr int kCrowdSide = 512;  ///< [px] of the square picture

/// Those that this build has: text needs mien::text.
std::span<const Crowd> crowds();
std::string_view crowd_name(Crowd crowd);

/// `count` shapes at random places on white, one unit a pixel; the same for the same seed. With
/// every `step` (of a hundred) all places and lengths are a hundred-thousandth smaller.
Scene crowd_scene(Crowd crowd, int count, unsigned seed, int step = 0);

}  // namespace mien::bench
