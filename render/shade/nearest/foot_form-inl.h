// A foot as float lanes see it. Included once per instruction set.
#if defined(MIEN_RENDER_SHADE_FOOT_FORM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef MIEN_RENDER_SHADE_FOOT_FORM_INL_H_
#undef MIEN_RENDER_SHADE_FOOT_FORM_INL_H_
#else
#define MIEN_RENDER_SHADE_FOOT_FORM_INL_H_
#endif

#include "render/shade/nearest/near_feet.h"
#include "sdf/distance/lanes/fma-inl.h"

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using VF = hn::Vec<F>;

HWY_INLINE VF Const(float x) {
  return hn::Set(F(), x);
}

/// A direction, of length 1.
struct Direction {
  VF x, y;
};

/// Distances, their gradients and bends, as Feet.
struct FootForm {
  VF d, nx, ny, bend;
};

HWY_INLINE void StoreForm(const FootForm& form, const Feet& out, size_t k) {
  const F f;
  hn::StoreU(form.d, f, out.d + k), hn::StoreU(form.nx, f, out.nx + k);
  hn::StoreU(form.ny, f, out.ny + k), hn::StoreU(form.bend, f, out.bend + k);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();
#endif
