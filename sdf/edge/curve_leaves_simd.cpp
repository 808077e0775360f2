// Feet and expansions of parabolas and ellipses in 16 leaves, compiled once per instruction set, in
// double precision. Derivations and bounds: docs/derivations/leaf_edges.md.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/sdf/edge/curve_leaves_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/sdf/batch/fma-inl.h>
#include <mien/sdf/edge/leaf_edges.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;

HWY_INLINE V Set(double x) {
  return hn::Set(D(), x);
}

/// How far along the tangent a leaf's points lie from its centre, and so from the foot: a square's half side
/// times |n.x| + |n.y|. From 0.71 to 1 of the radius; its fifth power is what counts.
HWY_INLINE V Along(V nx, V ny, double radius) {
  constexpr double kHalfSide = 0.70710678118654757;
  return hn::Mul(hn::Add(hn::Abs(nx), hn::Abs(ny)), Set(kHalfSide * radius));
}

/// A bound on how far the outline leaves circle + (c3 X³ + c4 X⁴)(1 + (bend X)²/2) for |X| <= along, from its
/// curvature's first two changes per arc at the foot and a bound on the third over the leaf.
HWY_INLINE V Remainder(V bend, V change, V change2, V change3, V along) {
  const V turn = hn::Mul(hn::Abs(bend), along), turn2 = hn::Mul(turn, turn);
  // Arc length over |X|: asin(z)/z <= 1 + z²/4 for z <= 0.7.
  const V s = hn::Mul(along, Fused(turn2, Set(0.25), Set(1.0)));
  const V s2 = hn::Mul(s, s), s4 = hn::Mul(s2, s2), s5 = hn::Mul(s4, s);
  const V k2 = hn::Mul(bend, bend);
  const V cross = Fused(hn::Abs(change2), hn::Mul(s, Set(0.5)), hn::Abs(change));
  // Products of the change with itself: its turn, s² change/2, acting over its own displacement.
  const V self = hn::Mul(hn::Mul(hn::Mul(change, change), s5), hn::Mul(turn, s));
  // What 1 + (bend X)²/2 leaves of X against arc length: 0.0083 and, next, below 0.06 (bend X)².
  const V slip = Fused(turn2, Set(0.08), Set(0.012));
  const V sum = Fused(hn::Mul(hn::Mul(slip, k2), cross), s5,
                      Fused(change3, hn::Mul(s5, Set(1.0 / 120)), hn::Mul(self, Set(0.05))));
  const V unproven = Set(kUnproven);
  return hn::IfThenElse(hn::Le(turn, Set(0.7)), hn::Mul(sum, Set(1.25)), unproven);
}

HWY_INLINE std::uint32_t Bits(hn::Mask<D> m) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(D(), m, bytes);
  return bytes[0] & ((1u << hn::Lanes(D())) - 1u);
}

