// How far an outline leaves the form that leaves are told (leaf_edge.h), and its fifth order folded into
// the third. Derivation: docs/derivations/leaf_edges.md. Included once per instruction set.
#if defined(MIEN_SDF_EDGE_LEAF_REMAINDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_EDGE_LEAF_REMAINDER_INL_H_
#undef MIEN_SDF_EDGE_LEAF_REMAINDER_INL_H_
#else
#define MIEN_SDF_EDGE_LEAF_REMAINDER_INL_H_
#endif

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

/// A curve's curvature at the foot, how it changes per arc, three times, and a bound on the fourth
/// change over the leaf.
struct Bends {
  V k, k1, k2, k3, most_k4;
};

/// The part of a curve that can lie in the leaf: |X| <= along; arc <= stretch·along as long as it turns by
/// at most `turn`, cos(turn) stretch >= 1.
struct Extent {
  V along, stretch, turn;
};

/// A square's points lie from its centre by at most its half side times |n.x| + |n.y| along the tangent: 0.71
/// to 1 of the radius. Arcs that turn by 0.4, or by 0.7 where the curve bends more.
HWY_INLINE Extent ExtentOf(V nx, V ny, double radius, V k, V k1) {
  constexpr double kHalfSide = 0.70710678118654757;
  const V along = hn::Mul(hn::Add(hn::Abs(nx), hn::Abs(ny)), Set(kHalfSide * radius));
  const V turns = hn::Mul(along, Fused(hn::Mul(along, Set(0.5)), hn::Abs(k1), hn::Abs(k)));
  const auto gentle = hn::Lt(turns, Set(0.33));
  return {along, hn::IfThenElse(gentle, Set(1.09), Set(1.31)),
          hn::IfThenElse(gentle, Set(0.4), Set(0.7))};
}

/// x⁵ on |x| <= 1 is kFold x³ to within kFolded: the least there is.
constexpr double kFold = 0.869, kFolded = 0.1312;

struct Third {
  V c3, error;
};

/// c3 with the fifth order folded in, and how far the outline leaves the form.
HWY_INLINE Third FoldedThird(const Bends& c, const Extent& extent) {
  const V x = extent.along, x2 = hn::Mul(x, x), x3 = hn::Mul(x2, x), x6 = hn::Mul(x3, x3);
  const V k = hn::Abs(c.k), k1 = hn::Abs(c.k1), k2 = hn::Abs(c.k2), k3 = hn::Abs(c.k3);
  const V kk = hn::Mul(k, k), turn2 = hn::Mul(kk, x2), k1k1 = hn::Mul(k1, k1);
  const V c5 = hn::Mul(FusedFrom(kk, c.k1, c.k3), Set(1.0 / 120));

  // The arc's turn: the bound holds only as far as `extent` says.
  const V s = hn::Mul(extent.stretch, x);
  V turned = Fused(c.most_k4, hn::Mul(s, Set(1.0 / 120)), hn::Mul(k3, Set(1.0 / 24)));
  turned = Fused(turned, s, hn::Mul(k2, Set(1.0 / 6)));
  turned = Fused(Fused(turned, s, hn::Mul(k1, Set(0.5))), s, k);
  turned = hn::Mul(turned, s);

  const V fifth =
      hn::Mul(hn::Mul(hn::Abs(c5), hn::Mul(x2, x3)), Fused(turn2, Set(0.5 * kFold), Set(kFolded)));
  const V sixth =
      hn::Mul(Fused(hn::Mul(Set(4.0), kk), k2, Fused(hn::Mul(Set(48.0), k), k1k1, c.most_k4)),
              Set(1.0 / 720));
  const V seventh =
      Fused(kk, Fused(Set(0.0068), k3, hn::Mul(Set(0.0447), hn::Mul(kk, k1))),
            hn::Mul(k1, Fused(Set(0.0395), hn::Mul(k, k2), hn::Mul(Set(0.0096), k1k1))));
  const V sum = Fused(x6, Fused(seventh, x, sixth), fifth);
  // A quarter more for what comes after: (turned)² of the above.
  const V error =
      hn::IfThenElse(hn::Le(turned, extent.turn), hn::Mul(sum, Set(1.25)), Set(kUnproven));
  return {Fused(hn::Mul(Set(kFold), x2), c5, hn::Mul(c.k1, Set(1.0 / 6))), error};
}

/// At `level` along the normal of a curve whose feet lie within arc `reach` of the centre's: nothing is proven where
/// the arc per arc of the curve, 1 − level·k, changes by a tenth.
struct AtLevel {
  Bends bends;
  hn::Mask<D> steady;
};
HWY_INLINE AtLevel BendsAt(const Bends& c, V level, V reach) {
  const V one = Set(1.0), m = FusedFrom(level, c.k, one);
  const V i = hn::Div(one, hn::Max(m, Set(0.05))), i2 = hn::Mul(i, i), i3 = hn::Mul(i2, i);
  const V i5 = hn::Mul(i3, i2), lk = hn::Mul(level, c.k1), lkk = hn::Mul(lk, c.k1);
  Bends at;
  at.k = hn::Mul(c.k, i);
  at.k1 = hn::Mul(c.k1, i3);
  at.k2 = hn::Mul(i5, Fused(c.k2, m, hn::Mul(Set(3.0), lkk)));
  at.k3 = hn::Mul(hn::Mul(i5, i2), Fused(hn::Mul(c.k3, m), m,
                                         Fused(hn::Mul(Set(10.0), lk), hn::Mul(c.k2, m),
                                               hn::Mul(Set(15.0), hn::Mul(lk, lkk)))));
  // The most of everything within reach.
  const V r = reach, half = hn::Mul(r, Set(0.5)), third = hn::Mul(r, Set(1.0 / 3));
  const V l = hn::Abs(level), k4 = c.most_k4;
  const V a3 = Fused(k4, r, hn::Abs(c.k3));
  const V a2 = Fused(Fused(k4, half, hn::Abs(c.k3)), r, hn::Abs(c.k2));
  const V a1 = Fused(Fused(Fused(k4, third, hn::Abs(c.k3)), half, hn::Abs(c.k2)), r, hn::Abs(c.k1));
  const V change = hn::Mul(l, hn::Mul(a1, r));
  const V most = hn::Add(m, change), j = hn::Mul(i, Set(1.1)), j2 = hn::Mul(j, j);
  const V j4 = hn::Mul(j2, j2), la1 = hn::Mul(l, a1), most2 = hn::Mul(most, most);
  V sum = hn::Mul(Set(105.0), hn::Mul(hn::Mul(la1, la1), Fused(la1, a1, hn::Mul(a2, most))));
  sum = Fused(hn::Mul(Set(10.0), l), hn::Mul(hn::Mul(a2, a2), most2), sum);
  sum = Fused(hn::Mul(Set(15.0), la1), hn::Mul(a3, most2), sum);
  at.most_k4 = hn::Mul(hn::Mul(hn::Mul(j4, j4), j), Fused(hn::Mul(k4, most2), most, sum));
  return {at, hn::Le(hn::Mul(change, Set(11.0)), m)};
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
