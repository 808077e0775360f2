// Feet on an ellipse at many places at once. Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/nearest/ellipse_feet_simd.cpp"
#include <hwy/foreach_target.h>
#include "render/shade/nearest/foot_form-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void MakeUnit(VF& x, VF& y) {
  const VF length = hn::Sqrt(Fused(x, x, Fused(y, y, Const(1e-12f))));
  const VF over = hn::Div(Const(1.0f), length);
  x = hn::Mul(x, over), y = hn::Mul(y, over);
}

/// The cosine and sine of the angle at which an ellipse's foot lies, of places in the first quadrant of its frame,
/// where the foot is, too. Three times, from the diagonal, the ellipse is replaced by its circle of curvature at the
/// last guess; then two Newton steps on the angle.
HWY_INLINE Direction AngleOfFoot(float a, float b, VF px, VF py) {
  const F f;
  const VF zero = hn::Zero(f), one = Const(1.0f);
  const float ea = (a * a - b * b) / a, eb = (b * b - a * a) / b;
  VF c = Const(0.70710678f), s = c;
  for (int i = 0; i < 3; ++i) {
    const VF ex = hn::Mul(Const(ea), hn::Mul(c, hn::Mul(c, c)));
    const VF ey = hn::Mul(Const(eb), hn::Mul(s, hn::Mul(s, s)));
    const VF rx = hn::Sub(hn::Mul(Const(a), c), ex), ry = hn::Sub(hn::Mul(Const(b), s), ey);
    VF qx = hn::Sub(px, ex), qy = hn::Sub(py, ey);
    MakeUnit(qx, qy);
    const VF r = hn::Sqrt(Fused(rx, rx, hn::Mul(ry, ry)));
    c = hn::Min(hn::Max(hn::Mul(Fused(qx, r, ex), Const(1.0f / a)), zero), one);
    s = hn::Min(hn::Max(hn::Mul(Fused(qy, r, ey), Const(1.0f / b)), zero), one);
    MakeUnit(c, s);
  }
  for (int i = 0; i < 2; ++i) {
    const VF fx = hn::Sub(hn::Mul(Const(a), c), px), fy = hn::Sub(hn::Mul(Const(b), s), py);
    const VF tx = hn::Neg(hn::Mul(Const(a), s)), ty = hn::Mul(Const(b), c);
    const VF speed2 = Fused(tx, tx, hn::Mul(ty, ty));
    const VF lean = Fused(fx, hn::Mul(Const(a), c), hn::Mul(fy, hn::Mul(Const(b), s)));
    const VF rise = hn::Max(hn::Sub(speed2, lean), hn::Mul(speed2, Const(0.05f)));
    const VF turn = hn::Neg(hn::Div(Fused(fx, tx, hn::Mul(fy, ty)), hn::Max(rise, Const(1e-12f))));
    const VF held = hn::Min(hn::Max(turn, Const(-0.3f)), Const(0.3f)), was = c;
    c = hn::Max(FusedFrom(s, held, c), zero), s = hn::Max(Fused(was, held, s), zero);
    MakeUnit(c, s);
  }
  return {c, s};
}

/// Feet on an ellipse, of places folded into one quadrant of its frame.
HWY_INLINE FootForm EllipseForm(const NearEllipse& e, VF x, VF y) {
  const VF ox = hn::Sub(x, Const(e.x)), oy = hn::Sub(y, Const(e.y));
  const VF u = Fused(ox, Const(e.ux), hn::Mul(oy, Const(e.uy)));
  const VF v = Fused(oy, Const(e.ux), hn::Neg(hn::Mul(ox, Const(e.uy))));
  const VF px = hn::Abs(u), py = hn::Abs(v);
  const float a = e.a, b = e.b;
  const auto [c, s] = AngleOfFoot(a, b, px, py);
  VF nx = hn::Mul(Const(b), c), ny = hn::Mul(Const(a), s);
  const VF speed2 = Fused(nx, nx, hn::Mul(ny, ny));
  MakeUnit(nx, ny);
  const VF fx = hn::Mul(Const(a), c), fy = hn::Mul(Const(b), s);
  const VF d = Fused(hn::Sub(px, fx), nx, hn::Mul(hn::Sub(py, fy), ny));
  const VF in = Fused(nx, fx, hn::Mul(ny, fy));
  const VF turn = hn::Max(Fused(d, in, speed2), hn::Mul(speed2, Const(0.01f)));
  const VF bend = hn::Min(hn::Div(in, turn), Const(4.0f));
  nx = hn::CopySign(nx, u), ny = hn::CopySign(ny, v);
  return {d, FusedFrom(ny, Const(e.uy), hn::Mul(nx, Const(e.ux))),
          Fused(ny, Const(e.ux), hn::Mul(nx, Const(e.uy))), bend};
}

void EllipseFeet(const NearEllipse& ellipse, std::span<const float> x, std::span<const float> y,
                 const Feet& out) {
  const F f;
  for (size_t k = 0; k < x.size(); k += hn::Lanes(f))
    StoreForm(EllipseForm(ellipse, hn::LoadU(f, x.data() + k), hn::LoadU(f, y.data() + k)), out, k);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(EllipseFeet);
}  // namespace batch

void ellipse_feet(const NearEllipse& ellipse, std::span<const float> x, std::span<const float> y,
                  const Feet& out) {
  MIEN_DISPATCH(EllipseFeet)(ellipse, x, y, out);
}

}  // namespace mien
#endif
