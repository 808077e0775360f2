// Squares of a leaf, a pixel or less, in sixteen parts: what several edges cross, where a round end begins,
// and what bends too much for one formula. Included once per instruction set.
#if defined(MIEN_RENDER_TILE_LEAF_PARTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_TILE_LEAF_PARTS_INL_H_
#undef MIEN_RENDER_TILE_LEAF_PARTS_INL_H_
#else
#define MIEN_RENDER_TILE_LEAF_PARTS_INL_H_
#endif

#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_edge-inl.h>
#include <mien/render/tile/leaf_errors.h>

#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Red, green and blue, times 255 and the share of the square they stand for.
struct Light {
  float r = 0, g = 0, b = 0;
};

HWY_INLINE void AddColor(const Leaf& leaf, std::uint32_t sides, float share, Light& to) {
  to.r += share * leaf.palette[0][sides];
  to.g += share * leaf.palette[1][sides];
  to.b += share * leaf.palette[2][sides];
}
HWY_INLINE void AddLight(const Light& light, float share, Light& to) {
  to.r += share * light.r, to.g += share * light.g, to.b += share * light.b;
}

/// How far an outline may be off for a pixel of 8 bits (see Plan::tolerance).
HWY_INLINE float ToleranceOf(const Leaf& leaf) {
  return leaf.blend == Blend::linear ? 0x1p-13f : 0x1p-11f;
}

/// An edge as the sixteen parts see it; distances in sides of a part.
struct EdgeInParts {
  alignas(64) float d[kBlock], gx[kBlock], gy[kBlock], k[kBlock], area[kBlock];
  std::uint32_t crossed, inside;  // inside: parts it does not cross
  std::uint32_t divide;           // parts that one formula is too coarse for
  std::uint32_t hidden;           // parts where a part of theirs may see what their centre does not
};

HWY_INLINE std::uint32_t BitsOf(hn::Mask<F> m) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(F(), m, bits);
  return (std::uint32_t(bits[0]) | std::uint32_t(bits[1]) << 8) & ((1u << hn::Lanes(F())) - 1u);
}

/// Into how many strips a part is cut across an edge, by its bend b in sides of a part. What one formula loses,
/// b/24 of a part, it loses where the edge runs along a side that it just misses: in two parts of a pixel's sixteen.
/// 0.18 makes that a quarter of a level (measured: 0.07); in strips it falls with their number's square.
HWY_INLINE int StripsOfPart(float bend) {
  return bend <= 0.18f ? 1 : bend <= 0.5f ? 2 : bend <= 2.0f ? 4 : 8;
}

/// Squares of half diagonal r around (px, py) that may hold the place where a body becomes its round end.
HWY_INLINE auto MayHoldEnd(const LeafEdge& e, VF px, VF py, float r) {
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  const VF beyond = Fused(ux, Const(e.along_x), hn::Mul(uy, Const(e.along_y)));
  const VF up = Fused(ux, Const(e.end_nx), hn::Mul(uy, Const(e.end_ny)));
  const VF rho = hn::Sqrt(Fused(ux, ux, hn::Mul(uy, uy)));
  const auto on_line = hn::And(hn::Lt(hn::Abs(beyond), Const(r)), hn::Gt(up, Const(-r)));
  return hn::And(on_line, hn::Lt(hn::Abs(hn::Sub(rho, Const(1.0f / e.end_bend))), Const(2.0f * r)));
}

/// Squares with parts that may see more of the edge than their centre does: across its end's line, or where
/// the round end is the other edge's.
HWY_INLINE auto HidesInParts(const LeafEdge& e, VF px, VF py, float r) {
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  const VF beyond = Fused(ux, Const(e.along_x), hn::Mul(uy, Const(e.along_y)));
  const VF up = Fused(ux, Const(e.end_nx), hn::Mul(uy, Const(e.end_ny)));
  const VF rho2 = Fused(ux, ux, hn::Mul(uy, uy));
  const float far = 1.0f / e.end_bend + kEndHalo + r;  // beyond, the outside is both halves'
  const auto across = hn::Or(hn::Lt(beyond, Const(r)), hn::Lt(up, Const(r)));
  return hn::And(hn::And(hn::Gt(beyond, Const(-r)), across), hn::Lt(rho2, Const(far * far)));
}

