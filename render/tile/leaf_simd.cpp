// Leaves in vectors: sixteen 4 × 4 blocks are placed against every edge at once; blocks that one
// edge crosses take its area in each of their pixels at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/tile/leaf_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_edge-inl.h>
#include <mien/render/tile/leaf_parts-inl.h>
// After the headers of mien's own: Highway's mathematics is a toggled header too.
#include <hwy/contrib/math/math-inl.h>

#include <bit>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where the sixteen blocks lie against an edge.
struct BlockSides {
  std::uint32_t inside, crossed;  // crossed: may be
};

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
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(f, hn::Lt(s.d, hn::Zero(f)), bits);
    const std::uint32_t in = std::uint32_t(bits[0]) | std::uint32_t(bits[1]) << 8;
    bits[0] = bits[1] = 0;
    hn::StoreMaskBits(f, hn::Le(hn::Abs(s.d), reach), bits);
    const std::uint32_t near = std::uint32_t(bits[0]) | std::uint32_t(bits[1]) << 8;
    sides.inside |= in << i, sides.crossed |= near << i;
  }
  if (e.has_end()) {
    // Blocks that the end's line or the other half's border passes may hold either: by their whole
    // discs.
    const float r = 3.0f;  // half a block's diagonal, and what kEndHalo lacks to it
    for (size_t i = 0; i < kBlock; ++i) {
      const float ux = kBlocks.x[i] - e.end_x, uy = kBlocks.y[i] - e.end_y;
      const float beyond = ux * e.along_x + uy * e.along_y, up = ux * e.end_nx + uy * e.end_ny;
      const float rho2 = ux * ux + uy * uy, radius = 1.0f / e.end_bend;
      const float lo = radius > r ? radius - r : 0.0f, hi = radius + r;
      const bool on_circle = beyond > -r && up > -r && rho2 >= lo * lo && rho2 <= hi * hi;
      const bool on_body = beyond > -r && beyond < r && up > radius - r && up < radius + r;
      if (on_circle || on_body) sides.crossed |= 1u << i;
    }
  }
  return sides;
}

/// Linear light times 255 to encoded values times 255 (IEC 61966-2-1).
HWY_INLINE VF Encoded(VF v) {
  const F f;
  const VF x = hn::Mul(v, Const(1.0f / 255));
  const VF power = hn::Exp(f, hn::Mul(hn::Log(f, hn::Max(x, Const(1e-6f))), Const(1.0f / 2.4f)));
  const VF curve = FusedLess(Const(1.055f * 255), power, Const(0.055f * 255));
  return hn::IfThenElse(hn::Le(x, Const(0.0031308f)), hn::Mul(v, Const(12.92f)), curve);
}

/// One pixel each: encoded channels in [0, 255] to the nearest level, with full alpha. 2²³ and a
/// number below 256 add to a float whose last byte is the number, rounded; the shifts drop the rest.
template <bool kLinear>
HWY_INLINE auto Packed(VF r, VF g, VF b) {
  const hn::RebindToSigned<F> i;
  const auto level = [&](VF v) HWY_ATTR {
    if constexpr (kLinear) v = Encoded(v);
    return hn::BitCast(i, hn::Add(v, Const(8388608.0f)));
  };
  const auto rg = hn::Or(level(r), hn::ShiftLeft<8>(level(g)));
  return hn::Or(hn::Or(rg, hn::ShiftLeft<16>(level(b))), hn::Set(i, int(0xFF000000u)));
}

HWY_INLINE void StoreBlock(const std::int32_t* from, std::uint32_t* to, size_t stride) {
  for (size_t row = 0; row < 4; ++row) std::memcpy(to + row * stride, from + 4 * row, 16);
}

HWY_INLINE VF Between(const float* plane, std::uint32_t out, std::uint32_t in, VF w) {
  return Fused(w, Const(plane[in] - plane[out]), Const(plane[out]));
}

