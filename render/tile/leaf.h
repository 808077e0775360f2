#pragma once
// A leaf: 16 × 16 pixels that a few smooth edges cross, and a colour for every combination of their
// sides. What the vectors draw, and what they leave to the scalar form.

#include <mien/render/blend/blender.h>
#include <mien/sdf/edge/leaf_edge.h>

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace mien {

/// Side of a leaf [px]: larger leaves are fewer, smaller ones are straighter.
inline constexpr int kLeaf = 16;

/// Everything a leaf's pixels depend on. Coordinates are relative to its centre.
struct Leaf {
  /// More edges than this in 16 × 16 pixels: ask for smaller leaves.
  static constexpr int kMostEdges = 5;
  static constexpr int kMostSides = 1 << kMostEdges;

  int edge_count = 0;
  std::array<LeafEdge, kMostEdges> edges;

  /// By sides (bit i: inside edge i): red, green, blue, alpha as Mix has them, times 255.
  alignas(64) std::array<std::array<float, kMostSides>, 4> palette;
  std::array<std::uint32_t, kMostSides> packed;  ///< the same as a pixel
  std::array<std::uint8_t, kMostSides> same;     ///< equal where the colours are
  bool opaque = true;                            ///< all of them
  Blend blend = Blend::srgb;
};

/// Pixels of a leaf, by y · 16 + x.
struct LeafPixels {
  std::array<std::uint8_t, kLeaf * kLeaf> at;
  int count = 0;
  std::uint32_t edge_blocks = 0;  ///< bit i: edges cross block i
  void add(int pixel) { at[std::size_t(count++)] = std::uint8_t(pixel); }
};

/// Draws those 4 × 4 blocks of a leaf (bit i: block i, row by row) into `pixels`, RGBA of 8 bits,
/// rows `stride` pixels apart. The colours must be opaque. Pixels that more than one edge crosses are
/// resolved in parts, and named.
void paint_leaf(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, std::size_t stride,
                LeafPixels& left);

/// What a square of a leaf sees of its edges.
struct LeafView {
  struct Sight {
    double d;      ///< [px] of the square's middle; negative inside
    glm::dvec2 n;  ///< unit, outward
    double bend;
  };
  std::array<Sight, Leaf::kMostEdges> sights;  ///< of the active edges
  std::uint32_t active = 0;  ///< edges that may cross the square and part two colours (Leaf::same)
  std::uint32_t base = 0;    ///< the sides of the others
  std::uint32_t with_end = 0;  ///< edges that may turn up in a part of the square, active or not
  bool divide =
      false;  ///< the active ones are not within `tolerance` of circles; or of straight lines,
              ///< if there are several
};
/// `asked`: edges that may cross the square; `base`: the sides of the others.
LeafView see_square(const Leaf& leaf, glm::dvec2 center, double side, double tolerance,
                    std::uint32_t asked, std::uint32_t base);

/// Where a block of 4 × 4 pixels around a place of the leaf lies against the edges, bit by bit.
struct BlockSides {
  std::uint32_t inside, crossed;  ///< crossed: may be
};
BlockSides see_block(const Leaf& leaf, glm::dvec2 center);

/// The mean colour over the square of a side, at most 1, around (x, y), times 255, by the scalar forms: any
/// number of edges, any colours. `asked`: edges that may cross it; `base`: inside which of the others it lies;
/// `tolerance`: how far an outline may be straightened [px].
Mix leaf_square(const Leaf& leaf, double x, double y, double side, std::uint32_t asked,
                std::uint32_t base, double tolerance, long long& cells);
/// The pixel around (x, y).
Mix leaf_pixel(const Leaf& leaf, double x, double y, double tolerance, long long& cells);

/// leaf_square in vectors, to the precision of 8 bits. The colours must be opaque.
Mix square_in_parts(const Leaf& leaf, double x, double y, double side, std::uint32_t asked,
                    std::uint32_t base);

/// The bend of an edge up to which paint_leaf keeps its promise.
inline constexpr double kMostLeafBend = 4.0;
/// The same for leaf_pixel: beyond, a shape is smaller than a quarter pixel.
inline constexpr double kMostPixelBend = 8.0;

}  // namespace mien