/// Squares of `side` that may hold a joint.
HWY_INLINE auto MayHoldJoint(const LeafEdge& e, VF px, VF py, float side) {
  const VF ux = hn::Sub(px, Const(e.end_x)), uy = hn::Sub(py, Const(e.end_y));
  return hn::Le(Fused(ux, ux, hn::Mul(uy, uy)), Const(side * side));
}

/// The edge from the centres of sixteen parts of side `step` around (cx, cy).
HWY_NOINLINE void SeeParts(const LeafEdge& e, float cx, float cy, float step, const Leaf& leaf,
                           EdgeInParts& out) {
  const F f;
  const float tolerance = ToleranceOf(leaf);
  const float inverse = 1.0f / step;
  const float end_bend = e.has_end() ? e.end_bend : 0.0f;
  const auto size = [](float x) { return x < 0 ? -x : x; };
  const float most = HWY_MAX(HWY_MAX(size(e.bend), size(e.next.bend)), end_bend);
  const int strips = StripsOfPart(ShownBy(leaf.blend) * most * step);
  // An end begins in one part of a pixel or two.
  const bool end_matters = e.has_end() && end_error(end_bend, step) > 2.0f * tolerance;
  const bool joint_matters = e.joined && joint_error(e.next.bend - e.bend, step) > tolerance;
  const LeafEdge second = e.joined ? e.beyond() : LeafEdge{};
  out.crossed = out.inside = out.divide = out.hidden = 0;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(f)) {
    const VF px = Fused(hn::Load(f, kPixels.x + i), Const(step), Const(cx));
    const VF py = Fused(hn::Load(f, kPixels.y + i), Const(step), Const(cy));
    const auto mine = Mine(e, px, py);
    const auto see = [&](VF x, VF y) MIEN_LANES {
      if (e.joined) return SeeJoined(e, second, x, y);
      return e.has_end() ? SeeWithEnd(e, x, y, mine) : SeeBody(e, x, y);
    };
    const Sight s = see(px, py);
    const VF d = hn::Mul(s.d, Const(inverse)), bend = hn::Mul(hn::Abs(s.k), Const(step));
    const VF wide = hn::Add(hn::Abs(s.gx), hn::Abs(s.gy));
    auto crossed = hn::Le(hn::Abs(d), Fused(wide, Const(0.5f), hn::Mul(bend, Const(0.36f))));
    const VF b3 = hn::Mul(hn::Mul(bend, bend), bend);
    auto divide =
        hn::And(crossed, hn::Gt(hn::Mul(b3, Const(float(kParabola) * step)), Const(tolerance)));
    if (e.has_end()) {
      const float r = 0.7072f * step;
      const auto at_end = MayHoldEnd(e, px, py, r);
      crossed = hn::Or(crossed, at_end);
      if (end_matters) divide = hn::Or(divide, at_end);
      out.hidden |= BitsOf(HidesInParts(e, px, py, r)) << i;
    } else if (joint_matters) {
      divide = hn::Or(divide, MayHoldJoint(e, px, py, step));
    }
    const VF area = strips == 1 ? EdgeArea(f, d, s.gx, s.gy, hn::Mul(s.k, Const(step)))
                                : AreaInStrips(px, py, step, strips, see);
    hn::Store(d, f, out.d + i), hn::Store(s.gx, f, out.gx + i), hn::Store(s.gy, f, out.gy + i);
    hn::Store(hn::Mul(s.k, Const(step)), f, out.k + i);
    const auto in = hn::AndNot(crossed, hn::Lt(d, hn::Zero(f)));
    hn::Store(hn::IfThenElse(crossed, area, hn::IfThenElseZero(in, Const(1.0f))), f, out.area + i);
    out.crossed |= BitsOf(crossed) << i, out.inside |= BitsOf(in) << i;
    out.divide |= BitsOf(divide) << i;
  }
}

/// A straight edge: the unit normal, never quite along an axis, and the signed distance to it.
struct StraightEdge {
  VF d, nx, ny, inverse_x, inverse_y;  ///< 1/nx, 1/ny
};

