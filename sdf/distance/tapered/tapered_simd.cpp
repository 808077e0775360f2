// The float batch of sdf/distance/distance.h for strokes of varying width, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/tapered/tapered_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/tapered/tapered-inl.h"

#include <algorithm>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Above these the disc is in doubt: improvements and Newton's steps converge quadratically, so what is
/// still missing is about the square of the last one.
template <class T>
inline constexpr T kMuchGain = T(sizeof(T) == 4 ? 0x1p-9 : 0x1p-18);
template <class T>
inline constexpr T kLongLastStep = T(sizeof(T) == 4 ? 0x1p-12 : 0x1p-20);

/// |q|² of the deepest disc, or NaN where it is in doubt.
template <class D, class W, class T = hn::TFromD<D>>
HWY_INLINE W SquareIfSure(D d, const TaperedFrame<T>& f, Offset<W> o, const DeepestDisc<W>& found) {
  const W square = SquareAt(d, f.spine, o, found.disc.t);
  const auto settled =
      And(Lt(found.gain, SetPack(d, kMuchGain<T>)), Lt(found.step, SetPack(d, kLongLastStep<T>)));
  const auto sure =
      And(And(settled, Lt(found.missing, SetPack(d, 0))), Gt(found.lead, SetPack(d, 0)));
  return IfThenElse(sure, square, SetPack(d, std::numeric_limits<T>::quiet_NaN()));
}

/// The candidates of a pack's points, as arrays (see Pack).
template <class D>
struct StoredDiscs {
  static constexpr size_t kMost = kParts * hn::MaxLanes(D());
  HWY_ALIGN float square[kMost], t[kMost], one[kMost], two[kMost];
};

/// Lanes in doubt get the scalar form. Far ones get the least depth of the candidates in double precision: there
/// |q| may have a larger ulp than the distance, and the choice between discs is off by as much.
template <class D, class Exact>
HWY_NOINLINE void MendStroke(const TaperedStroke& stroke, const float* x, const float* y,
                             const StoredDiscs<D>& found, size_t count, float* distance,
                             const Exact& exact) {
  constexpr float kFarthest = 0x1p36f;
  for (size_t k = 0; k < count; ++k) {
    if (found.square[k] < kClose) continue;
    const bool is_sure = found.square[k] < kFarthest;
    double least = is_sure ? std::numeric_limits<double>::infinity() : exact(x[k], y[k]);
    if (is_sure) {
      for (const float t : {found.t[k], found.one[k], found.two[k], 0.0f, 1.0f}) {
        least = std::min(least, depth_at(stroke, double(t), {x[k], y[k]}));
      }
    }
    distance[k] = float(least);
  }
}

void DistancesTapered(const TaperedStroke& stroke, const TaperedFrame<float>& frame, const float* x,
                      const float* y, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  using W = Pack<hn::Vec<decltype(d)>>;
  const auto exact = [&](float px, float py) { return distance(stroke, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto o = OffsetTo(d, f.spine, LoadPack(d, at_x), LoadPack(d, at_y));
    const auto found = DeepestOf(d, f, o);
    const auto distance = Mul(found.disc.depth, SetPack(d, f.spine.unscale));
    const W square = SquareIfSure(d, f, o, found);
    if (HWY_LIKELY(AllTrue(d, Lt(square, SetPack(d, kClose))))) return distance;
    StoredDiscs<decltype(d)> stored;
    StorePack(square, d, stored.square), StorePack(found.disc.t, d, stored.t);
    StorePack(found.one, d, stored.one), StorePack(found.two, d, stored.two);
    HWY_ALIGN float lanes[StoredDiscs<decltype(d)>::kMost];
    StorePack(distance, d, lanes);
    MendStroke(stroke, at_x, at_y, stored, kParts * hn::Lanes(d), lanes, exact);
    return LoadPack(d, lanes);
  });
}

void DistancesTaperedDouble(const TaperedStroke& stroke, const TaperedFrame<double>& frame,
                            const double* x, const double* y, size_t count, double* out) {
  const hn::ScalableTag<double> d;
  const auto exact = [&](double px, double py) { return distance(stroke, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const double* at_x, const double* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto o = OffsetTo(d, f.spine, LoadPack(d, at_x), LoadPack(d, at_y));
    const auto found = DeepestOf(d, f, o);
    const auto distance = Mul(found.disc.depth, SetPack(d, f.spine.unscale));
    return Checked(d, at_x, at_y, SquareIfSure(d, f, o, found), kFar<double>, distance, exact);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/lanes/one_by_one.h"

namespace mien {
namespace batch {
HWY_EXPORT(DistancesTapered);
HWY_EXPORT(DistancesTaperedDouble);
}  // namespace batch

void distances(const TaperedStroke& stroke, std::span<const float> x, std::span<const float> y,
               std::span<float> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesTapered), batch::tapered_frame<float>(stroke), stroke,
                      x, y, d);
}

void distances(const TaperedStroke& stroke, std::span<const double> x, std::span<const double> y,
               std::span<double> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesTaperedDouble), batch::tapered_frame<double>(stroke),
                      stroke, x, y, d);
}

}  // namespace mien
#endif
