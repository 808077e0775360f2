// Leaves in vectors: sixteen 4 × 4 blocks are placed against every edge at once; blocks that one
// edge crosses take its area in each of their pixels at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/tile/leaf_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_edge-inl.h>
// After the headers of mien's own: Highway's mathematics is a toggled header too.
#include <hwy/contrib/math/math-inl.h>

#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct alignas(64) Offsets {
  float x[kBlock], y[kBlock];
};
/// Pixels of a block relative to its centre, and blocks of a leaf relative to the leaf's.
constexpr Offsets MakeOffsets(float step) {
  Offsets o{};
  for (int i = 0; i < 16; ++i)
    o.x[i] = (float(i % 4) - 1.5f) * step, o.y[i] = (float(i / 4) - 1.5f) * step;
  return o;
}
alignas(64) constexpr Offsets kPixels = MakeOffsets(1.0f);
alignas(64) constexpr Offsets kBlocks = MakeOffsets(4.0f);

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
    const VF reach = hn::Add(hn::Add(bent, along), Const(2e-3f + e.error + turn));
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

/// A block that several edges may cross: pixels that one of them crosses are drawn, those that more
/// cross are named.
template <bool kLinear>
HWY_INLINE void ManyEdges(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx,
                          float cy, const int* strips, const Part* parts, int first,
                          std::uint32_t* to, size_t stride, LeafPixels& left) {
  const F f;
  const hn::RebindToSigned<F> di;
  using VI = hn::Vec<decltype(di)>;
  alignas(64) std::int32_t pixels[kBlock];
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF px = hn::Add(hn::Load(f, kPixels.x + i), Const(cx));
    const VF py = hn::Add(hn::Load(f, kPixels.y + i), Const(cy));
    VI sides = hn::Set(di, int(base)), crossing = hn::Zero(di), twice = hn::Zero(di);
    VF w = hn::Zero(f);
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const int e = std::countr_zero(rest);
      const VF area = AreaOf(leaf.edges[std::size_t(e)], px, py, strips[e], parts[e]);
      const auto full = hn::Ge(area, Const(1.0f - 1e-6f)), some = hn::Gt(area, Const(1e-6f));
      const VI bit = hn::Set(di, 1 << e);
      sides = hn::Or(sides, hn::IfThenElseZero(hn::RebindMask(di, full), bit));
      const auto cut = hn::AndNot(full, some);
      const VI here = hn::IfThenElseZero(hn::RebindMask(di, cut), bit);
      const auto again = hn::And(hn::RebindMask(di, cut), hn::Ne(crossing, hn::Zero(di)));
      twice = hn::Or(twice, hn::IfThenElseZero(again, hn::Set(di, -1)));
      crossing = hn::Or(crossing, here);
      w = hn::IfThenElse(cut, area, w);
    }
    const VI inner = hn::Or(sides, crossing);
    const auto color = [&](int c) HWY_ATTR {
      const float* plane = leaf.palette[std::size_t(c)].data();
      const VF a = hn::GatherIndex(f, plane, hn::And(sides, hn::Set(di, Leaf::kMostSides - 1)));
      const VF b = hn::GatherIndex(f, plane, hn::And(inner, hn::Set(di, Leaf::kMostSides - 1)));
      return Fused(w, hn::Sub(b, a), a);
    };
    hn::Store(Packed<kLinear>(color(0), color(1), color(2)), di, pixels + i);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(di, hn::Ne(twice, hn::Zero(di)), bits);
    for (std::uint32_t m = std::uint32_t(bits[0]) | std::uint32_t(bits[1]) << 8; m; m &= m - 1) {
      const int p = int(i) + std::countr_zero(m);
      left.add(first + (p / 4) * kLeaf + p % 4);
    }
  }
  StoreBlock(pixels, to, stride);
}

/// Drops edges whose side changes no colour, for the sides of the others that may occur.
HWY_INLINE std::uint32_t Mattering(const Leaf& leaf, std::uint32_t active, std::uint32_t base) {
  std::uint32_t kept = active;
  for (std::uint32_t rest = active; rest; rest &= rest - 1) {
    const std::uint32_t bit = rest & -rest, others = kept & ~bit;
    bool matters = false;
    for (std::uint32_t sub = others;; sub = (sub - 1) & others) {
      matters = matters || leaf.same[base | sub] != leaf.same[base | sub | bit];
      if (sub == 0 || matters) break;
    }
    if (!matters) kept &= ~bit;
  }
  return kept;
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

template <bool kLinear>
HWY_INLINE void Paint(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, size_t stride,
                      LeafPixels& left) {
  BlockSides sides[Leaf::kMostEdges];
  int strips[Leaf::kMostEdges], end_strips[Leaf::kMostEdges];
  for (int e = 0; e < leaf.edge_count; ++e) {
    const LeafEdge& edge = leaf.edges[std::size_t(e)];
    sides[e] = PlaceBlocks(edge);
    strips[e] = StripsFor(edge.bend);
    const float beyond = edge.joined ? edge.next.bend : edge.end_bend;
    end_strips[e] = edge.joined      ? StripsFor(beyond)
                    : edge.has_end() ? HWY_MAX(4, StripsFor(beyond))
                                     : strips[e];
  }
  Simple simple[kBlock];
  int simple_count = 0;
  for (std::uint32_t todo = blocks; todo; todo &= todo - 1) {
    const int b = std::countr_zero(todo);
    const int bx = 4 * (b % 4), by = 4 * (b / 4);
    std::uint32_t* const to = pixels + size_t(by) * stride + size_t(bx);
    const float cx = kBlocks.x[b], cy = kBlocks.y[b];
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
    int here[Leaf::kMostEdges];
    Part parts[Leaf::kMostEdges];
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const int e = std::countr_zero(rest);
      const LeafEdge& edge = leaf.edges[std::size_t(e)];
      const float beyond = (cx - edge.end_x) * edge.along_x + (cy - edge.end_y) * edge.along_y;
      parts[e] = (!edge.has_end() && !edge.joined) || beyond < -3.0f ? Part::body
                 : beyond > 3.0f                                     ? Part::end
                                                                     : Part::both;
      here[e] = parts[e] == Part::body ? strips[e] : end_strips[e];
      if (edge.joined && parts[e] == Part::both)
        here[e] = HWY_MAX(4, HWY_MAX(strips[e], end_strips[e]));
    }
    if ((active & (active - 1)) == 0) {
      const int e = std::countr_zero(active);
      if (here[e] == 1) {
        const bool second = leaf.edges[std::size_t(e)].joined && parts[e] == Part::end;
        simple[simple_count++] = {std::uint8_t(b), std::uint8_t(e), std::uint8_t(base), second};
        continue;
      }
      OneEdge<kLinear>(leaf, leaf.edges[std::size_t(e)], base, base | active, cx, cy, here[e],
                       parts[e], to, stride);
    } else {
      ManyEdges<kLinear>(leaf, active, base, cx, cy, here, parts, by * kLeaf + bx, to, stride,
                         left);
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

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(PaintLeaf);
}  // namespace batch

void paint_leaf(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, std::size_t stride,
                LeafPixels& left) {
  HWY_DYNAMIC_DISPATCH(batch::PaintLeaf)(leaf, blocks, pixels, stride, left);
}

}  // namespace mien
#endif
