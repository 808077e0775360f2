// Feet and expansions of parabolas and ellipses in 16 leaves, compiled once per instruction set, in
// double precision. Derivations and bounds: docs/derivations/leaf_edges.md.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/sdf/edge/curve_leaves_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/sdf/edge/leaf_edges.h>
#include <mien/sdf/edge/leaf_remainder-inl.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE std::uint32_t Bits(hn::Mask<D> m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D(), m, bytes);
  return bytes[0] & ((1u << hn::Lanes(D())) - 1u);
}

HWY_INLINE void StoreLevel(const Bends& c, V toward, const Extent& extent, hn::Mask<D> steady,
                           CurveLeaves::Level& out, size_t i) {
  const D d;
  const Third third = FoldedThird(c, extent);
  // Along the outward normal n = toward·N the outline is −bend/2 X² − c3 X³ − c4 X⁴, X along
  // (−n.y, n.x): against the tangent if n = N, along it if n = −N.
  hn::Store(hn::Mul(hn::Neg(toward), c.k), d, out.bend.data() + i);
  hn::Store(third.c3, d, out.c3.data() + i);
  hn::Store(hn::Mul(hn::Mul(hn::Neg(toward), c.k2), Set(1.0 / 24)), d, out.c4.data() + i);
  hn::Store(hn::IfThenElse(steady, third.error, Set(kUnproven)), d, out.error.data() + i);
}

/// What a parabola's slope y can be within arc `reach` of the foot, as (1 + y²)⁻¹: its least and its most.
struct Flatness {
  V least, most;
};
HWY_INLINE Flatness FlatnessWithin(V y, V curvature, V reach) {
  const D d;
  // y changes by at most 2a per arc; and on one flank an arc spans at least the difference of y² over 4a.
  const V one = Set(1.0), shift = hn::Mul(hn::Abs(curvature), reach), a = hn::Abs(y);
  const V y2 = hn::Mul(y, y), twice = hn::Add(shift, shift);
  const V nearer = hn::Max(hn::Sub(a, shift), hn::Zero(d)), farther = hn::Add(a, shift);
  const V lo = hn::Max(hn::Mul(nearer, nearer), hn::Sub(y2, twice));
  const V hi = hn::Min(hn::Mul(farther, farther), hn::Add(y2, twice));
  return {hn::Div(one, hn::Add(hi, one)), hn::Div(one, hn::Add(lo, one))};
}

