// Leaves in vectors: sixteen 4 × 4 blocks are placed against every edge at once; blocks that one
// edge crosses take its area in each of their pixels at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/render/tile/leaf_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/render/cover/edge_area-inl.h>
#include <mien/render/tile/leaf.h>
// After the headers of mien's own: Highway's mathematics is a toggled header too.
#include <hwy/contrib/math/math-inl.h>

#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
constexpr size_t kBlock = 16;  // pixels of a block, blocks of a leaf

HWY_INLINE VF Const(float x) {
  return hn::Set(F(), x);
}

/// An edge seen from points: signed distance times the gradient's length, gradient, bend.
struct Sight {
  VF d, gx, gy, k;
};

/// Y + k/2 |u|² is the circle's distance d (1 + k d/2); its gradient's length is s = 1 + k d. For
/// bends up to kGentle the distance times s is a series; beyond, a root.
constexpr float kGentle = 0.03f;

/// What both forms share: Y + k/2 |u|², the gradient of that and of what leaves the circle.
struct Seen {
  VF f, leaves, gx, gy, q;
};
HWY_INLINE Seen Look(const LeafEdge& e, VF px, VF py) {
  const VF ux = hn::Sub(px, Const(e.x)), uy = hn::Sub(py, Const(e.y));
  const VF nx = Const(e.nx), ny = Const(e.ny), k = Const(e.bend);
  const VF y = Fused(ux, nx, hn::Mul(uy, ny)), x = FusedLess(uy, nx, hn::Mul(ux, ny));
  const VF f = Fused(hn::Mul(k, Const(0.5f)), Fused(ux, ux, hn::Mul(uy, uy)), y);
  const VF x2 = hn::Mul(x, x);
  const VF c3 = Const(e.c3), c4x = hn::Mul(Const(e.c4), x);
  const VF arc = Fused(Const(0.5f * e.bend * e.bend), x2, Const(1.0f));
  const VF slope = hn::Mul(x2, Fused(Const(3.0f), c3, hn::Mul(Const(4.0f), c4x)));
  return {f, hn::Mul(hn::Mul(hn::Mul(x2, x), arc), hn::Add(c3, c4x)),
          FusedFrom(slope, ny, Fused(k, ux, nx)), Fused(slope, nx, Fused(k, uy, ny)),
          hn::Mul(hn::Add(k, k), f)};
}

/// For bends up to kGentle: 2 sqrt(1+q)/(1 + sqrt(1+q)) = 1 + q/4 − q²/8 + …; far away the sign alone
/// matters.
HWY_INLINE Sight SeeGently(const LeafEdge& e, VF px, VF py) {
  const Seen s = Look(e, px, py);
  const VF near = hn::Min(hn::Max(s.q, Const(-0.5f)), Const(0.5f));
  const VF series = Fused(near, FusedFrom(Const(0.125f), near, Const(0.25f)), Const(1.0f));
  return {Fused(s.f, series, s.leaves), s.gx, s.gy, Const(e.bend)};
}

HWY_INLINE Sight SeeBody(const LeafEdge& e, VF px, VF py) {
  if (e.bend <= kGentle && e.bend >= -kGentle) return SeeGently(e, px, py);
  const Seen s = Look(e, px, py);
  // The gradient is made unit: at the circle's centre it vanishes.
  const VF root = hn::Sqrt(hn::Max(hn::Add(s.q, Const(1.0f)), Const(1e-4f)));
  const VF inverse = hn::Div(Const(1.0f), root);
  const VF d = hn::Add(hn::Div(hn::Add(s.f, s.f), hn::Add(root, Const(1.0f))), s.leaves);
  return {d, hn::Mul(s.gx, inverse), hn::Mul(s.gy, inverse), Const(e.bend)};
}

/// Whether points beyond the end's line belong to this edge rather than to the stroke's other one.
HWY_INLINE auto Mine(const LeafEdge& e, VF px, VF py) {
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  const VF up = Fused(ux, Const(e.end_nx), hn::Mul(uy, Const(e.end_ny)));
  const VF rho2 = Fused(ux, ux, hn::Mul(uy, uy));
  const float far = 1.0f / e.end_bend + kEndHalo;
  const VF other = Fused(ux, Const(e.other_x), hn::Mul(uy, Const(e.other_y)));
  const auto nobodys = hn::And(hn::Gt(rho2, Const(far * far)), hn::Gt(other, hn::Zero(F())));
  return hn::Or(hn::Ge(up, hn::Zero(F())), nobodys);
}

