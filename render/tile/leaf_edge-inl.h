// Edges of leaves as vectors of points see them, and the area of pixels inside them. Included once per
// instruction set.
#if defined(MIEN_RENDER_TILE_LEAF_EDGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_TILE_LEAF_EDGE_INL_H_
#undef MIEN_RENDER_TILE_LEAF_EDGE_INL_H_
#else
#define MIEN_RENDER_TILE_LEAF_EDGE_INL_H_
#endif

#include <mien/render/blend/blender.h>
#include <mien/render/cover/edge_area-inl.h>
#include <mien/sdf/edge/leaf_edge.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
constexpr size_t kBlock = 16;  // pixels of a block, blocks of a leaf

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

/// How much more of a bend's error shows: encoding linear light multiplies a small area by up to 12.92. By 9 of
/// those, what is a quarter of a level at most becomes a third.
HWY_INLINE float ShownBy(Blend blend) {
  return blend == Blend::linear ? 9.0f : 1.0f;
}

/// Into how many strips a pixel is cut across an edge, so that its bend's error stays below a quarter level.
/// What one formula loses is largest where a tangent along a side of the pixel just misses it: k/24. For strips
/// of a circle, over all places and directions (levels): two 0.22 at 0.2, three 0.2 at 0.28, four 0.23 at 0.35, six 0.26
/// at 0.45. Beyond, the normal turns too far in a pixel: see leaf_parts-inl.h.
HWY_INLINE int StripsFor(float bend) {
  const float k = bend < 0 ? -bend : bend;
  return k <= 0.024f ? 1 : k <= 0.2f ? 2 : k <= 0.28f ? 3 : k <= 0.35f ? 4 : 6;
}

/// Which parts of an edge a block can see.
enum class Part { body, end, both };

/// The area of squares of `side` in strips, as a share; see(x, y): the edge from there.
template <class SeeAt>
HWY_INLINE VF AreaInStrips(VF px, VF py, float side, int strips, SeeAt see) {
  const F f;
  const Sight middle = see(px, py);
  // Strips side by side in x where the edge runs along x, else in y.
  const auto in_x = hn::Ge(hn::Abs(middle.gy), hn::Abs(middle.gx));
  const float n = float(strips), step = 1.0f / n;
  const VF one = Const(1.0f), thin = Const(step), zero = hn::Zero(f);
  const VF sides = Const(side), inverse = Const(1.0f / side);
  const VF narrow_x = hn::IfThenElse(in_x, thin, one), narrow_y = hn::IfThenElse(in_x, one, thin);
  VF sum = zero;
  for (int i = 0; i < strips; ++i) {
    const VF at = Const(((float(i) + 0.5f) * step - 0.5f) * side);
    const VF x = hn::Add(px, hn::IfThenElse(in_x, at, zero));
    const VF y = hn::Add(py, hn::IfThenElse(in_x, zero, at));
    const Sight s = see(x, y);
    sum = hn::Add(sum, EdgeAreaOfStrip(f, hn::Mul(s.d, inverse), s.gx, s.gy, hn::Mul(s.k, sides),
                                       narrow_x, narrow_y));
  }
  return hn::Mul(sum, thin);
}

/// The area of each pixel around (px, py) inside the edge's body, of a bend that takes one strip.
HWY_INLINE VF GentleAreaOf(const LeafEdge& e, VF px, VF py) {
  const Sight s = SeeGently(e, px, py);
  return EdgeArea(F(), s.d, s.gx, s.gy, s.k);
}

/// The area of each pixel around (px, py) inside the edge. In a function of its own: inlined where it is
/// asked for, with all it inlines itself, it takes compilers minutes under sanitizers.
HWY_NOINLINE VF AreaOf(const LeafEdge& e, VF px, VF py, int strips, Part part) {
  if (e.joined && part == Part::end) return AreaOf(e.beyond(), px, py, strips, Part::body);
  if (strips == 1) return GentleAreaOf(e, px, py);  // ends take several strips
  if (part == Part::body)
    return AreaInStrips(px, py, 1.0f, strips,
                        [&](VF x, VF y) MIEN_LANES { return SeeBody(e, x, y); });
  if (e.joined) {
    const LeafEdge second = e.beyond();
    return AreaInStrips(px, py, 1.0f, strips,
                        [&](VF x, VF y) MIEN_LANES { return SeeJoined(e, second, x, y); });
  }
  const auto mine = Mine(e, px, py);
  return AreaInStrips(px, py, 1.0f, strips, [&](VF x, VF y) MIEN_LANES {
    return part == Part::end ? SeeEnd(e, x, y, mine) : SeeWithEnd(e, x, y, mine);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
