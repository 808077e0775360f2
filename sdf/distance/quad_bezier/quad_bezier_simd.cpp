// The batch functions of sdf/distance/distance.h for quadratic Béziers, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/quad_bezier/quad_bezier_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/distance.h>
#include "sdf/distance/lanes/blocks-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/quad_bezier/quad_bezier-inl.h"
#include "sdf/distance/quad_bezier/quad_bezier_accurate-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// |B − p|² of the nearest of all places where a far point's nearest point may be: the one that was found, both
/// ends, and the other outer root, which is the mirrored one for equal distances. The less careful square cannot
/// decide between them: it may be wrong by more than an ulp.
template <class D, class W>
HWY_INLINE W CarefulSquare(D d, const QuadBezierFrame<float>& f, W px, W py, Offset<W> o, W t) {
  const W mirrored = ClampToUnit(d, Sub(SetPack(d, -2 * f.vertex), t));
  W least = CarefulSquareAt(d, f, px, py, t);
  least = Min(least, CarefulSquareAt(d, f, px, py, SetPack(d, 0)));
  least = Min(least, CarefulSquareAt(d, f, px, py, SetPack(d, 1)));
  return Min(least, CarefulSquareAt(d, f, px, py, Settled(d, f, o, mirrored).t));
}

/// Points at least two sizes away, to any of the curves: everything once more, and with care.
template <class D, class Exact>
HWY_NOINLINE void MendFar(D d, const QuadBezierFrame<float>* frames, size_t frame_count,
                          const float* x, const float* y, float* distance, const Exact& exact) {
  using W = Pack<hn::Vec<D>>;
  constexpr float kMost = std::numeric_limits<float>::max();
  W square = SetPack(d, kMost), careful = square;
  for (size_t k = 0; k < frame_count; ++k) {
    const auto& f = frames[k];
    const W px = LoadPack(d, x), py = LoadPack(d, y);
    const auto o = OffsetTo(d, f, px, py);
    const auto near = NearestOn(d, f, o);
    square = Min(square, near.square);
    careful = Min(careful, CarefulSquare(d, f, px, py, o, near.t));
  }
  HWY_ALIGN float lanes[2][kParts * hn::MaxLanes(D())];
  StorePack(square, d, lanes[0]);
  StorePack(Mul(Sqrt(careful), SetPack(d, frames[0].unscale)), d, lanes[1]);
  Mend(x, y, lanes[0], lanes[1], kParts * hn::Lanes(d), kFar<float>, distance, exact);
}

void DistancesFast(const QuadBezier& curve, int exponent, const float* x, const float* y,
                   size_t count, float* out) {
  const hn::ScalableTag<float> d;
  const auto frame = quad_bezier_frame<float>(curve, exponent);
  const auto exact = [&](float px, float py) { return distance(curve, {px, py}); };
  const auto far = [&](const float* at_x, const float* at_y, float* distance) {
    MendFar(d, &frame, 1, at_x, at_y, distance, exact);
  };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto near = NearestOn(d, f, OffsetTo(d, f, LoadPack(d, at_x), LoadPack(d, at_y)));
    const auto distance = Mul(Sqrt(near.square), SetPack(d, f.unscale));
    return CloseOrFar(d, at_x, at_y, near.square, distance, far);
  });
}

void DistancesDouble(const QuadBezier& curve, int exponent, const double* x, const double* y,
                     size_t count, double* out) {
  const hn::ScalableTag<double> d;
  const auto frame = quad_bezier_frame<double>(curve, exponent);
  const auto exact = [&](double px, double py) { return distance(curve, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const double* at_x, const double* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto near = NearestOn(d, f, OffsetTo(d, f, LoadPack(d, at_x), LoadPack(d, at_y)));
    return DistanceOf(d, at_x, at_y, near.square, f.unscale, exact);
  });
}