void ParabolaLeaves(const ParabolaForm& f, const Leaves& leaves, CurveLeaves& out) {
  const D d;
  const double r = leaves.radius, a = f.a, most = f.reach, l = f.level;
  const double level = l < 0 ? -l : l;
  const V one = Set(1.0), two_a = Set(2.0 * a);
  std::uint32_t proven = 0;
  for (size_t i = 0; i < Leaves::kMost && leaves.wanted >> i; i += hn::Lanes(d)) {
    const V px = hn::Sub(hn::Load(d, leaves.x.data() + i), Set(f.origin.x));
    const V py = hn::Sub(hn::Load(d, leaves.y.data() + i), Set(f.origin.y));
    const V rx = Set(f.right.x), ry = Set(f.right.y);
    const V u = Fused(px, rx, hn::Mul(py, ry)), v = FusedLess(py, rx, hn::Mul(px, ry));
    // The foot x solves x (1 − 2 a v) + 2 a² x³ = u.
    const V w = FusedFrom(two_a, v, one), aa = Set(2.0 * a * a);
    V x = hn::Div(u, hn::Max(Fused(aa, hn::Mul(u, u), w), Set(0.25)));
    if (f.steep()) {  // far from the vertex: from the foot on the piece's chord
      const double run = f.hi - f.lo, rise = a * (f.hi * f.hi - f.lo * f.lo);
      const double scale = run / (run * run + rise * rise);
      const V from_x = hn::Sub(u, Set(f.lo)), from_y = hn::Sub(v, Set(a * f.lo * f.lo));
      const V along = Fused(from_x, Set(run * scale), hn::Mul(from_y, Set(rise * scale)));
      x = hn::Add(Set(f.lo), hn::Min(hn::Max(along, Set(-0.5 * run)), Set(1.5 * run)));
    }
    // Halley's steps: what is left is the cube of the one before, times 4a² and less.
    // Lanes that arrived stay: who else is asked about changes nobody's bits.
    constexpr int kSteps = 12;
    auto moving = hn::Eq(one, one);
    for (int step = 0; step < kSteps; ++step) {
      const V cube = hn::Mul(aa, hn::Mul(x, x));
      const V off = FusedLess(x, hn::Add(w, cube), u), rise = Fused(Set(3.0), cube, w);
      const V safe = hn::Max(rise, Set(0.05));
      const V turn = hn::Mul(hn::Mul(Set(3.0), aa), hn::Mul(x, off));
      const V move = hn::Div(hn::Mul(off, safe), hn::Max(FusedLess(safe, safe, turn),
                                                         hn::Mul(Set(0.5), hn::Mul(safe, safe))));
      x = hn::Sub(x, hn::IfThenElseZero(moving, move));
      moving = hn::And(moving, hn::Gt(hn::Abs(move), Set(1e-4)));
      if (hn::AllFalse(d, moving)) break;
    }
    const V y = hn::Mul(two_a, x), sigma2 = Fused(y, y, one), sigma = hn::Sqrt(sigma2);
    const V is = hn::Div(one, sigma), du = hn::Sub(u, x), dv = FusedFrom(hn::Mul(Set(a), x), x, v);
    const V slip = hn::Mul(Fused(dv, y, du), is);  // along the tangent: 0 at a foot
    const V side = hn::Mul(FusedFrom(du, y, dv), is);
    // N = (−y, 1)/sigma in the frame.
    const V fx = hn::Neg(hn::Mul(y, is)), fy = is;
    const V nx = FusedLess(fx, rx, hn::Mul(fy, ry)), ny = Fused(fx, ry, hn::Mul(fy, rx));
    hn::Store(nx, d, out.nx.data() + i);
    hn::Store(ny, d, out.ny.data() + i);
    hn::Store(x, d, out.foot.data() + i);
    hn::Store(side, d, out.side.data() + i);

    // With c = cos φ of the slope, A = 2a, dφ/ds = k: k = A c³, and so on (the derivation).
    const V i2 = hn::Mul(is, is), i3 = hn::Mul(i2, is), i6 = hn::Mul(i3, i3);
    const V aa2 = hn::Mul(two_a, two_a), aa3 = hn::Mul(aa2, two_a);
    Bends c;
    c.k = hn::Mul(two_a, i3);
    c.k1 = hn::Mul(hn::Mul(Set(-3.0), aa2), hn::Mul(y, i6));
    c.k2 = hn::Mul(hn::Mul(Set(-3.0), aa3),
                   hn::Mul(hn::Mul(i6, i3), FusedFrom(Set(5.0), hn::Mul(y, y), one)));
    c.k3 = hn::Mul(hn::Mul(hn::Mul(Set(3.0), hn::Mul(aa2, aa2)), hn::Mul(hn::Mul(i6, i3), is)),
                   hn::Mul(y, FusedLess(Set(54.0), i2, Set(35.0))));
    const V bent = hn::Mul(Set(level), hn::Abs(c.k));
    const V least = f.stroke ? hn::Sub(one, bent) : FusedFrom(Set(l), c.k, one);
    const V arc = hn::Div(one, hn::Max(least, Set(0.25)));
    const Extent extent = ExtentOf(nx, ny, r, hn::Mul(c.k, arc), hn::Mul(c.k1, arc));
    const V reach = hn::Min(Set(2.0 * r),
                            hn::Mul(hn::Mul(Set(1.1), arc), hn::Mul(extent.stretch, extent.along)));
    // The fourth change is 3 A⁵ c¹¹ (648 c⁴ − 944 c² + 315), whose bracket is least at c² = 0.73: −28.8.
    const Flatness flat = FlatnessWithin(y, two_a, reach);
    const auto bracket = [](V c2) MIEN_LANES {
      return hn::Abs(Fused(Fused(Set(648.0), c2, Set(-944.0)), c2, Set(315.0)));
    };
    const V largest = hn::Max(Set(28.9), hn::Max(bracket(flat.least), bracket(flat.most)));
    const V c2 = flat.most, c4 = hn::Mul(c2, c2);
    const V c11 = hn::Mul(hn::Mul(c4, c4), hn::Mul(c2, hn::Sqrt(c2)));
    c.most_k4 = hn::Mul(hn::Mul(hn::Mul(Set(3.0), hn::Abs(aa3)), aa2), hn::Mul(c11, largest));

    const V distance = hn::Abs(side);
    auto ok = hn::And(hn::Le(hn::Abs(slip), Set(1e-9)), hn::Lt(distance, Set(most)));
    if (!feet_are_near(most, level, r)) ok = hn::Lt(one, hn::Zero(d));
    const V up = one, down = Set(-1.0);
    ok = hn::And(ok, hn::Gt(least, Set(0.25)));
    if (f.stroke) {
      const AtLevel over = BendsAt(c, Set(l), reach), under = BendsAt(c, Set(-l), reach);
      StoreLevel(over.bends, up, extent, over.steady, out.levels[0], i);
      StoreLevel(under.bends, down, extent, under.steady, out.levels[1], i);
    } else if (l == 0.0) {
      StoreLevel(c, down, extent, ok, out.levels[0], i);
    } else {
      const AtLevel there = BendsAt(c, Set(l), reach);
      StoreLevel(there.bends, down, extent, there.steady, out.levels[0], i);
    }
    proven |= Bits(ok) << i;
  }
  out.proven = proven;
}