template <bool kLinear>
HWY_INLINE void OneEdge(const Leaf& leaf, const LeafEdge& e, std::uint32_t out, std::uint32_t in,
                        float cx, float cy, int strips, Part part, std::uint32_t* to,
                        size_t stride) {
  const F f;
  const hn::RebindToSigned<F> di;
  alignas(64) std::int32_t pixels[kBlock];
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF w = AreaOf(e, hn::Add(hn::Load(f, kPixels.x + i), Const(cx)),
                        hn::Add(hn::Load(f, kPixels.y + i), Const(cy)), strips, part);
    hn::Store(Packed<kLinear>(Between(leaf.palette[0].data(), out, in, w),
                              Between(leaf.palette[1].data(), out, in, w),
                              Between(leaf.palette[2].data(), out, in, w)),
              di, pixels + i);
  }
  StoreBlock(pixels, to, stride);
}

/// How a block sees an edge.
struct Use {
  Part part;
  int strips;
  bool tight;  ///< bends more than strips can follow
};

/// What pixels of a block see of an edge: wholly inside, crossed, crossed in a way that one area does not
/// say.
struct InPixels {
  VF area;
  hn::Mask<F> full, cut, again, round;  ///< round: all of the pixel sees the round end
};

HWY_INLINE InPixels SeePixels(const LeafEdge& e, const Use& use, VF px, VF py) {
  const F f;
  constexpr float kRadius = 0.7072f;
  const auto none = hn::Lt(hn::Zero(f), hn::Zero(f));
  if (use.tight) {
    const Sight s = See(e, px, py);
    auto near = hn::Le(hn::Abs(s.d), Const(0.75f));  // distances to circles are exact
    if (e.has_end()) near = hn::Or(near, HidesInParts(e, px, py, kRadius));
    return {hn::Zero(f), hn::AndNot(near, hn::Lt(s.d, hn::Zero(f))), near, near, none};
  }
  const VF area = AreaOf(e, px, py, use.strips, use.part);
  const auto full = hn::Ge(area, Const(1.0f - 1e-6f)), some = hn::Gt(area, Const(1e-6f));
  auto again = none, round = none;
  if (use.part == Part::both)
    again = e.has_end() ? MayHoldEnd(e, px, py, kRadius) : MayHoldJoint(e, px, py, 1.0f);
  if (e.has_end() && use.part != Part::body) {
    const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
    round = hn::Gt(Fused(ux, Const(e.along_x), hn::Mul(uy, Const(e.along_y))), Const(kRadius));
  }
  return {area, full, hn::AndNot(full, some), again, round};
}

/// Whether those of the edges that have round ends share one: lines that meet in a point.
HWY_INLINE bool HaveOneEnd(const Leaf& leaf, std::uint32_t active) {
  const LeafEdge* first = nullptr;
  for (; active; active &= active - 1) {
    const LeafEdge& e = leaf.edges[std::size_t(std::countr_zero(active))];
    if (!e.has_end()) continue;
    if (!first) first = &e;
    const float near = 1e-4f;
    if (std::abs(e.end_x - first->end_x) > near || std::abs(e.end_y - first->end_y) > near ||
        std::abs(1.0f / e.end_bend - 1.0f / first->end_bend) > near)
      return false;
  }
  return true;
}

/// What the pixels of a block see.
struct BlockView {
  alignas(64) float area[kBlock];           // of the only edge that crosses
  alignas(64) std::int32_t inside[kBlock];  // bits by edge: wholly inside
  alignas(64) std::int32_t crossed[kBlock];
  std::uint32_t in_parts;  // pixels that one area does not describe
};

