// Vectors of doubles with the signs of arithmetic. Nothing is fused: every machine gives the same bits. Included once
// per instruction set.
#if defined(MIEN_SDF_DISTANCE_REALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_SDF_DISTANCE_REALS_INL_H_
#undef MIEN_SDF_DISTANCE_REALS_INL_H_
#else
#define MIEN_SDF_DISTANCE_REALS_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::ScalableTag<double>;
using Truths = hn::Mask<Doubles>;

struct Reals {
  hn::Vec<Doubles> v;
};

HWY_INLINE Reals All(double x) {
  return {hn::Set(Doubles(), x)};
}
HWY_INLINE Reals operator+(Reals a, Reals b) {
  return {hn::Add(a.v, b.v)};
}
HWY_INLINE Reals operator-(Reals a, Reals b) {
  return {hn::Sub(a.v, b.v)};
}
HWY_INLINE Reals operator*(Reals a, Reals b) {
  return {hn::Mul(a.v, b.v)};
}
HWY_INLINE Reals operator/(Reals a, Reals b) {
  return {hn::Div(a.v, b.v)};
}
HWY_INLINE Reals operator-(Reals a) {
  return {hn::Neg(a.v)};
}
HWY_INLINE Truths operator<(Reals a, Reals b) {
  return hn::Lt(a.v, b.v);
}
HWY_INLINE Truths operator>(Reals a, Reals b) {
  return hn::Gt(a.v, b.v);
}
HWY_INLINE Truths AtMost(Reals a, Reals b) {
  return hn::Le(a.v, b.v);
}
HWY_INLINE Reals Root(Reals a) {
  return {hn::Sqrt(a.v)};
}
HWY_INLINE Reals Size(Reals a) {
  return {hn::Abs(a.v)};
}
HWY_INLINE Reals Least(Reals a, Reals b) {
  return {hn::Min(a.v, b.v)};
}
HWY_INLINE Reals Most(Reals a, Reals b) {
  return {hn::Max(a.v, b.v)};
}
HWY_INLINE Reals Signed(Reals size, Reals sign) {
  return {hn::CopySign(size.v, sign.v)};
}
HWY_INLINE Reals Choose(Truths m, Reals yes, Reals no) {
  return {hn::IfThenElse(m, yes.v, no.v)};
}
HWY_INLINE Truths Either(Truths a, Truths b) {
  return hn::Or(a, b);
}
HWY_INLINE Truths Both(Truths a, Truths b) {
  return hn::And(a, b);
}
HWY_INLINE Truths Without(Truths a, Truths b) {
  return hn::AndNot(b, a);
}
HWY_INLINE Truths AllAre(bool x) {
  return All(x ? 1.0 : 0.0) > All(0.5);
}
HWY_INLINE bool Any(Truths m) {
  return !hn::AllFalse(Doubles(), m);
}
HWY_INLINE Reals LoadReals(const double* from) {
  return {hn::LoadU(Doubles(), from)};
}
HWY_INLINE void StoreReals(Reals a, double* to) {
  hn::StoreU(a.v, Doubles(), to);
}
HWY_INLINE void StoreTruths(Truths m, double* to) {
  StoreReals(Choose(m, All(1.0), All(0.0)), to);
}
HWY_INLINE Truths LoadTruths(const double* from) {
  return LoadReals(from) > All(0.5);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