/// The round end alone, for points that are all beyond its line.
template <class M>
HWY_INLINE Sight SeeEnd(const LeafEdge& e, VF px, VF py, M mine) {
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  const VF rho = hn::Sqrt(hn::Max(Fused(ux, ux, hn::Mul(uy, uy)), Const(1e-12f)));
  const VF inverse = hn::Div(Const(1.0f), rho);
  const VF d = hn::IfThenElse(mine, hn::Sub(rho, Const(1.0f / e.end_bend)), Const(-1e6f));
  return {d, hn::Mul(ux, inverse), hn::Mul(uy, inverse), Const(e.end_bend)};
}

/// An edge with its round end; `mine` as above, for the pixels whose parts the points are.
template <class M>
HWY_INLINE Sight SeeWithEnd(const LeafEdge& e, VF px, VF py, M mine) {
  const Sight body = SeeBody(e, px, py), end = SeeEnd(e, px, py, mine);
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  const auto beyond =
      hn::Gt(Fused(ux, Const(e.along_x), hn::Mul(uy, Const(e.along_y))), hn::Zero(F()));
  return {hn::IfThenElse(beyond, end.d, body.d), hn::IfThenElse(beyond, end.gx, body.gx),
          hn::IfThenElse(beyond, end.gy, body.gy), hn::IfThenElse(beyond, end.k, body.k)};
}

/// Two bodies: `first` before the joint, `second` beyond it.
HWY_INLINE Sight SeeJoined(const LeafEdge& first, const LeafEdge& second, VF px, VF py) {
  const Sight a = SeeBody(first, px, py), b = SeeBody(second, px, py);
  const VF ux = hn::Sub(px, Const(first.end_x)), uy = hn::Sub(py, Const(first.end_y));
  const auto beyond =
      hn::Gt(Fused(ux, Const(first.along_x), hn::Mul(uy, Const(first.along_y))), hn::Zero(F()));
  return {hn::IfThenElse(beyond, b.d, a.d), hn::IfThenElse(beyond, b.gx, a.gx),
          hn::IfThenElse(beyond, b.gy, a.gy), hn::IfThenElse(beyond, b.k, a.k)};
}

HWY_INLINE Sight See(const LeafEdge& e, VF px, VF py) {
  if (e.joined) return SeeJoined(e, e.beyond(), px, py);
  return e.has_end() ? SeeWithEnd(e, px, py, Mine(e, px, py)) : SeeBody(e, px, py);
}

/// Into how many strips a pixel is cut, so that the bend's error stays below a quarter level: a
/// whole pixel's area is corrected by its chord and off by at most kEdgeAreaPerBend · bend; in
/// strips across the edge that error falls with the square of their width.
HWY_INLINE int StripsFor(float bend) {
  const float k = bend < 0 ? -bend : bend;
  return k <= 0.018f ? 1 : k <= 0.05f ? 2 : k <= 0.18f ? 4 : k <= 0.3f ? 6 : 8;
}

/// Which parts of an edge a block can see.
enum class Part { body, end, both };

/// The area of each pixel in strips; see(x, y): the edge from there.
template <class SeeAt>
HWY_INLINE VF AreaInStrips(VF px, VF py, int strips, SeeAt see) {
  const F f;
  const Sight middle = see(px, py);
  // Strips side by side in x where the edge runs along x, else in y.
  const auto in_x = hn::Ge(hn::Abs(middle.gy), hn::Abs(middle.gx));
  const float n = float(strips), step = 1.0f / n;
  const VF one = Const(1.0f), thin = Const(step), zero = hn::Zero(f);
  const VF narrow_x = hn::IfThenElse(in_x, thin, one), narrow_y = hn::IfThenElse(in_x, one, thin);
  VF sum = zero;
  for (int i = 0; i < strips; ++i) {
    const VF at = Const((float(i) + 0.5f) * step - 0.5f);
    const VF x = hn::Add(px, hn::IfThenElse(in_x, at, zero));
    const VF y = hn::Add(py, hn::IfThenElse(in_x, zero, at));
    const Sight s = see(x, y);
    sum = hn::Add(sum, EdgeAreaOfStrip(f, s.d, s.gx, s.gy, s.k, narrow_x, narrow_y));
  }
  return hn::Mul(sum, thin);
}