HWY_INLINE void SeeBlock(const Leaf& leaf, std::uint32_t active, std::uint32_t base,
                         const Use* uses, int block, BlockView& out) {
  const F f;
  const hn::RebindToSigned<F> di;
  using VI = hn::Vec<decltype(di)>;
  const bool one_end = HaveOneEnd(leaf, active);
  std::uint32_t ends = 0;
  out.in_parts = 0;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF px = hn::Add(hn::Load(f, kPixels.x + i), Const(kBlocks.x[block]));
    const VF py = hn::Add(hn::Load(f, kPixels.y + i), Const(kBlocks.y[block]));
    VI sides = hn::Set(di, int(base)), crossing = hn::Zero(di);
    auto again = hn::Lt(hn::Zero(f), hn::Zero(f));
    auto round = hn::Eq(hn::Zero(f), hn::Zero(f));
    VF w = hn::Zero(f);
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const int e = std::countr_zero(rest);
      const LeafEdge& edge = leaf.edges[std::size_t(e)];
      if (edge.has_end()) ends |= 1u << e;
      const InPixels seen = SeePixels(edge, uses[e], px, py);
      const VI bit = hn::Set(di, 1 << e);
      sides = hn::Or(sides, hn::IfThenElseZero(hn::RebindMask(di, seen.full), bit));
      const auto second = hn::RebindMask(f, hn::Ne(crossing, hn::Zero(di)));
      round = hn::And(round, hn::Or(seen.round, hn::Not(seen.cut)));
      auto twice = hn::And(seen.cut, second);
      if (one_end) twice = hn::AndNot(round, twice);  // the same circle again
      again = hn::Or(again, hn::Or(seen.again, twice));
      crossing = hn::Or(crossing, hn::IfThenElseZero(hn::RebindMask(di, seen.cut), bit));
      w = hn::IfThenElse(seen.cut, seen.area, w);
    }
    hn::Store(w, f, out.area + i);
    hn::Store(sides, di, out.inside + i), hn::Store(crossing, di, out.crossed + i);
    out.in_parts |= BitsOf(again) << i;
  }
  for (std::uint32_t rest = out.in_parts; rest; rest &= rest - 1) {
    const auto p = std::size_t(std::countr_zero(rest));
    // An end may turn up in a part though the pixel's centre sees nothing of it.
    out.crossed[p] = std::int32_t(active & (std::uint32_t(out.crossed[p]) | ends));
    out.inside[p] &= ~out.crossed[p];
  }
}

/// A block that is not simple. Pixels that one area does not describe are resolved in parts.
template <bool kLinear>
HWY_INLINE void AnyEdges(const Leaf& leaf, std::uint32_t active, std::uint32_t base,
                         const Use* uses, int block, std::uint32_t* to, size_t stride,
                         LeafPixels& left) {
  const F f;
  const hn::RebindToSigned<F> di;
  BlockView view;
  SeeBlock(leaf, active, base, uses, block, view);
  alignas(64) float light[3][kBlock];
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const auto all = hn::Set(di, Leaf::kMostSides - 1);
    const auto sides = hn::And(hn::Load(di, view.inside + i), all);
    const auto inner = hn::Or(sides, hn::And(hn::Load(di, view.crossed + i), all));
    const VF w = hn::Load(f, view.area + i);
    for (size_t c = 0; c < 3; ++c) {
      const float* plane = leaf.palette[c].data();
      const VF a = hn::GatherIndex(f, plane, sides), b = hn::GatherIndex(f, plane, inner);
      hn::Store(Fused(w, hn::Sub(b, a), a), f, light[c] + i);
    }
  }
  for (std::uint32_t rest = view.in_parts; rest; rest &= rest - 1) {
    const auto p = std::size_t(std::countr_zero(rest));
    const auto asked = std::uint32_t(view.crossed[p]), in = std::uint32_t(view.inside[p]);
    const Light mean =
        InParts(leaf, Mattering(leaf, asked, in), in, kBlocks.x[block] + kPixels.x[p],
                kBlocks.y[block] + kPixels.y[p], 1.0f, 0);
    light[0][p] = mean.r, light[1][p] = mean.g, light[2][p] = mean.b;
    left.add((block / 4 * 4 + int(p) / 4) * kLeaf + block % 4 * 4 + int(p) % 4);
  }
  alignas(64) std::int32_t pixels[kBlock];
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f))
    hn::Store(Packed<kLinear>(hn::Load(f, light[0] + i), hn::Load(f, light[1] + i),
                              hn::Load(f, light[2] + i)),
              di, pixels + i);
  StoreBlock(pixels, to, stride);
}

/// A block that one gentle edge crosses, away from its end.
struct Simple {
  std::uint8_t block, edge, base;
  bool beyond;  ///< a joint: its second body
};