/// The outline at `level` of a curve with curvature k, changing by k1, k2 and at most k3 per arc.
struct OutlineBends {
  V k, k1, k2, k3;
};
HWY_INLINE V StoreLevel(const OutlineBends& c, V level, V toward, V along, CurveLeaves::Level& out,
                        size_t i) {
  const D d;
  const V one = Set(1.0), m = FusedFrom(level, c.k, one);
  const V inverse = hn::Div(one, hn::Max(m, Set(0.05)));
  const V i2 = hn::Mul(inverse, inverse), i3 = hn::Mul(i2, inverse), i5 = hn::Mul(i3, i2);
  const V bend = hn::Mul(c.k, inverse), change = hn::Mul(c.k1, i3);
  const V change2 =
      hn::Mul(i5, Fused(c.k2, m, hn::Mul(hn::Mul(Set(3.0), level), hn::Mul(c.k1, c.k1))));
  // |l| grown by what the curvature may change within the leaf is in k3's own bound.
  const V l = hn::Abs(level), a1 = hn::Abs(c.k1);
  const V k3 = hn::Mul(
      hn::Mul(i5, i2),
      Fused(c.k3, hn::Mul(m, m),
            Fused(hn::Mul(Set(10.0), hn::Mul(l, a1)), hn::Mul(hn::Abs(c.k2), hn::Max(m, one)),
                  hn::Mul(Set(15.0), hn::Mul(hn::Mul(l, l), hn::Mul(a1, hn::Mul(a1, a1)))))));
  const V error = Remainder(bend, change, change2, k3, along);
  // Along the outward normal n = toward·N the outline is −bend/2 X² − c3 X³ − c4 X⁴, X along
  // (−n.y, n.x): against the tangent if n = N, along it if n = −N.
  hn::Store(hn::Mul(hn::Neg(toward), bend), d, out.bend.data() + i);
  hn::Store(hn::Mul(change, Set(1.0 / 6)), d, out.c3.data() + i);
  hn::Store(hn::Mul(hn::Mul(hn::Neg(toward), change2), Set(1.0 / 24)), d, out.c4.data() + i);
  hn::Store(error, d, out.error.data() + i);
  return m;
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
    V off = one;
    constexpr int kSteps = 12;
    for (int step = 0; step < kSteps; ++step) {
      const V x2 = hn::Mul(x, x), cube = hn::Mul(aa, x2);
      off = hn::Sub(hn::Mul(x, hn::Add(w, cube)), u);
      const V rise = Fused(Set(3.0), cube, w);
      const V move = hn::Div(off, hn::Max(rise, Set(0.05)));
      x = hn::Sub(x, move);
      if (hn::AllTrue(d, hn::Le(hn::Abs(move), Set(1e-7)))) break;  // the step after: 1e-14
    }
    const V y = hn::Mul(two_a, x), sigma2 = Fused(y, y, one), sigma = hn::Sqrt(sigma2);
    const V is = hn::Div(one, sigma), du = hn::Sub(u, x), dv = FusedFrom(hn::Mul(Set(a), x), x, v);
    const V slip = hn::Mul(Fused(dv, y, du), is);  // along the tangent: 0 at a foot
    const V side = hn::Mul(FusedFrom(du, y, dv), is);
    // N = (−y, 1)/sigma in the frame.
    const V fx = hn::Neg(hn::Mul(y, is)), fy = is;
    const V nx = FusedLess(fx, rx, hn::Mul(fy, ry)), ny = Fused(fx, ry, hn::Mul(fy, rx));
    const V along = Along(nx, ny, r);
    hn::Store(nx, d, out.nx.data() + i);
    hn::Store(ny, d, out.ny.data() + i);
    hn::Store(x, d, out.foot.data() + i);
    hn::Store(side, d, out.side.data() + i);

    const V i2 = hn::Mul(is, is), i3 = hn::Mul(i2, is), i6 = hn::Mul(i3, i3);
    OutlineBends c;
    const V aa2 = hn::Mul(two_a, two_a), aa3 = hn::Mul(aa2, two_a);
    c.k = hn::Mul(two_a, i3);
    c.k1 = hn::Mul(hn::Mul(Set(-3.0), aa2), hn::Mul(y, i6));
    c.k2 = hn::Mul(hn::Mul(Set(-3.0), aa3),
                   hn::Mul(hn::Mul(i6, i3), FusedFrom(Set(5.0), hn::Mul(y, y), one)));
    // |d³k/ds³| <= (2a)⁴ min(8.8, 105 (1 + y²)^(−9/2)), y as small as the leaf allows: feet lie
    // within arc 2·radius, so within that in x; and on one flank an arc spans at least the
    // difference of y² over 4a.
    const V shift = hn::Mul(hn::Abs(two_a), Set(2.0 * r));
    const V nearer = hn::Max(hn::Sub(hn::Abs(y), shift), hn::Zero(d));
    const V least = hn::Max(hn::Mul(nearer, nearer), FusedFrom(Set(2.0), shift, hn::Mul(y, y)));
    const V j2 = hn::Div(one, hn::Add(least, one)), j4 = hn::Mul(j2, j2);
    c.k3 = hn::Mul(hn::Mul(aa2, aa2),
                   hn::Min(Set(8.8), hn::Mul(hn::Mul(Set(105.0), hn::Mul(j4, j4)), hn::Sqrt(j2))));

    // Points of the leaf on the outline are `level` from the curve, so the way to them from the
    // centre keeps within level + radius; feet then lie within arc radius·reach/(reach − that).
    // Half the reach makes that 2·radius, as assumed.
    const V distance = hn::Abs(side);
    auto ok = hn::And(hn::Le(hn::Abs(slip), Set(1e-9)), hn::Lt(distance, Set(most)));
    if (!(2.0 * (level + r) <= most)) ok = hn::Lt(one, hn::Zero(d));
    const V up = one, down = Set(-1.0);
    if (f.stroke) {
      const V m0 = StoreLevel(c, Set(l), up, along, out.levels[0], i);
      const V m1 = StoreLevel(c, Set(-l), down, along, out.levels[1], i);
      ok = hn::And(ok, hn::Gt(hn::Min(m0, m1), Set(0.25)));
    } else {
      ok = hn::And(ok, hn::Gt(StoreLevel(c, Set(l), down, along, out.levels[0], i), Set(0.25)));
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
    constexpr int kSteps = 8;
    for (int step = 0; step < kSteps; ++step) {
      const V fx = hn::Mul(a, c), fy = hn::Mul(b, s), dx = hn::Sub(x, fx), dy = hn::Sub(y, fy);
      const V tx = hn::Neg(hn::Mul(a, s)), ty = hn::Mul(b, c);
      g = Fused(tx, tx, hn::Mul(ty, ty));
      slip = Fused(dx, tx, hn::Mul(dy, ty));
      const V rise = Fused(dx, fx, Fused(dy, fy, g));
      const V turn =
          hn::Min(hn::Max(hn::Div(slip, hn::Max(rise, Set(1e-12))), Set(-0.5)), Set(0.5));
      const V h = hn::Mul(turn, Set(0.5)), hh = hn::Mul(h, h), inv = hn::Div(one, hn::Add(one, hh));
      const V cos = hn::Mul(hn::Sub(one, hh), inv), sin = hn::Mul(turn, inv);
      const V next = FusedLess(c, cos, hn::Mul(s, sin));
      s = Fused(s, cos, hn::Mul(c, sin)), c = next;
      if (hn::AllTrue(d, hn::Le(hn::Abs(turn), Set(1e-8)))) break;
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
    // Third: at most 3/2 ab |g'| (4 + 9.5 |g''|/g + 13.5 g'²/g²) / g⁴, with g as small as the leaf
    // allows, |g'| <= |a² − b²|, |g''| <= 2 |a² − b²|. Feet lie within arc 2·radius.
    const V low = hn::Max(hn::Sub(g, Set(spread * 2.0 * r / small)), Set(small * small));
    const V il = hn::Div(one, low), ratio = hn::Mul(Set(spread), il), il2 = hn::Mul(il, il);
    const V most1 = hn::Min(Fused(Set(4.0 * spread * r), hn::Sqrt(il), hn::Abs(g1)), Set(spread));
    const V part = hn::Mul(most1, il);
    const V inner = Fused(hn::Mul(Set(13.5), part), part, Fused(Set(19.0), ratio, Set(4.0)));
    const V k3 = hn::Mul(hn::Mul(Set(1.5), hn::Mul(most1, ab)), hn::Mul(hn::Mul(il2, il2), inner));
    const V error = Remainder(k, k1, k2, k3, Along(world_x, world_y, r));
    hn::Store(k, d, out.levels[0].bend.data() + i);
    hn::Store(hn::Mul(k1, Set(1.0 / 6)), d, out.levels[0].c3.data() + i);
    hn::Store(hn::Mul(k2, Set(1.0 / 24)), d, out.levels[0].c4.data() + i);
    hn::Store(error, d, out.levels[0].error.data() + i);
    auto ok = hn::And(hn::Le(hn::Abs(slip), Set(1e-9 + 1e-15 * (f.a + f.b))),
                      hn::Lt(hn::Abs(side), Set(f.reach)));
    if (!(2.0 * r <= f.reach)) ok = hn::Lt(one, hn::Zero(d));
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
