#include "render/shade/nearest/combine_pairs.h"

#include <cmath>

namespace mien {
namespace {

constexpr int kPlaces = BranchPair::kPlaces;
// [of |n − n'|²] Gradients as alike as that are one branch's.
constexpr float kAlike = 4e-4f;

void negate(BranchPair::Values& v) {
  for (int i = 0; i < kPlaces; ++i) v.d[i] = -v.d[i], v.nx[i] = -v.nx[i], v.ny[i] = -v.ny[i];
}

/// The lesser of two distances, or with sign −1 the greater: the other one may take over on a ridge of its own.
void take_least(const BranchPair& a, const BranchPair& b, float sign, BranchPair& to) {
  for (int i = 0; i < kPlaces; ++i) {
    const bool second = sign * b.best.d[i] < sign * a.best.d[i];
    const BranchPair &won = second ? b : a, &lost = second ? a : b;
    const float d = won.best.d[i], nx = won.best.nx[i], ny = won.best.ny[i];
    const float other = lost.best.d[i], ox = lost.best.nx[i], oy = lost.best.ny[i];
    const float dx = sign * (nx - ox), dy = sign * (ny - oy), square = dx * dx + dy * dy;
    const float length = std::sqrt(square);
    const float off = square > kAlike ? sign * (other - d) / length : BranchPair::kFar;
    const float over = square > kAlike ? 1.0f / length : 0.0f;
    const bool crosses = off < won.off[i];
    const float own_off = won.off[i], own_ex = won.ex[i], own_ey = won.ey[i];
    const float own_d = won.beyond.d[i], own_nx = won.beyond.nx[i], own_ny = won.beyond.ny[i];
    to.best.d[i] = d, to.best.nx[i] = nx, to.best.ny[i] = ny;
    to.off[i] = crosses ? off : own_off;
    to.ex[i] = crosses ? dx * over : own_ex, to.ey[i] = crosses ? dy * over : own_ey;
    to.beyond.d[i] = crosses ? other : own_d;
    to.beyond.nx[i] = crosses ? ox : own_nx, to.beyond.ny[i] = crosses ? oy : own_ny;
  }
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
      return take_least(a, b, 1.0f, to);
    case Op::intersect:
      return take_least(a, b, -1.0f, to);
    case Op::subtract: {
      BranchPair outside = b;
      negate(outside.best), negate(outside.beyond);
      return take_least(a, outside, -1.0f, to);
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
