// Leaves in vectors: sixteen 4 × 4 blocks are placed against every edge at once; blocks that one
// edge crosses take its area in each of their pixels at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/tile/leaf_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_blocks-inl.h>
#include <mien/render/tile/leaf_place-inl.h>

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The blocks that no edge crosses; all of a whole leaf, most of which others go over again.
HWY_INLINE void Fill(const Leaf& leaf, const Placed& placed, std::uint32_t blocks,
                     std::uint32_t* pixels, size_t stride) {
  if (blocks == 0xFFFF) {
    alignas(64) std::uint32_t colors[kBlock];
    for (size_t b = 0; b < kBlock; ++b) colors[b] = leaf.packed[std::size_t(placed.base[b])];
    return FillLeaf(colors, pixels, stride);
  }
  for (; blocks; blocks &= blocks - 1) {
    const auto b = std::size_t(std::countr_zero(blocks));
    FillBlock(leaf.packed[std::size_t(placed.base[b])], pixels + b / 4 * 4 * stride + b % 4 * 4,
              stride);
  }
}

/// Blocks that one edge alone crosses, in runs between the same two colours.
template <bool kLinear>
HWY_INLINE void PaintOnce(const Leaf& leaf, const Placed& placed, int e, std::uint32_t* pixels,
                          size_t stride, LeafPixels& left) {
  const LeafEdge& edge = leaf.edges[std::size_t(e)];
  Use use = UseOf(edge, 0.0f, 0.0f, leaf.blend);
  const bool varies = edge.has_end() || edge.joined;
  std::uint32_t rest = placed.crossed[e] & ~placed.twice;
  while (rest) {
    const auto first = std::size_t(std::countr_zero(rest));
    const auto base = std::uint32_t(placed.base[first]);
    std::uint32_t run = rest & BlocksWith(placed, base), simple = 0, beyond = 0;
    rest &= ~run;
    if (leaf.same[base] == leaf.same[base | 1u << e]) continue;
    left.edge_blocks |= run;
    if (!varies && use.strips == 1) simple = run, run = 0;
    for (; run; run &= run - 1) {
      const int b = std::countr_zero(run);
      if (varies) use = UseOf(edge, kBlocks.x[b], kBlocks.y[b], leaf.blend);
      std::uint32_t* const to = pixels + size_t(b / 4 * 4) * stride + size_t(b % 4 * 4);
      if (use.tight || use.part == Part::both) {
        Use uses[Leaf::kMostEdges];
        uses[e] = use;
        AnyEdges<kLinear>(leaf, 1u << e, base, uses, b, to, stride, left);
      } else if (use.strips == 1) {
        (edge.joined && use.part == Part::end ? beyond : simple) |= 1u << b;
      } else {
        OneEdge<kLinear>(leaf, edge, base, base | 1u << e, kBlocks.x[b], kBlocks.y[b], use.strips,
                         use.part, to, stride);
      }
    }
    const Simple both[] = {{std::uint8_t(e), std::uint8_t(base), false, simple},
                           {std::uint8_t(e), std::uint8_t(base), true, beyond}};
    for (const Simple& blocks : both)
      if (blocks.blocks) SimpleRun<kLinear>(leaf, blocks, pixels, stride);
  }
}

template <bool kLinear>
HWY_INLINE void Paint(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, size_t stride,
                      LeafPixels& left) {
  Placed placed;
  Place(leaf, blocks, placed);
  Fill(leaf, placed, blocks, pixels, stride);
  for (int e = 0; e < leaf.edge_count; ++e)
    PaintOnce<kLinear>(leaf, placed, e, pixels, stride, left);
  for (std::uint32_t todo = placed.twice; todo; todo &= todo - 1) {
    const int b = std::countr_zero(todo);
    std::uint32_t* const to = pixels + size_t(b / 4 * 4) * stride + size_t(b % 4 * 4);
    const auto base = std::uint32_t(placed.base[b]);
    std::uint32_t active = 0;
    for (int e = 0; e < leaf.edge_count; ++e) active |= (placed.crossed[e] >> b & 1u) << e;
    active = Mattering(leaf, active, base);
    if (!active) {
      FillBlock(leaf.packed[base], to, stride);
      continue;
    }
    left.edge_blocks |= 1u << b;
    Use uses[Leaf::kMostEdges];
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const int e = std::countr_zero(rest);
      uses[e] = UseOf(leaf.edges[std::size_t(e)], kBlocks.x[b], kBlocks.y[b], leaf.blend);
    }
    const int e = std::countr_zero(active);
    if ((active & (active - 1)) != 0 || uses[e].tight || uses[e].part == Part::both)
      AnyEdges<kLinear>(leaf, active, base, uses, b, to, stride, left);
    else
      OneEdge<kLinear>(leaf, leaf.edges[std::size_t(e)], base, base | active, kBlocks.x[b],
                       kBlocks.y[b], uses[e].strips, uses[e].part, to, stride);
  }
}

void PaintLeaf(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, size_t stride,
               LeafPixels& left) {
  if (leaf.blend == Blend::linear)
    Paint<true>(leaf, blocks, pixels, stride, left);
  else
    Paint<false>(leaf, blocks, pixels, stride, left);
}

void SquareInParts(const Leaf& leaf, float x, float y, float side, std::uint32_t asked,
                   std::uint32_t base, float* rgb) {
  const Light mean = InParts(leaf, asked, base, x, y, side, side < 0.5f);
  rgb[0] = mean.r, rgb[1] = mean.g, rgb[2] = mean.b;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(PaintLeaf);
HWY_EXPORT(SquareInParts);
}  // namespace batch

void paint_leaf(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, std::size_t stride,
                LeafPixels& left) {
  HWY_DYNAMIC_DISPATCH(batch::PaintLeaf)(leaf, blocks, pixels, stride, left);
}

Mix square_in_parts(const Leaf& leaf, double x, double y, double side, std::uint32_t asked,
                    std::uint32_t base) {
  float rgb[3];
  HWY_DYNAMIC_DISPATCH(batch::SquareInParts)
  (leaf, float(x), float(y), float(side), asked, base, rgb);
  return {rgb[0], rgb[1], rgb[2], 255.0};
}

}  // namespace mien
#endif