void EllipseLeaves(const EllipseForm& f, const Leaves& leaves, CurveLeaves& out) {
  const D d;
  const double r = leaves.radius, small = f.a < f.b ? f.a : f.b;
  const double diff = f.a * f.a - f.b * f.b, spread = diff < 0 ? -diff : diff;
  const V one = Set(1.0), a = Set(f.a), b = Set(f.b), ab = Set(f.a * f.b);
  std::uint32_t proven = 0;
  for (size_t i = 0; i < Leaves::kMost && leaves.wanted >> i; i += hn::Lanes(d)) {
    const V px = hn::Sub(hn::Load(d, leaves.x.data() + i), Set(f.center.x));
    const V py = hn::Sub(hn::Load(d, leaves.y.data() + i), Set(f.center.y));
    const V ax = Set(f.axis.x), ay = Set(f.axis.y);
    const V x = Fused(px, ax, hn::Mul(py, ay)), y = FusedLess(py, ax, hn::Mul(px, ay));
    V c = hn::Div(x, a), s = hn::Div(y, b);
    const V size = hn::Max(hn::Sqrt(Fused(c, c, hn::Mul(s, s))), Set(1e-12));
    c = hn::Div(c, size), s = hn::Div(s, size);
    V slip = one, g = one;
    auto moving = hn::Eq(one, one);
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
      const V fx = hn::Mul(a, c), fy = hn::Mul(b, s), dx = hn::Sub(x, fx), dy = hn::Sub(y, fy);
      const V tx = hn::Neg(hn::Mul(a, s)), ty = hn::Mul(b, c);
      g = Fused(tx, tx, hn::Mul(ty, ty));
      slip = Fused(dx, tx, hn::Mul(dy, ty));
      const V rise = Fused(dx, fx, Fused(dy, fy, g));
      const V turn = hn::IfThenElseZero(
          moving, hn::Min(hn::Max(hn::Div(slip, hn::Max(rise, Set(1e-12))), Set(-0.5)), Set(0.5)));
      const V h = hn::Mul(turn, Set(0.5)), hh = hn::Mul(h, h), inv = hn::Div(one, hn::Add(one, hh));
      const V cos = hn::Mul(hn::Sub(one, hh), inv), sin = hn::Mul(turn, inv);
      const V next = FusedLess(c, cos, hn::Mul(s, sin));
      s = Fused(s, cos, hn::Mul(c, sin)), c = next;
      moving = hn::And(moving, hn::Gt(hn::Abs(turn), Set(1e-8)));
      if (hn::AllFalse(d, moving)) break;
    }
    const V tx = hn::Neg(hn::Mul(a, s)), ty = hn::Mul(b, c);
    g = Fused(tx, tx, hn::Mul(ty, ty));
    const V ig = hn::Div(one, g), root = hn::Sqrt(ig);  // 1/|t|
    const V dx = FusedFrom(a, c, x), dy = FusedFrom(b, s, y);
    slip = hn::Mul(Fused(dx, tx, hn::Mul(dy, ty)), root);
    const V nx = hn::Mul(ty, root), ny = hn::Neg(hn::Mul(tx, root));
    const V side = Fused(dx, nx, hn::Mul(dy, ny));
    const V world_x = FusedLess(nx, ax, hn::Mul(ny, ay)), world_y = Fused(nx, ay, hn::Mul(ny, ax));
    hn::Store(world_x, d, out.nx.data() + i);
    hn::Store(world_y, d, out.ny.data() + i);
    hn::Store(side, d, out.side.data() + i);
    hn::Store(c, d, out.foot.data() + i);

    const V g1 = hn::Mul(Set(2.0 * diff), hn::Mul(s, c));
    const V g2 = hn::Mul(Set(2.0 * diff), FusedLess(c, c, hn::Mul(s, s)));
    const V ig3 = hn::Mul(ig, hn::Mul(ig, ig));
    const V k = hn::Mul(ab, hn::Mul(ig, root));
    const V k1 = hn::Mul(hn::Mul(Set(-1.5), ab), hn::Mul(g1, ig3));
    // d/ds of that: −3/2 ab (g'' g^(−7/2) − 3 g'² g^(−9/2)).
    const V k2 = hn::Mul(hn::Mul(hn::Mul(Set(-1.5), ab), hn::Mul(ig3, root)),
                         FusedFrom(hn::Mul(Set(3.0), hn::Mul(g1, g1)), ig, g2));
    // Third: −3/2 ab g' g⁻⁴ (−4 − 19/2 g''/g + 27/2 (g'/g)²).
    const V p1 = hn::Mul(g1, ig), p2 = hn::Mul(g2, ig);
    const V k3 = hn::Mul(hn::Mul(Set(-1.5), ab),
                         hn::Mul(hn::Mul(p1, ig3), Fused(hn::Mul(Set(13.5), p1), p1,
                                                         Fused(Set(-9.5), p2, Set(-4.0)))));
    const Extent extent = ExtentOf(world_x, world_y, r, k, k1);
    // Fourth: 3/2 ab g^(−7/2) |4 Q − 54 P² + 19/2 Q² − 88 P² Q + 81 P⁴|, P = g'/g, Q = g''/g, at most with g as
    // small, g' and g'' as large as `arc` of way allows: |g'| <= |a² − b²|, |g''| <= 2 |a² − b²|.
    const V arc = hn::Min(Set(2.0 * r), hn::Mul(extent.stretch, extent.along));
    const V low = hn::Max(hn::Sub(g, hn::Mul(Set(spread / small), arc)), Set(small * small));
    const V il = hn::Div(one, low), wide = hn::Mul(Set(2.0 * spread), hn::Mul(arc, hn::Sqrt(il)));
    const V most1 = hn::Min(hn::Add(hn::Abs(g1), wide), Set(spread));
    const V most2 = hn::Min(Fused(Set(2.0), wide, hn::Abs(g2)), Set(2.0 * spread));
    const V big_p = hn::Mul(most1, il), big_q = hn::Mul(most2, il), pp = hn::Mul(big_p, big_p);
    const V of_q = hn::Mul(big_q, Fused(Set(9.5), big_q, Set(4.0)));
    const V of_p = hn::Mul(pp, Fused(Set(81.0), pp, Fused(Set(88.0), big_q, Set(54.0))));
    const V il3 = hn::Mul(il, hn::Mul(il, il));
    const V k4 =
        hn::Mul(hn::Mul(Set(1.5), hn::Mul(ab, hn::Sqrt(il))), hn::Mul(il3, hn::Add(of_q, of_p)));
    auto ok = hn::And(hn::Le(hn::Abs(slip), Set(1e-9 + 1e-15 * (f.a + f.b))),
                      hn::Lt(hn::Abs(side), Set(f.reach)));
    if (!feet_are_near(f.reach, 0.0, r)) ok = hn::Lt(one, hn::Zero(d));
    StoreLevel({k, k1, k2, k3, k4}, Set(-1.0), extent, ok, out.levels[0], i);
    proven |= Bits(ok) << i;
  }
  out.proven = proven;
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(ParabolaLeaves);
HWY_EXPORT(EllipseLeaves);
}  // namespace batch

void parabola_leaves(const ParabolaForm& form, const Leaves& leaves, CurveLeaves& out) {
  HWY_DYNAMIC_DISPATCH(batch::ParabolaLeaves)(form, leaves, out);
}
void ellipse_leaves(const EllipseForm& form, const Leaves& leaves, CurveLeaves& out) {
  HWY_DYNAMIC_DISPATCH(batch::EllipseLeaves)(form, leaves, out);
}

}  // namespace mien
#endif