/// The area of each pixel around (px, py) inside the edge. In a function of its own: inlined where it is
/// asked for, with all it inlines itself, it takes compilers minutes under sanitizers.
HWY_NOINLINE VF AreaOf(const LeafEdge& e, VF px, VF py, int strips, Part part) {
  const F f;
  const bool beyond = e.joined && part == Part::end;
  const LeafEdge other = beyond ? e.beyond() : LeafEdge{};
  const LeafEdge& body = beyond ? other : e;
  if (strips == 1) {
    const Sight s = SeeBody(body, px, py);  // ends take several strips
    return EdgeArea(f, s.d, s.gx, s.gy, s.k);
  }
  if (beyond || part == Part::body)
    return AreaInStrips(px, py, strips, [&](VF x, VF y) MIEN_LANES { return SeeBody(body, x, y); });
  if (e.joined) {
    const LeafEdge second = e.beyond();
    return AreaInStrips(px, py, strips,
                        [&](VF x, VF y) MIEN_LANES { return SeeJoined(e, second, x, y); });
  }
  const auto mine = Mine(e, px, py);
  return AreaInStrips(px, py, strips, [&](VF x, VF y) MIEN_LANES {
    return part == Part::end ? SeeEnd(e, x, y, mine) : SeeWithEnd(e, x, y, mine);
  });
}

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

void FillRows(std::uint32_t* pixels, size_t stride, int rows, int count, std::uint32_t value,
              bool streamed) {
  const hn::CappedTag<std::uint32_t, 16> d;
  const auto v = hn::Set(d, value);
  const size_t n = hn::Lanes(d), all = size_t(count);
  for (int row = 0; row < rows; ++row, pixels += stride) {
    size_t i = 0;
    if (streamed) {
      for (; i < all && reinterpret_cast<std::uintptr_t>(pixels + i) % (4 * n) != 0; ++i)
        pixels[i] = value;
      for (; i + n <= all; i += n) hn::Stream(v, d, pixels + i);
    } else {
      for (; i + n <= all; i += n) hn::StoreU(v, d, pixels + i);
    }
    for (; i < all; ++i) pixels[i] = value;
  }
}

void StreamLeaf(const std::uint32_t* leaf, std::uint32_t* pixels, size_t stride) {
  const hn::CappedTag<std::uint32_t, 16> d;
  for (int row = 0; row < kLeaf; ++row)
    for (size_t i = 0; i < size_t(kLeaf); i += hn::Lanes(d))
      hn::Stream(hn::LoadU(d, leaf + row * kLeaf + i), d, pixels + size_t(row) * stride + i);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <hwy/cache_control.h>

namespace mien {
namespace batch {
HWY_EXPORT(PaintLeaf);
HWY_EXPORT(FillRows);
HWY_EXPORT(StreamLeaf);
}  // namespace batch

void paint_leaf(const Leaf& leaf, std::uint32_t blocks, std::uint32_t* pixels, std::size_t stride,
                LeafPixels& left) {
  HWY_DYNAMIC_DISPATCH(batch::PaintLeaf)(leaf, blocks, pixels, stride, left);
}
void fill_rows(std::uint32_t* pixels, std::size_t stride, int rows, int count, std::uint32_t value,
               Stores stores) {
  HWY_DYNAMIC_DISPATCH(batch::FillRows)
  (pixels, stride, rows, count, value, stores == Stores::streamed);
}
void stream_leaf(const std::uint32_t* leaf, std::uint32_t* pixels, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(batch::StreamLeaf)(leaf, pixels, stride);
}
void finish_streams() {
  hwy::FlushStream();
}

}  // namespace mien
#endif
