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

using F = hn::CappedTag<float, 16>;
using V = hn::Vec<F>;

/// One branch, as lanes.
struct Branch {
  V d, nx, ny;
};
HWY_INLINE Branch Either(hn::Mask<F> second, const BranchPair::Values& a,
                         const BranchPair::Values& b, int k) {
  const F f;
  const auto won = [&](const float* of_a, const float* of_b) HWY_ATTR {
    return hn::IfThenElse(second, hn::Load(f, of_b + k), hn::Load(f, of_a + k));
  };
  return {won(a.d, b.d), won(a.nx, b.nx), won(a.ny, b.ny)};
}

/// Where another branch takes over from one, of a least distance or, with sign −1, of a greatest.
struct Ridge {
  V off, ex, ey;
};
HWY_INLINE Ridge RidgeBetween(const Branch& from, const Branch& to, float sign) {
  // [of |n − n'|²] Gradients as alike as that are one branch's.
  constexpr float kAlike = 4e-4f;
  const F f;
  const V by = hn::Set(f, sign), alike = hn::Set(f, kAlike);
  const V dx = hn::Mul(by, hn::Sub(from.nx, to.nx)), dy = hn::Mul(by, hn::Sub(from.ny, to.ny));
  const V square = hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
  const V length = hn::Sqrt(hn::Max(square, alike)), over = hn::Div(hn::Set(f, 1.0f), length);
  const V off = hn::Div(hn::Mul(by, hn::Sub(to.d, from.d)), length);
  return {hn::IfThenElse(hn::Gt(square, alike), off, hn::Set(f, BranchPair::kFar)),
          hn::Mul(dx, over), hn::Mul(dy, over)};
}

/// The lesser of two distances, or with sign −1 the greater: the other one may take over on a ridge of its own, by the
/// branch that is its own here or, past its ridge, by the one beyond.
void TakeLeast(const BranchPair& a, const BranchPair& b, float sign, BranchPair& to) {
  const F f;
  for (int k = 0; k < BranchPair::kPlaces; k += int(hn::Lanes(f))) {
    const auto load = [&](const float* v) HWY_ATTR { return hn::Load(f, v + k); };
    const V by = hn::Set(f, sign);
    const auto second = hn::Lt(hn::Mul(by, load(b.best.d)), hn::Mul(by, load(a.best.d)));
    const auto won = [&](const float* of_a, const float* of_b)
                         HWY_ATTR { return hn::IfThenElse(second, load(of_b), load(of_a)); };
    const Branch best = Either(second, a.best, b.best, k);
    Branch other = Either(second, b.best, a.best, k),
           beyond = Either(second, a.beyond, b.beyond, k);
    Ridge ridge = RidgeBetween(best, other, sign);
    Ridge own{won(a.off, b.off), won(a.ex, b.ex), won(a.ey, b.ey)};
    const auto take = [&](auto where, V from, V& v)
                          HWY_ATTR { v = hn::IfThenElse(where, from, v); };
    // A ridge past the other's own one is farther than that.
    const V turns = won(b.off, a.off);
    if (!hn::AllFalse(f, hn::Lt(turns, hn::Min(ridge.off, own.off)))) {
      const Branch past = Either(second, b.beyond, a.beyond, k);
      const Ridge to_past = RidgeBetween(best, past, sign);
      const V along =
          hn::Add(hn::Mul(to_past.ex, won(b.ex, a.ex)), hn::Mul(to_past.ey, won(b.ey, a.ey)));
      const auto is_past =
          hn::And(hn::And(hn::Ge(to_past.off, hn::Zero(f)), hn::Lt(to_past.off, ridge.off)),
                  hn::Ge(hn::Mul(to_past.off, along), turns));
      take(is_past, past.d, other.d), take(is_past, past.nx, other.nx);
      take(is_past, past.ny, other.ny), take(is_past, to_past.off, ridge.off);
      take(is_past, to_past.ex, ridge.ex), take(is_past, to_past.ey, ridge.ey);
    }
    const auto crosses = hn::Lt(ridge.off, own.off);
    take(crosses, other.d, beyond.d), take(crosses, other.nx, beyond.nx);
    take(crosses, other.ny, beyond.ny), take(crosses, ridge.off, own.off);
    take(crosses, ridge.ex, own.ex), take(crosses, ridge.ey, own.ey);
    const auto put = [&](V v, float* at) HWY_ATTR { hn::Store(v, f, at + k); };
    put(best.d, to.best.d), put(best.nx, to.best.nx), put(best.ny, to.best.ny);
    put(beyond.d, to.beyond.d), put(beyond.nx, to.beyond.nx), put(beyond.ny, to.beyond.ny);
    put(own.off, to.off), put(own.ex, to.ex), put(own.ey, to.ey);
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
