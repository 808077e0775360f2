// Ridges of a distance, where two feet are equally near, found from the branches at places around. Included once
// per instruction set.
#if defined(MIEN_RENDER_SHADE_RIDGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_RIDGE_INL_H_
#undef MIEN_RENDER_SHADE_RIDGE_INL_H_
#else
#define MIEN_RENDER_SHADE_RIDGE_INL_H_
#endif

#include "render/shade/light/lamp_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

struct Spot {
  VF d, nx, ny;
};

/// A branch of the distance seen from (x, y) away, to second order in that: level lines as parabolas. Off by
/// |bend|² |(x, y)|³ / 2.
HWY_INLINE Spot SeenFrom(VF d, VF nx, VF ny, VF bend, VF x, VF y) {
  const VF out = Fused(nx, x, hn::Mul(ny, y)), aside = FusedFrom(ny, x, hn::Mul(nx, y));
  const VF turn = hn::Mul(hn::Mul(bend, aside), FusedFrom(bend, out, Const(1.0f)));
  const VF half = hn::Mul(Const(0.5f), turn), back = FusedFrom(half, turn, Const(1.0f));
  return {hn::Add(d, Fused(half, aside, out)), FusedFrom(turn, ny, hn::Mul(nx, back)),
          Fused(turn, nx, hn::Mul(ny, back))};
}

struct Ridge {
  VF offset;    ///< from the cell's centroid, 1e9 if there is none
  VF ex, ey;    ///< towards it, unit
  VF next;      ///< the offset of another one
  Spot beyond;  ///< the branch there, as it would be at the centroid
};

HWY_INLINE Ridge NoRidge() {
  const VF zero = hn::Zero(F()), far = Const(1e9f);
  return {far, zero, zero, far, {zero, zero, zero}};
}

/// Gradients nearer to each other than `same` are one branch.
HWY_INLINE void Consider(const Spot& here, const Spot& other, float same, Ridge& ridge) {
  const VF mx = hn::Sub(other.nx, here.nx), my = hn::Sub(other.ny, here.ny);
  const VF m2 = Fused(mx, mx, hn::Mul(my, my));
  const auto another = hn::Gt(m2, Const(same * same));
  if (hn::AllFalse(F(), another)) return;
  const VF by = hn::Div(Const(1.0f), hn::Sqrt(hn::Max(m2, Const(1e-20f))));
  const VF apart = hn::Sub(other.d, here.d);
  const VF offset = hn::Mul(hn::Abs(apart), by);
  const auto nearer = hn::And(another, hn::Lt(offset, ridge.offset));
  // The one passed over is another ridge if it has another gradient beyond.
  const VF qx = hn::Sub(other.nx, ridge.beyond.nx), qy = hn::Sub(other.ny, ridge.beyond.ny);
  const auto differs = hn::And(another, hn::Gt(Fused(qx, qx, hn::Mul(qy, qy)), Const(0.01f)));
  const VF passed = hn::Max(offset, ridge.offset);
  ridge.next = hn::IfThenElse(differs, hn::Min(ridge.next, passed), ridge.next);
  const VF way = hn::CopySign(by, hn::Neg(apart));
  ridge.offset = hn::IfThenElse(nearer, offset, ridge.offset);
  ridge.ex = hn::IfThenElse(nearer, hn::Mul(mx, way), ridge.ex);
  ridge.ey = hn::IfThenElse(nearer, hn::Mul(my, way), ridge.ey);
  ridge.beyond.d = hn::IfThenElse(nearer, other.d, ridge.beyond.d);
  ridge.beyond.nx = hn::IfThenElse(nearer, other.nx, ridge.beyond.nx);
  ridge.beyond.ny = hn::IfThenElse(nearer, other.ny, ridge.beyond.ny);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