/// The straight edge for a bent one: moved by the mean of the bend over the tangent's chord.
HWY_INLINE StraightEdge Straighten(VF d, VF gx, VF gy, VF k) {
  const VF half = Const(0.5f), one = Const(1.0f), tiny = Const(1e-5f);
  gx = hn::CopySign(hn::Max(hn::Abs(gx), tiny), gx);
  gy = hn::CopySign(hn::Max(hn::Abs(gy), tiny), gy);
  const VF inverse = hn::Div(one, hn::Sqrt(Fused(gx, gx, hn::Mul(gy, gy))));
  const VF nx = hn::Mul(gx, inverse), ny = hn::Mul(gy, inverse), x = hn::Mul(d, inverse);
  const VF ix = hn::Div(one, nx), iy = hn::Div(one, ny);
  const VF ax = hn::Abs(nx), ay = hn::Abs(ny), corner = hn::Mul(half, hn::Add(ax, ay));
  const VF at = hn::Min(hn::Max(x, hn::Neg(corner)), corner);
  // The tangent at arc t, by symmetry with (ax, ay) for its normal: −at ax − t ay and t ax − at ay in ±1/2.
  const VF da = hn::Mul(at, ax), db = hn::Mul(at, ay), ia = hn::Abs(ix), ib = hn::Abs(iy);
  const VF lo = hn::Max(hn::Mul(hn::Sub(db, half), ia), hn::Mul(hn::Neg(hn::Add(da, half)), ib));
  const VF hi = hn::Min(hn::Mul(hn::Add(db, half), ia), hn::Mul(hn::Sub(half, da), ib));
  const VF mean = Fused(hi, hi, Fused(lo, hi, hn::Mul(lo, lo)));
  return {Fused(hn::Mul(k, Const(1.0f / 6)), mean, x), nx, ny, ix, iy};
}

/// An interval of a line.
struct Stretch {
  VF lo, hi;
};

/// Keeps of it where at + t / inverse <= 0.
HWY_INLINE Stretch Keep(Stretch s, VF at, VF inverse) {
  const VF root = hn::Neg(hn::Mul(at, inverse));
  const auto rises = hn::Gt(inverse, hn::Zero(F()));
  return {hn::IfThenElse(rises, s.lo, hn::Max(s.lo, root)),
          hn::IfThenElse(rises, hn::Min(s.hi, root), s.hi)};
}
HWY_INLINE VF LengthOf(Stretch s) {
  return hn::Max(hn::Sub(s.hi, s.lo), hn::Zero(F()));
}

/// The line of `a` inside the square and `b`, times half its distance from the centre: by Green its share of
/// the area. `inverse`: of the slope of b's distance along a.
HWY_INLINE VF AlongCut(const StraightEdge& a, const StraightEdge& b, VF inverse) {
  const VF half = Const(0.5f), x = hn::Neg(hn::Mul(a.d, a.nx)), y = hn::Neg(hn::Mul(a.d, a.ny));
  // The line is (x − ny t, y + nx t): in ±1/2 both, as intervals around their middles.
  const VF mx = hn::Mul(x, a.inverse_y), my = hn::Neg(hn::Mul(y, a.inverse_x));
  const VF wx = hn::Abs(hn::Mul(half, a.inverse_y)), wy = hn::Abs(hn::Mul(half, a.inverse_x));
  const Stretch in_square{hn::Max(hn::Sub(mx, wx), hn::Sub(my, wy)),
                          hn::Min(hn::Add(mx, wx), hn::Add(my, wy))};
  const VF at = Fused(x, b.nx, Fused(y, b.ny, b.d));
  return hn::Neg(hn::Mul(hn::Mul(a.d, half), LengthOf(Keep(in_square, at, inverse))));
}

