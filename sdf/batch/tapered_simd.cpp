// The float batch of sdf/distance.h for strokes of varying width, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/sdf/batch/tapered_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/sdf/batch/blocks-inl.h>
#include <mien/sdf/batch/tapered-inl.h>
#include <mien/sdf/distance.h>

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Above these the disc is in doubt: improvements and Newton's steps converge quadratically, so what is
/// still missing is about the square of the last one.
inline constexpr float kMuchGain = 0x1p-9f, kLongLastStep = 0x1p-12f;

/// |q|² of the deepest disc, or NaN where it is in doubt.
template <class D, class W>
HWY_INLINE W SquareIfSure(D d, const TaperedFrame& f, Offset<W> o, const DeepestDisc<W>& found) {
  const W square = SquareAt(d, f.spine, o, found.disc.t);
  const auto sure =
      And(Lt(found.gain, SetPack(d, kMuchGain)), Lt(found.step, SetPack(d, kLongLastStep)));
  return IfThenElse(sure, square, SetPack(d, std::numeric_limits<float>::quiet_NaN()));
}

/// Points far away: the disc as before, its depth in double precision. There |q| may have a larger ulp
/// than the distance.
template <class D, class Exact>
HWY_NOINLINE void MendFarFromStroke(D d, const TaperedStroke& stroke, const TaperedFrame& f,
                                    const float* x, const float* y, float* distance,
                                    const Exact& exact) {
  constexpr size_t kMost = kParts * hn::MaxLanes(D());
  const size_t count = kParts * hn::Lanes(d);
  const auto o = OffsetTo(d, f.spine, LoadPack(d, x), LoadPack(d, y));
  const auto found = DeepestOf(d, f, o);
  HWY_ALIGN float square[kMost], t[kMost], careful[kMost];
  StorePack(SquareIfSure(d, f, o, found), d, square);
  StorePack(found.disc.t, d, t);
  for (size_t k = 0; k < count; ++k) careful[k] = float(depth_at(stroke, t[k], {x[k], y[k]}));
  Mend(x, y, square, careful, count, 0x1p36f, distance, exact);
}

void DistancesTapered(const TaperedStroke& stroke, const TaperedFrame& frame, const float* x,
                      const float* y, size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const auto exact = [&](float px, float py) { return distance(stroke, {px, py}); };
  const auto far = [&](const float* at_x, const float* at_y, float* distance) {
    MendFarFromStroke(d, stroke, frame, at_x, at_y, distance, exact);
  };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto o = OffsetTo(d, f.spine, LoadPack(d, at_x), LoadPack(d, at_y));
    const auto found = DeepestOf(d, f, o);
    const auto distance = Mul(found.disc.depth, SetPack(d, f.spine.unscale));
    return CloseOrFar(d, at_x, at_y, SquareIfSure(d, f, o, found), distance, far);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <mien/sdf/batch/one_by_one.h>
#include <mien/sdf/batch/spans.h>

namespace mien {
namespace batch {
HWY_EXPORT(DistancesTapered);
}  // namespace batch

void distances(const TaperedStroke& stroke, std::span<const float> x, std::span<const float> y,
               std::span<float> d) {
  batch::require_spans("distances", batch::span_of(x), batch::span_of(y), batch::span_of(d));
  const auto frame = batch::tapered_frame(stroke);
  if (!frame) return batch::distances_one_by_one(stroke, x, y, d);
  HWY_DYNAMIC_DISPATCH(batch::DistancesTapered)
  (stroke, *frame, x.data(), y.data(), d.size(), d.data());
}

}  // namespace mien
#endif