/// The most common work of all, without a branch: blocks follow each other through the processor.
template <bool kLinear>
HWY_INLINE void SimpleBlocks(const Leaf& leaf, const Simple* blocks, int count,
                             std::uint32_t* pixels, size_t stride) {
  const F f;
  const hn::RebindToSigned<F> di;
  for (int n = 0; n < count; ++n) {
    LeafEdge second;
    if (blocks[n].beyond) second = leaf.edges[blocks[n].edge].beyond();
    const LeafEdge& e = blocks[n].beyond ? second : leaf.edges[blocks[n].edge];
    const int b = blocks[n].block;
    const std::uint32_t out = blocks[n].base, in = out | 1u << blocks[n].edge;
    alignas(64) std::int32_t block[kBlock];
    for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
      const Sight s = SeeGently(e, hn::Add(hn::Load(f, kPixels.x + i), Const(kBlocks.x[b])),
                                hn::Add(hn::Load(f, kPixels.y + i), Const(kBlocks.y[b])));
      const VF w = EdgeArea(f, s.d, s.gx, s.gy, s.k);
      hn::Store(Packed<kLinear>(Between(leaf.palette[0].data(), out, in, w),
                                Between(leaf.palette[1].data(), out, in, w),
                                Between(leaf.palette[2].data(), out, in, w)),
                di, block + i);
    }
    StoreBlock(block, pixels + size_t(b / 4 * 4) * stride + size_t(b % 4 * 4), stride);
  }
}

HWY_INLINE void FillBlock(std::uint32_t value, std::uint32_t* to, size_t stride) {
  const hn::CappedTag<std::uint32_t, 4> d;
  for (size_t row = 0; row < 4; ++row)
    for (size_t x = 0; x < 4; x += hn::Lanes(d))
      hn::StoreU(hn::Set(d, value), d, to + row * stride + x);
}

/// How the block around (cx, cy) sees an edge.
HWY_INLINE Use UseOf(const LeafEdge& e, float cx, float cy) {
  constexpr float kTight = 0.45f;
  const auto size = [](float x) { return x < 0 ? -x : x; };
  const float body = size(e.bend);
  if (!e.has_end() && !e.joined) return {Part::body, StripsFor(body), body > kTight};
  const float beyond = (cx - e.end_x) * e.along_x + (cy - e.end_y) * e.along_y;
  const float other = e.joined ? size(e.next.bend) : e.end_bend;
  if (beyond < -3.0f) return {Part::body, StripsFor(body), body > kTight};
  // Beyond the end's line edges are circles at most kEndHalo from being asked: never straight.
  if (beyond > 3.0f)
    return {Part::end, e.joined ? StripsFor(other) : HWY_MAX(2, StripsFor(other)), other > kTight};
  const float most = HWY_MAX(body, other);
  return {Part::both, HWY_MAX(2, StripsFor(most)), most > kTight};
}

template <bool kLinear>
HWY_INLINE void Paint(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, size_t stride,
                      LeafPixels& left) {
  BlockSides sides[Leaf::kMostEdges];
  for (int e = 0; e < leaf.edge_count; ++e) sides[e] = PlaceBlocks(leaf.edges[std::size_t(e)]);
  Simple simple[kBlock];
  int simple_count = 0;
  for (std::uint32_t todo = blocks; todo; todo &= todo - 1) {
    const int b = std::countr_zero(todo);
    std::uint32_t* const to = pixels + size_t(b / 4 * 4) * stride + size_t(b % 4 * 4);
    std::uint32_t base = 0, active = 0;
    for (int e = 0; e < leaf.edge_count; ++e) {
      const std::uint32_t near = sides[e].crossed >> b & 1u;
      active |= near << e;
      base |= (sides[e].inside >> b & 1u & ~near) << e;
    }
    if (active) active = Mattering(leaf, active, base);
    if (!active) {
      FillBlock(leaf.packed[base], to, stride);
      continue;
    }
    left.edge_blocks |= 1u << b;
    Use uses[Leaf::kMostEdges];
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const int e = std::countr_zero(rest);
      uses[e] = UseOf(leaf.edges[std::size_t(e)], kBlocks.x[b], kBlocks.y[b]);
    }
    const int e = std::countr_zero(active);
    const Use& use = uses[e];
    if ((active & (active - 1)) != 0 || use.tight || use.part == Part::both) {
      AnyEdges<kLinear>(leaf, active, base, uses, b, to, stride, left);
    } else if (use.strips == 1) {
      const bool second = leaf.edges[std::size_t(e)].joined && use.part == Part::end;
      simple[simple_count++] = {std::uint8_t(b), std::uint8_t(e), std::uint8_t(base), second};
    } else {
      OneEdge<kLinear>(leaf, leaf.edges[std::size_t(e)], base, base | active, kBlocks.x[b],
                       kBlocks.y[b], use.strips, use.part, to, stride);
    }
  }
  SimpleBlocks<kLinear>(leaf, simple, simple_count, pixels, stride);
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