/// The area of the unit square inside two straight edges.
///
/// Derivation.  By Green, half the sum over the region's sides of length times distance from the centre: the
///   square's four, each cut by both edges, and the two edges, each cut by the square and the other. Edges that
///   are almost parallel (|sin| <= 0.002) are nested or apart: the smaller area, or what both have too much.
/// Error.  Those: a triangle of height 0.002 · 0.7, below 3e-4. The others: rounding divided by the sine,
///   second order in the area.
HWY_INLINE VF AreaInsideBoth(const StraightEdge& a, const StraightEdge& b, VF area_a, VF area_b) {
  const F f;
  const VF zero = hn::Zero(f);
  VF around = zero;
  for (const float side : {-0.5f, 0.5f}) {
    const VF c = Const(side);
    const Stretch whole{Const(-0.5f), Const(0.5f)};
    const Stretch in_y =
        Keep(Keep(whole, Fused(c, a.nx, a.d), a.inverse_y), Fused(c, b.nx, b.d), b.inverse_y);
    const Stretch in_x =
        Keep(Keep(whole, Fused(c, a.ny, a.d), a.inverse_x), Fused(c, b.ny, b.d), b.inverse_x);
    around = hn::Add(around, hn::Add(LengthOf(in_y), LengthOf(in_x)));
  }
  const VF sine = FusedLess(a.nx, b.ny, hn::Mul(a.ny, b.nx));
  const VF cosine = Fused(a.nx, b.nx, hn::Mul(a.ny, b.ny));
  const VF steep = hn::CopySign(hn::Max(hn::Abs(sine), Const(1e-5f)), sine);
  const VF inverse =
      hn::Div(Const(1.0f), steep);  // of b's slope along a; a's along b is its negative
  const VF cuts = hn::Add(AlongCut(a, b, inverse), AlongCut(b, a, hn::Neg(inverse)));
  const VF crossing = Fused(around, Const(0.25f), cuts);
  const VF lesser = hn::Min(area_a, area_b);
  const VF least = hn::Max(zero, hn::Sub(hn::Add(area_a, area_b), Const(1.0f)));
  const VF parallel = hn::IfThenElse(hn::Gt(cosine, zero), lesser, least);
  const VF area = hn::IfThenElse(hn::Gt(hn::Abs(sine), Const(0.002f)), crossing, parallel);
  return hn::Min(hn::Max(area, least), lesser);
}

/// Edges that are one and the same in a part, as the round ends of lines that meet are: no more than 0.001 of
/// its side apart in it.
HWY_INLINE auto AreTheSame(VF da, VF gxa, VF gya, VF ka, VF db, VF gxb, VF gyb, VF kb) {
  const VF near = Const(4e-4f), sine = FusedLess(gxa, gyb, hn::Mul(gya, gxb));
  const auto in_place = hn::And(hn::Le(hn::Abs(hn::Sub(da, db)), near),
                                hn::Le(hn::Abs(hn::Sub(ka, kb)), Const(1e-3f)));
  const auto in_turn = hn::And(hn::Le(hn::Abs(sine), near),
                               hn::Gt(Fused(gxa, gxb, hn::Mul(gya, gyb)), hn::Zero(F())));
  return hn::And(in_place, in_turn);
}

/// What pairs of edges cover together, part by part. Returns the pairs that bend too much to be taken for
/// straight.
HWY_INLINE std::uint32_t AreasInsideBoth(const EdgeInParts& a, const EdgeInParts& b, size_t count,
                                         float step, float tolerance, float* both) {
  const F f;
  const float most = tolerance / (float(kTogether) * step * step);
  std::uint32_t divide = 0;
  for (size_t i = 0; i < count; i += hn::Lanes(f)) {
    const VF area_a = hn::Load(f, a.area + i), area_b = hn::Load(f, b.area + i);
    const VF da = hn::Load(f, a.d + i), gxa = hn::Load(f, a.gx + i), gya = hn::Load(f, a.gy + i);
    const VF db = hn::Load(f, b.d + i), gxb = hn::Load(f, b.gx + i), gyb = hn::Load(f, b.gy + i);
    const VF ka = hn::Load(f, a.k + i), kb = hn::Load(f, b.k + i);
    const auto whole = [&](VF area) MIEN_LANES {
      return hn::Or(hn::Le(area, hn::Zero(f)), hn::Ge(area, Const(1.0f)));
    };
    const auto easy = hn::Or(whole(area_a), whole(area_b));
    VF area = hn::Mul(area_a, area_b);
    if (!hn::AllTrue(f, easy)) {
      const auto same = AreTheSame(da, gxa, gya, ka, db, gxb, gyb, kb);
      const VF cut = AreaInsideBoth(Straighten(da, gxa, gya, ka), Straighten(db, gxb, gyb, kb),
                                    area_a, area_b);
      area = hn::IfThenElse(easy, area, hn::IfThenElse(same, hn::Min(area_a, area_b), cut));
      const auto bent = hn::Gt(hn::Add(hn::Abs(ka), hn::Abs(kb)), Const(most));
      divide |= BitsOf(hn::AndNot(hn::Or(easy, same), bent)) << i;
    }
    hn::Store(area, f, both + i);
  }
  return divide;
}

