// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/nearest/combine_pairs_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/nearest/combine_pairs.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The lesser of two distances, or with sign −1 the greater: the other one may take over on a ridge of its own.
void TakeLeast(const BranchPair& a, const BranchPair& b, float sign, BranchPair& to) {
  // [of |n − n'|²] Gradients as alike as that are one branch's.
  constexpr float kAlike = 4e-4f;
  const hn::CappedTag<float, 16> f;
  const auto times_sign = [&](auto v) HWY_ATTR { return hn::Mul(hn::Set(f, sign), v); };
  for (int k = 0; k < BranchPair::kPlaces; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    const auto ad = load(a.best.d), bd = load(b.best.d);
    const auto second = hn::Lt(times_sign(bd), times_sign(ad));
    const auto won = [&](const float* of_a, const float* of_b)
                         HWY_ATTR { return hn::IfThenElse(second, load(of_b), load(of_a)); };
    const auto d = won(a.best.d, b.best.d), other = won(b.best.d, a.best.d);
    const auto nx = won(a.best.nx, b.best.nx), ox = won(b.best.nx, a.best.nx);
    const auto ny = won(a.best.ny, b.best.ny), oy = won(b.best.ny, a.best.ny);
    const auto dx = times_sign(hn::Sub(nx, ox)), dy = times_sign(hn::Sub(ny, oy));
    const auto square = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
    const auto apart = hn::Gt(square, hn::Set(f, kAlike));
    const auto length = hn::Sqrt(hn::Max(square, hn::Set(f, kAlike)));
    const auto off = hn::IfThenElse(apart, hn::Div(times_sign(hn::Sub(other, d)), length),
                                    hn::Set(f, BranchPair::kFar));
    const auto own_off = won(a.off, b.off);
    const auto crosses = hn::Lt(off, own_off);
    const auto put = [&](float* v, auto crossing, const float* of_a, const float* of_b) HWY_ATTR {
      hn::Store(hn::IfThenElse(crosses, crossing, won(of_a, of_b)), f, v + k);
    };
    const auto over = hn::Div(hn::Set(f, 1.0f), length);
    put(to.ex, hn::Mul(dx, over), a.ex, b.ex), put(to.ey, hn::Mul(dy, over), a.ey, b.ey);
    put(to.beyond.d, other, a.beyond.d, b.beyond.d);
    put(to.beyond.nx, ox, a.beyond.nx, b.beyond.nx);
    put(to.beyond.ny, oy, a.beyond.ny, b.beyond.ny);
    hn::Store(hn::IfThenElse(crosses, off, own_off), f, to.off + k);
    hn::Store(d, f, to.best.d + k);
    hn::Store(nx, f, to.best.nx + k), hn::Store(ny, f, to.best.ny + k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(TakeLeast);
}  // namespace batch

namespace {

constexpr int kPlaces = BranchPair::kPlaces;

void negate(BranchPair::Values& v) {
  for (int i = 0; i < kPlaces; ++i) v.d[i] = -v.d[i], v.nx[i] = -v.nx[i], v.ny[i] = -v.ny[i];
}

/// |d| − amount folds at the outline.
void fold(BranchPair& to, float amount) {
  for (int i = 0; i < kPlaces; ++i) {
    const float side = to.best.d[i] < 0.0f ? -1.0f : 1.0f;
    const float d = std::abs(to.best.d[i]), nx = side * to.best.nx[i], ny = side * to.best.ny[i];
    // What lies beyond the ridge has the sign that both have on it.
    const float rises = to.ex[i] * to.best.nx[i] + to.ey[i] * to.best.ny[i];
    const float beyond = to.best.d[i] + to.off[i] * rises < 0.0f ? -1.0f : 1.0f;
    const bool folds = d < to.off[i];
    to.beyond.d[i] = (folds ? -d : beyond * to.beyond.d[i]) - amount;
    to.beyond.nx[i] = folds ? -nx : beyond * to.beyond.nx[i];
    to.beyond.ny[i] = folds ? -ny : beyond * to.beyond.ny[i];
    to.off[i] = folds ? d : to.off[i];
    to.ex[i] = folds ? -nx : to.ex[i], to.ey[i] = folds ? -ny : to.ey[i];
    to.best.d[i] = d - amount, to.best.nx[i] = nx, to.best.ny[i] = ny;
  }
}

}  // namespace

void combine_pairs(Op op, const BranchPair& a, const BranchPair& b, float amount, BranchPair& to) {
  switch (op) {
    case Op::unite:
      return MIEN_DISPATCH(TakeLeast)(a, b, 1.0f, to);
    case Op::intersect:
      return MIEN_DISPATCH(TakeLeast)(a, b, -1.0f, to);
    case Op::subtract: {
      BranchPair outside = b;
      negate(outside.best), negate(outside.beyond);
      return MIEN_DISPATCH(TakeLeast)(a, outside, -1.0f, to);
    }
    case Op::shape:
      to = a;
      return;
    case Op::complement:
      to = a;
      negate(to.best), negate(to.beyond);
      return;
    case Op::offset:
      to = a;
      for (int i = 0; i < kPlaces; ++i) to.best.d[i] -= amount, to.beyond.d[i] -= amount;
      return;
    case Op::shell:
      to = a;
      return fold(to, amount);
  }
}

}  // namespace mien
#endif
