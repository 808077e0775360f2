// solve_cubics of sdf/distance/distance.h, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/lanes/cubics_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/lanes/cubics-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Coefficients as the kernel wants them: a > 0, neither end 0, no size whose powers leave the range of doubles.
/// All other lanes are made x³ + 1, and their `fits` is 0.
template <class D, class W>
HWY_INLINE CubicPack<W> Fitting(D d, CubicPack<W> f, W& fits) {
  const W zero = SetPack(d, 0), one = SetPack(d, 1), sign = CopySign(one, f.a);
  const W least = Min(Abs(f.a), Abs(f.d));
  const W most = Max(Max(Abs(f.a), Abs(f.b)), Max(Abs(f.c), Abs(f.d)));
  // Written so that a NaN coefficient never fits.
  const auto number =
      Lt(Add(Add(Abs(f.a), Abs(f.b)), Add(Abs(f.c), Abs(f.d))), SetPack(d, 0x1p102));
  const auto sound =
      And(number, And(Gt(least, SetPack(d, 0x1p-100)), Lt(most, SetPack(d, 0x1p100))));
  fits = IfThenElse(sound, one, zero);
  return {IfThenElse(sound, Mul(f.a, sign), one), IfThenElse(sound, Mul(f.b, sign), zero),
          IfThenElse(sound, Mul(f.c, sign), zero), IfThenElse(sound, Mul(f.d, sign), one)};
}

void SolveCubics(const double* a, const double* b, const double* c, const double* e, size_t count,
                 Roots* out) {
  const hn::ScalableTag<double> d;
  using W = Pack<hn::Vec<decltype(d)>>;
  constexpr size_t kMost = kParts * hn::MaxLanes(decltype(d)());
  const size_t step = kParts * hn::Lanes(d);
  HWY_ALIGN double rest[4][kMost], found[5][kMost];
  for (size_t i = 0; i < count; i += step) {
    const size_t here = std::min(step, count - i);
    const double* from[4] = {a + i, b + i, c + i, e + i};
    if (HWY_UNLIKELY(here < step)) {
      for (size_t n = 0; n < 4; ++n) {
        for (size_t k = 0; k < step; ++k) rest[n][k] = from[n][std::min(k, here - 1)];
        from[n] = rest[n];
      }
    }
    W fits = SetPack(d, 0);
    const auto f = Fitting<decltype(d), W>(
        d, {LoadPack(d, from[0]), LoadPack(d, from[1]), LoadPack(d, from[2]), LoadPack(d, from[3])},
        fits);
    const auto r = RootsOf(d, f);
    StorePack(r.low, d, found[0]), StorePack(r.middle, d, found[1]), StorePack(r.high, d, found[2]);
    StorePack(r.is_three, d, found[3]), StorePack(Mul(r.sure, fits), d, found[4]);
    for (size_t k = 0; k < here; ++k) {
      if (!(found[4][k] > 0)) {
        out[i + k] = solve_cubic(from[0][k], from[1][k], from[2][k], from[3][k]);
      } else if (found[3][k] > 0) {
        out[i + k] = {3, {found[0][k], found[1][k], found[2][k]}};
      } else {
        out[i + k] = {1, {found[2][k], 0, 0}};
      }
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/lanes/one_by_one.h"
#include "sdf/distance/spans.h"

namespace mien {
namespace batch {
HWY_EXPORT(SolveCubics);
}  // namespace batch

void solve_cubics(std::span<const double> a, std::span<const double> b, std::span<const double> c,
                  std::span<const double> d, std::span<Roots> out) {
  batch::fit_spans(a, b, out);
  batch::fit_spans(c, d, out);
  MIEN_DISPATCH(SolveCubics)
  (a.data(), b.data(), c.data(), d.data(), out.size(), out.data());
}

}  // namespace mien
#endif