/// The sum of sixteen, in one order on every instruction set.
HWY_INLINE float SumOf(float* x) {
  for (size_t width = kBlock / 2; width > 0; width /= 2)
    for (size_t i = 0; i < width; ++i) x[i] += x[i + width];
  return x[0];
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

Light InParts(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx, float cy,
              float side, int depth);

constexpr float kShare = 1.0f / kBlock;  // of a part

/// One part on its own: again in sixteen, or by the scalar form when it is a sixty-fourth of a pixel.
HWY_INLINE Light OnePart(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx,
                         float cy, float step, int depth, size_t part) {
  constexpr int kDeepest = 2;
  const float x = cx + kPixels.x[part] * step, y = cy + kPixels.y[part] * step;
  if (depth < kDeepest) return InParts(leaf, active, base, x, y, step, depth + 1);
  long long cells = 0;
  const Mix mix = leaf_square(leaf, x, y, step, active, base, ToleranceOf(leaf), cells);
  return {float(mix.r), float(mix.g), float(mix.b)};
}

HWY_INLINE void CopyPart(const EdgeInParts& from, size_t part, EdgeInParts& to, size_t at) {
  to.d[at] = from.d[part], to.gx[at] = from.gx[part], to.gy[at] = from.gy[part];
  to.k[at] = from.k[part], to.area[at] = from.area[part];
}

/// One edge alone.
HWY_INLINE Light OneInParts(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx,
                            float cy, float step, int depth) {
  EdgeInParts e;
  SeeParts(leaf.edges[std::size_t(std::countr_zero(active))], cx, cy, step, leaf, e);
  Light light;
  for (std::uint32_t rest = e.divide; rest; rest &= rest - 1) {
    const auto i = size_t(std::countr_zero(rest));
    AddLight(OnePart(leaf, active, base, cx, cy, step, depth, i), kShare, light);
    e.area[i] = 0;
  }
  const float all = float(int(kBlock) - std::popcount(e.divide)), area = SumOf(e.area);
  AddColor(leaf, base | active, area * kShare, light);
  AddColor(leaf, base, (all - area) * kShare, light);
  return light;
}

/// Two edges: areas of their four combinations, summed over the parts.
HWY_INLINE Light TwoInParts(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx,
                            float cy, float step, int depth) {
  const float tolerance = ToleranceOf(leaf);
  const std::uint32_t bit_a = active & -active, bit_b = active & ~bit_a;
  EdgeInParts a, b;
  SeeParts(leaf.edges[std::size_t(std::countr_zero(bit_a))], cx, cy, step, leaf, a);
  SeeParts(leaf.edges[std::size_t(std::countr_zero(bit_b))], cx, cy, step, leaf, b);
  alignas(64) float both[kBlock];
  std::uint32_t divide = AreasInsideBoth(a, b, kBlock, step, tolerance, both);
  divide = (divide & a.crossed & b.crossed) | a.divide | b.divide;
  Light light;
  for (std::uint32_t rest = divide; rest; rest &= rest - 1) {
    const auto i = size_t(std::countr_zero(rest));
    AddLight(OnePart(leaf, active, base, cx, cy, step, depth, i), kShare, light);
    a.area[i] = b.area[i] = both[i] = 0;
  }
  const float all = float(int(kBlock) - std::popcount(divide));
  const float area_a = SumOf(a.area), area_b = SumOf(b.area), area = SumOf(both);
  AddColor(leaf, base | active, area * kShare, light);
  AddColor(leaf, base | bit_a, (area_a - area) * kShare, light);
  AddColor(leaf, base | bit_b, (area_b - area) * kShare, light);
  AddColor(leaf, base, (all - area_a - area_b + area) * kShare, light);
  return light;
}

/// Whether two edges are the same in a part.
HWY_INLINE bool AreTheSame(const EdgeInParts& a, const EdgeInParts& b, size_t i) {
  const float near = 4e-4f, sine = a.gx[i] * b.gy[i] - a.gy[i] * b.gx[i];
  return std::abs(a.d[i] - b.d[i]) <= near && std::abs(sine) <= near &&
         std::abs(a.k[i] - b.k[i]) <= 1e-3f && a.gx[i] * b.gx[i] + a.gy[i] * b.gy[i] > 0;
}

/// Any number of edges: part by part, by what is left in it.
HWY_INLINE Light AnyInParts(const Leaf& leaf, const std::uint32_t active, std::uint32_t base,
                            float cx, float cy, float step, int depth) {
  EdgeInParts edges[Leaf::kMostEdges];
  for (std::uint32_t rest = active; rest; rest &= rest - 1) {
    const auto e = std::size_t(std::countr_zero(rest));
    SeeParts(leaf.edges[e], cx, cy, step, leaf, edges[e]);
  }
  struct Pair {
    std::uint32_t sides, a, b;  // edges that are the same are one
    std::uint32_t asked;
    size_t part;
  };
  Light light;
  Pair found[kBlock];
  EdgeInParts pair_a, pair_b;
  size_t count = 0;
  for (size_t i = 0; i < kBlock; ++i) {
    std::uint32_t sides = base, crossing = 0, divide = 0, hidden = 0;
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const auto e = std::size_t(std::countr_zero(rest));
      crossing |= (edges[e].crossed >> i & 1u) << e, sides |= (edges[e].inside >> i & 1u) << e;
      divide |= (edges[e].divide >> i & 1u) << e, hidden |= (edges[e].hidden >> i & 1u) << e;
    }
    const std::uint32_t asked = crossing | hidden;  // in a part of this part
    if (crossing) crossing = Mattering(leaf, crossing, sides);
    if (!crossing) {
      AddColor(leaf, sides, kShare, light);
      continue;
    }
    const auto first = std::size_t(std::countr_zero(crossing));
    std::uint32_t a = 1u << first, b = 0, more = 0;
    std::size_t second = 0;
    for (std::uint32_t rest = crossing & ~a; rest; rest &= rest - 1) {
      const auto e = std::size_t(std::countr_zero(rest));
      if (AreTheSame(edges[first], edges[e], i))
        a |= 1u << e;
      else if (!b)
        b = 1u << e, second = e;
      else if (AreTheSame(edges[second], edges[e], i))
        b |= 1u << e;
      else
        more |= 1u << e;
    }
    if (more || (divide & crossing)) {
      AddLight(OnePart(leaf, asked, sides & ~asked, cx, cy, step, depth, i), kShare, light);
    } else if (!b) {
      const float area = edges[first].area[i];
      AddColor(leaf, sides | a, area * kShare, light);
      AddColor(leaf, sides, (1.0f - area) * kShare, light);
    } else {
      CopyPart(edges[first], i, pair_a, count), CopyPart(edges[second], i, pair_b, count);
      found[count++] = {sides, a, b, asked, i};
    }
  }
  if (count == 0) return light;
  for (size_t i = count; i < kBlock; ++i)
    CopyPart(pair_a, count - 1, pair_a, i), CopyPart(pair_b, count - 1, pair_b, i);
  alignas(64) float joined[kBlock];
  const std::uint32_t bent =
      AreasInsideBoth(pair_a, pair_b, count, step, ToleranceOf(leaf), joined);
  for (size_t i = 0; i < count; ++i) {
    const Pair& p = found[i];
    if (bent >> i & 1u) {
      AddLight(OnePart(leaf, p.asked, p.sides & ~p.asked, cx, cy, step, depth, p.part), kShare,
               light);
      continue;
    }
    const float both = joined[i], a = pair_a.area[i], b = pair_b.area[i];
    AddColor(leaf, p.sides | p.a | p.b, both * kShare, light);
    AddColor(leaf, p.sides | p.a, (a - both) * kShare, light);
    AddColor(leaf, p.sides | p.b, (b - both) * kShare, light);
    AddColor(leaf, p.sides, (1.0f - a - b + both) * kShare, light);
  }
  return light;
}

/// The mean colour of the square of `side` around (cx, cy). `active`: edges that may cross it; `base`: inside
/// which of the others it lies. Opaque colours, for pixels of 8 bits.
HWY_NOINLINE Light InParts(const Leaf& leaf, std::uint32_t active, std::uint32_t base, float cx,
                           float cy, float side, int depth) {
  const float step = 0.25f * side;
  if (!active) return {leaf.palette[0][base], leaf.palette[1][base], leaf.palette[2][base]};
  if ((active & (active - 1)) == 0) return OneInParts(leaf, active, base, cx, cy, step, depth);
  if (std::popcount(active) == 2) return TwoInParts(leaf, active, base, cx, cy, step, depth);
  return AnyInParts(leaf, active, base, cx, cy, step, depth);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