void DistancesAccurate(const QuadBezier& curve, int exponent, const float* x, const float* y,
                       size_t count, float* out) {
  const hn::ScalableTag<float> d;
  using W = Pack<hn::Vec<decltype(d)>>;
  const auto frame = quad_bezier_frame<float>(curve, exponent);
  const auto fine_frame = quad_bezier_frame<double>(curve, exponent);
  const auto exact = [&](float px, float py) { return distance(curve, {px, py}); };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto& f = Reloaded(frame);
    const auto& fine = Reloaded(fine_frame);
    const W px = LoadPack(d, at_x), py = LoadPack(d, at_y);
    const auto near = NearestOn(d, f, OffsetTo(d, f, px, py));
    const auto accurate = [&](auto vx, auto vy, auto t)
                              MIEN_LANES { return AccurateSquare(d, fine, vx, vy, t); };
    W square = Each(accurate, px, py, near.t);
    // The float pass decides what is too far for float, and where it could not tell two candidates
    // apart: NaN sends both to the scalar form.
    const W doubt = MulAdd(near.square, SetPack(d, 1 + 0x1p-18f), SetPack(d, 0x1p-19f));
    const auto sure = And(Lt(near.square, SetPack(d, 0x1p48f)), Lt(doubt, near.rival));
    square = IfThenElse(sure, square, SetPack(d, std::numeric_limits<float>::quiet_NaN()));
    return DistanceOf(d, at_x, at_y, square, f.unscale, exact);
  });
}

void DistancesToNearest(const QuadBezierFrame<float>* frames, size_t frame_count,
                        std::span<const QuadBezier> curves, const float* x, const float* y,
                        size_t count, float* out) {
  const hn::ScalableTag<float> d;
  using W = Pack<hn::Vec<decltype(d)>>;
  const auto exact = [&](float px, float py) { return distance_to_nearest(curves, {px, py}); };
  const auto far = [&](const float* at_x, const float* at_y, float* distance) {
    MendFar(d, frames, frame_count, at_x, at_y, distance, exact);
  };
  ForBlocks(d, x, y, count, out, [&](const float* at_x, const float* at_y) MIEN_LANES {
    const auto square_to = [&](const QuadBezierFrame<float>& f) MIEN_LANES {
      return NearestOn(d, f, OffsetTo(d, f, LoadPack(d, at_x), LoadPack(d, at_y))).square;
    };
    W square = SetPack(d, std::numeric_limits<float>::max());
    for (size_t k = 0; k < frame_count; ++k) square = Min(square, square_to(frames[k]));
    const W distance = Mul(Sqrt(square), SetPack(d, frames[0].unscale));
    return CloseOrFar(d, at_x, at_y, square, distance, far);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/lanes/one_by_one.h"
#include "sdf/distance/spans.h"

#include <algorithm>
#include <vector>

namespace mien {
namespace batch {
HWY_EXPORT(DistancesFast);
HWY_EXPORT(DistancesAccurate);
HWY_EXPORT(DistancesDouble);
HWY_EXPORT(DistancesToNearest);
}  // namespace batch

void distances(const QuadBezier& curve, std::span<const float> x, std::span<const float> y,
               std::span<float> d, Precision precision) {
  const auto kernel = precision == Precision::accurate ? &MIEN_DISPATCH(DistancesAccurate)
                                                       : &MIEN_DISPATCH(DistancesFast);
  batch::distances_by(kernel, batch::scale_exponent(curve), curve, x, y, d);
}

void distances(const QuadBezier& curve, std::span<const double> x, std::span<const double> y,
               std::span<double> d) {
  batch::distances_by(MIEN_DISPATCH(DistancesDouble), batch::scale_exponent(curve), curve, x, y, d);
}

void distances(std::span<const QuadBezier> curves, std::span<const float> x,
               std::span<const float> y, std::span<float> d) {
  batch::fit_spans(x, y, d);
  // One scale for all, that of the largest curve, so that squares can be compared.
  int least = std::numeric_limits<int>::max();
  bool all_framed = !curves.empty();
  for (const QuadBezier& curve : curves) {
    const auto exponent = batch::scale_exponent(curve);
    all_framed = all_framed && exponent;
    least = std::min(least, exponent.value_or(0));
  }
  if (!all_framed) {
    for (size_t i = 0; i < d.size(); ++i) {
      d[i] = float(batch::distance_to_nearest(curves, {x[i], y[i]}));
    }
    return;
  }
  std::vector<batch::QuadBezierFrame<float>> frames;
  frames.reserve(curves.size());
  for (const QuadBezier& curve : curves) {
    frames.push_back(batch::quad_bezier_frame<float>(curve, least));
  }
  MIEN_DISPATCH(DistancesToNearest)
  (frames.data(), frames.size(), curves, x.data(), y.data(), d.size(), d.data());
}

}  // namespace mien
#endif
