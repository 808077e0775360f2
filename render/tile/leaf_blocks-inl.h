// Blocks of 4 × 4 pixels of a leaf: filled, crossed by one gentle edge, or by anything. Included once per
// instruction set.
#if defined(MIEN_RENDER_TILE_LEAF_BLOCKS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_TILE_LEAF_BLOCKS_INL_H_
#undef MIEN_RENDER_TILE_LEAF_BLOCKS_INL_H_
#else
#define MIEN_RENDER_TILE_LEAF_BLOCKS_INL_H_
#endif

#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_edge-inl.h>
#include <mien/render/tile/leaf_parts-inl.h>
#include <mien/render/tile/leaf_place-inl.h>
// After the headers of mien's own: Highway's mathematics is a toggled header too.
#include <hwy/contrib/math/math-inl.h>

#include <bit>
#include <cmath>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

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
HWY_NOINLINE void OneEdge(const Leaf& leaf, const LeafEdge& e, std::uint32_t out, std::uint32_t in,
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
  const VF area = use.strips == 1 && use.part == Part::body
                      ? GentleAreaOf(e, px, py)
                      : AreaOf(e, px, py, use.strips, use.part);
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

HWY_NOINLINE void SeeBlock(const Leaf& leaf, std::uint32_t active, std::uint32_t base,
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
HWY_NOINLINE void AnyEdges(const Leaf& leaf, std::uint32_t active, std::uint32_t base,
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

/// Blocks that one gentle edge crosses, away from its end, between two colours.
struct Simple {
  std::uint8_t edge, base;
  bool beyond;  ///< a joint: its second body
  std::uint32_t blocks;
};

/// Up to this bend, and what leaves the circle in a leaf, pixels take a straight edge: 0.043 levels by the
/// bound k/24, and 0.05.
constexpr float kStraightBend = 0.004f, kStraightLeaves = 2e-4f;

/// The most common work of all, without a branch: blocks follow each other through the processor. The edge
/// is that of See() and EdgeArea(), with what its blocks share taken out: turned coordinates x, y are sums
/// of a pixel's and a block's. A block that an edge crosses is near: no clamp is needed.
template <bool kLinear, bool kBent>
HWY_NOINLINE void SimpleBlocks(const Leaf& leaf, const LeafEdge& e, std::uint32_t out,
                               std::uint32_t in, std::uint32_t blocks, std::uint32_t* pixels,
                               size_t stride) {
  const F f;
  const hn::RebindToSigned<F> di;
  const VF nx = Const(e.nx), ny = Const(e.ny), k = Const(e.bend), half = Const(0.5f * e.bend);
  const VF k2 = Const(2.0f * e.bend), arc = Const(0.5f * e.bend * e.bend), one = Const(1.0f);
  const VF c3 = Const(e.c3), c4 = Const(e.c4), s3 = Const(3.0f * e.c3), s4 = Const(4.0f * e.c4);
  VF from[3], to[3];
  for (size_t c = 0; c < 3; ++c) {
    const float* plane = leaf.palette[c].data();
    from[c] = Const(plane[out]), to[c] = Const(plane[in] - plane[out]);
  }
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF ux = hn::Sub(hn::Load(f, kPixels.x + i), Const(e.x));
    const VF uy = hn::Sub(hn::Load(f, kPixels.y + i), Const(e.y));
    const VF y0 = Fused(ux, nx, hn::Mul(uy, ny)), x0 = FusedLess(uy, nx, hn::Mul(ux, ny));
    const VF gx0 = Fused(k, ux, nx), gy0 = Fused(k, uy, ny);
    for (std::uint32_t rest = blocks; rest; rest &= rest - 1) {
      const auto b = std::size_t(std::countr_zero(rest));
      const VF bx = Const(kBlocks.x[b]), by = Const(kBlocks.y[b]);
      const VF y = Fused(bx, nx, Fused(by, ny, y0)), x = Fused(by, nx, FusedFrom(bx, ny, x0));
      const VF x2 = hn::Mul(x, x), circle = Fused(half, Fused(y, y, x2), y);
      const VF q = hn::Mul(k2, circle);
      const VF series = Fused(q, FusedFrom(Const(0.125f), q, Const(0.25f)), one);
      VF gx = Fused(k, bx, gx0), gy = Fused(k, by, gy0), w;
      if constexpr (kBent) {
        const VF slope = hn::Mul(x2, Fused(s4, x, s3));
        gx = FusedFrom(slope, ny, gx), gy = Fused(slope, nx, gy);
        const VF leaves = hn::Mul(hn::Mul(hn::Mul(x2, x), Fused(arc, x2, one)), Fused(c4, x, c3));
        w = EdgeArea(f, Fused(circle, series, leaves), gx, gy, k);
      } else {
        w = StraightEdgeArea(f, hn::Mul(circle, series), gx, gy);
      }
      const auto color = Packed<kLinear>(Fused(w, to[0], from[0]), Fused(w, to[1], from[1]),
                                         Fused(w, to[2], from[2]));
      alignas(64) std::int32_t rows[kBlock];
      hn::Store(color, di, rows);
      std::uint32_t* const at = pixels + b / 4 * 4 * stride + b % 4 * 4;
      constexpr size_t kRun = HWY_MIN(4, hn::MaxLanes(F()));  // lanes of one row
      for (size_t j = 0; j < hn::Lanes(f); j += kRun)
        std::memcpy(at + (i + j) / 4 * stride + (i + j) % 4, rows + j, 4 * kRun);
    }
  }
}

template <bool kLinear>
HWY_INLINE void SimpleRun(const Leaf& leaf, const Simple& run, std::uint32_t* pixels,
                          size_t stride) {
  const LeafEdge& first = leaf.edges[run.edge];
  const LeafEdge second = run.beyond ? first.beyond() : LeafEdge{};
  const LeafEdge& e = run.beyond ? second : first;
  const std::uint32_t out = run.base, in = out | 1u << run.edge;
  const float shown = ShownBy(leaf.blend);
  const auto size = [shown](float x) { return shown * (x < 0 ? -x : x); };
  constexpr float kReach = 11.32f, kReach3 = kReach * kReach * kReach;  // a leaf's half diagonal
  const bool straight = size(e.bend) <= kStraightBend &&
                        (size(e.c3) + kReach * size(e.c4)) * kReach3 <= kStraightLeaves;
  if (straight)
    SimpleBlocks<kLinear, false>(leaf, e, out, in, run.blocks, pixels, stride);
  else
    SimpleBlocks<kLinear, true>(leaf, e, out, in, run.blocks, pixels, stride);
}

HWY_INLINE void FillBlock(std::uint32_t value, std::uint32_t* to, size_t stride) {
  const hn::CappedTag<std::uint32_t, 4> d;
  for (size_t row = 0; row < 4; ++row)
    for (size_t x = 0; x < 4; x += hn::Lanes(d))
      hn::StoreU(hn::Set(d, value), d, to + row * stride + x);
}

/// All sixteen blocks in their colours, whole rows of the leaf at a time.
HWY_INLINE void FillLeaf(const std::uint32_t* colors, std::uint32_t* pixels, size_t stride) {
  const hn::CappedTag<std::uint32_t, 16> d;
  for (size_t row = 0; row < 4; ++row) {
    const std::uint32_t* const four = colors + 4 * row;
    std::uint32_t* to = pixels + 4 * row * stride;
    alignas(64) std::uint32_t line[kLeaf];
    for (size_t i = 0; i < kLeaf; ++i) line[i] = four[i / 4];
    for (size_t j = 0; j < 4; ++j, to += stride)
      for (size_t i = 0; i < kLeaf; i += hn::Lanes(d)) hn::StoreU(hn::Load(d, line + i), d, to + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
