// Where the sixteen blocks of a leaf lie against its edges, and how each sees those that cross it. Included
// once per instruction set.
#if defined(MIEN_RENDER_TILE_LEAF_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_TILE_LEAF_PLACE_INL_H_
#undef MIEN_RENDER_TILE_LEAF_PLACE_INL_H_
#else
#define MIEN_RENDER_TILE_LEAF_PLACE_INL_H_
#endif

#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_edge-inl.h>
#include <mien/render/tile/leaf_parts-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where the sixteen blocks lie against an edge.
struct BlockSides {
  std::uint32_t inside, crossed;  // crossed: may be
};

/// Blocks that the end's line or the other half's border passes may hold either: by their whole discs.
HWY_INLINE std::uint32_t BlocksAtEnd(const LeafEdge& e) {
  const F f;
  constexpr float kDisc = 3.0f;  // half a block's diagonal, and what kEndHalo lacks to it
  const float radius = 1.0f / e.end_bend, inner = radius > kDisc ? radius - kDisc : 0.0f;
  const VF r = Const(kDisc), minus_r = Const(-kDisc), lo = Const(radius - kDisc),
           hi = Const(radius + kDisc);
  std::uint32_t at_end = 0;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF ux = hn::Sub(hn::Load(f, kBlocks.x + i), Const(e.end_x));
    const VF uy = hn::Sub(hn::Load(f, kBlocks.y + i), Const(e.end_y));
    const VF beyond = Fused(ux, Const(e.along_x), hn::Mul(uy, Const(e.along_y)));
    const VF up = Fused(ux, Const(e.end_nx), hn::Mul(uy, Const(e.end_ny)));
    const VF rho2 = Fused(ux, ux, hn::Mul(uy, uy));
    const auto in_ring = hn::And(hn::Ge(rho2, Const(inner * inner)), hn::Le(rho2, hn::Mul(hi, hi)));
    const auto on_circle = hn::And(hn::Gt(up, minus_r), in_ring);
    const auto on_body = hn::And(hn::Lt(beyond, r), hn::And(hn::Gt(up, lo), hn::Lt(up, hi)));
    at_end |= BitsOf(hn::And(hn::Gt(beyond, minus_r), hn::Or(on_circle, on_body))) << i;
  }
  return at_end;
}

HWY_INLINE BlockSides PlaceBlocks(const LeafEdge& e) {
  const F f;
  BlockSides sides{0, 0};
  const float turn = e.joined ? float(3.0 * kMostJointTurn) : 0.0f;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const Sight s = See(e, hn::Load(f, kBlocks.x + i), hn::Load(f, kBlocks.y + i));
    // Half a block's side along the normal, the bend over its half diagonal, and rounding.
    const VF along = hn::Mul(Const(2.0f), hn::Add(hn::Abs(s.gx), hn::Abs(s.gy)));
    // The other body of a joint may be the one that bends more, in the half of the block beyond it.
    const VF k = hn::Max(hn::Abs(s.k), hn::Abs(Const(e.next.bend)));
    const VF bent = hn::Mul(hn::Max(k, hn::Abs(Const(e.bend))), Const(4.5f));
    // No square reaches further than its corners from a circle, whose distance is exact (but for bends up to
    // kGentle, whose distances are up to a tenth longer here).
    const VF corner = hn::Min(hn::Add(bent, along), Const(3.2f));
    const VF reach = hn::Add(corner, Const(2e-3f + e.error + turn));
    sides.inside |= BitsOf(hn::Lt(s.d, hn::Zero(f))) << i;
    sides.crossed |= BitsOf(hn::Le(hn::Abs(s.d), reach)) << i;
  }
  if (e.has_end()) sides.crossed |= BlocksAtEnd(e);
  return sides;
}

/// Where the leaf's blocks lie against its edges.
struct Placed {
  std::uint32_t crossed[Leaf::kMostEdges];  // by edge: blocks
  std::uint32_t once = 0, twice = 0;        // blocks that one edge crosses at least, or two
  alignas(64) std::int32_t base[kBlock];  // by block: inside which of the edges that don't cross it
};
HWY_NOINLINE void Place(const Leaf& leaf, std::uint32_t blocks, Placed& out) {
  const hn::CappedTag<std::int32_t, 16> d;
  std::uint32_t inside[Leaf::kMostEdges];
  for (int e = 0; e < leaf.edge_count; ++e) {
    const BlockSides sides = PlaceBlocks(leaf.edges[std::size_t(e)]);
    out.crossed[e] = sides.crossed & blocks, inside[e] = sides.inside & ~sides.crossed;
    out.twice |= out.once & out.crossed[e], out.once |= out.crossed[e];
  }
  for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    auto base = hn::Zero(d);
    for (int e = 0; e < leaf.edge_count; ++e) {
      const std::uint32_t bits = inside[e] >> i;
      const std::uint8_t bytes[8] = {std::uint8_t(bits), std::uint8_t(bits >> 8)};
      base = hn::Or(base, hn::IfThenElseZero(hn::LoadMaskBits(d, bytes), hn::Set(d, 1 << e)));
    }
    hn::Store(base, d, out.base + i);
  }
}

/// The blocks with that base.
HWY_INLINE std::uint32_t BlocksWith(const Placed& placed, std::uint32_t base) {
  const F f;
  const hn::RebindToSigned<F> di;
  std::uint32_t blocks = 0;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const auto same = hn::Eq(hn::Load(di, placed.base + i), hn::Set(di, std::int32_t(base)));
    blocks |= BitsOf(hn::RebindMask(f, same)) << i;
  }
  return blocks;
}

/// How a block sees an edge.
struct Use {
  Part part;
  int strips;
  bool tight;  ///< bends more than strips can follow
};

/// How the block around (cx, cy) sees an edge.
HWY_INLINE Use UseOf(const LeafEdge& e, float cx, float cy, Blend blend) {
  constexpr float kTight = 0.45f;
  const float shown = ShownBy(blend);
  const auto size = [shown](float x) { return shown * (x < 0 ? -x : x); };
  const float body = size(e.bend);
  if (!e.has_end() && !e.joined) return {Part::body, StripsFor(body), body > kTight};
  const float beyond = (cx - e.end_x) * e.along_x + (cy - e.end_y) * e.along_y;
  const float other = size(e.joined ? e.next.bend : e.end_bend);
  if (beyond < -3.0f) return {Part::body, StripsFor(body), body > kTight};
  // Beyond the end's line edges are circles at most kEndHalo from being asked: never straight.
  if (beyond > 3.0f)
    return {Part::end, e.joined ? StripsFor(other) : HWY_MAX(2, StripsFor(other)), other > kTight};
  const float most = HWY_MAX(body, other);
  return {Part::both, HWY_MAX(2, StripsFor(most)), most > kTight};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
