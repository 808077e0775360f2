// Between linear light and encoded values, many at a time: the SIMD twin of transfer.h. Included once per
// instruction set.
#if defined(MIEN_RENDER_BLEND_TRANSFER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_BLEND_TRANSFER_INL_H_
#undef MIEN_RENDER_BLEND_TRANSFER_INL_H_
#else
#define MIEN_RENDER_BLEND_TRANSFER_INL_H_
#endif

#include "sdf/distance/lanes/fma-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;
using I = hn::RebindToSigned<F>;

HWY_INLINE VF Const(float x) {
  return hn::Set(F(), x);
}

/// log2 x for normal x > 0: with x = 2^e m, m in [√½, √2), and s = (m − 1)/(m + 1), it is e plus an
/// odd series in s; its first four terms leave 4e-9.
HWY_INLINE VF Log2(VF x) {
  const I i;
  const auto bits = hn::BitCast(i, x);
  const auto e = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(i, 0x3f3504f3)));
  const VF m = hn::BitCast(F(), hn::Sub(bits, hn::ShiftLeft<23>(e)));
  const VF s = hn::Div(hn::Sub(m, Const(1.0f)), hn::Add(m, Const(1.0f))), q = hn::Mul(s, s);
  const VF high = Fused(q, Const(0.431734902f), Const(0.576714441f));
  const VF series = Fused(q, Fused(q, high, Const(0.961798847f)), Const(2.88539008f));
  return Fused(s, series, hn::ConvertTo(F(), e));
}

/// 2^x for x in [−126, 126], within 2e-7 of it.
HWY_INLINE VF Exp2(VF x) {
  const I i;
  const VF whole = hn::Round(x), u = hn::Sub(x, whole);
  VF p = Fused(u, Const(0.00134004322f), Const(0.0096760371f));
  p = Fused(u, p, Const(0.0555032721f)), p = Fused(u, p, Const(0.240221074f));
  p = Fused(u, p, Const(0.693147207f)), p = Fused(u, p, Const(1.0f));
  const auto power = hn::ShiftLeft<23>(hn::ConvertTo(i, whole));
  return hn::BitCast(F(), hn::Add(hn::BitCast(i, p), power));
}

/// Linear light in [0, 1] to encoded values (IEC 61966-2-1). The power 1/2.4 is u^(5/3) of u = v^¼, which is
/// smooth enough over [0.0031308, 1] for a polynomial of degree 7: within 5e-7.
HWY_INLINE VF EncodedLight(VF v) {
  const VF u = hn::Sqrt(hn::Sqrt(hn::Max(v, Const(0.0031308f))));
  VF p = Fused(u, Const(-0.0719658426f), Const(0.376334839f));
  p = Fused(u, p, Const(-0.865389785f)), p = Fused(u, p, Const(1.17733616f));
  p = Fused(u, p, Const(-1.13820809f)), p = Fused(u, p, Const(1.45586885f));
  p = Fused(u, p, Const(0.124537033f)), p = Fused(u, p, Const(-0.0585134138f));
  return hn::IfThenElse(hn::Le(v, Const(0.0031308f)), hn::Mul(v, Const(12.92f)), p);
}

/// Encoded values in [0, 1] to linear light, within 1e-6.
HWY_INLINE VF LightOf(VF v) {
  const VF base = hn::Mul(hn::Add(v, Const(0.055f)), Const(1.0f / 1.055f));
  const VF power = Exp2(hn::Mul(Const(2.4f), Log2(hn::Max(base, Const(0.05f)))));
  return hn::IfThenElse(hn::Le(v, Const(0.04045f)), hn::Mul(v, Const(1.0f / 12.92f)), power);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
