// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/sums_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/ramp/sums.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Channels of a mix, side by side in one vector or more.
using RampD = hn::CappedTag<double, 4>;
using RampV = hn::Vec<RampD>;
constexpr size_t kChannels = 4;

/// Colours on their way to planes: as many as the widest vector has floats.
class MixesToPlanes {
 public:
  MixesToPlanes(const RampIntegral& ramp, ColorRow& to, size_t first)
      : ramp_(ramp), to_(to), place_(first) {}

  /// The sum by channel, from `Sum(channel)`, times `by`, and the mean; no ramp leaves its range.
  template <class Sum>
  HWY_INLINE void Add(double by, const Sum& sum) {
    const RampD d;
    const hn::Rebind<float, RampD> f;
    for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
      const RampV v = Fused(hn::Set(d, by), sum(c), hn::LoadU(d, &ramp_.mean()[int(c)]));
      const RampV held = hn::Min(hn::Max(v, hn::LoadU(d, &ramp_.least()[int(c)])),
                                 hn::LoadU(d, &ramp_.most()[int(c)]));
      hn::StoreU(hn::DemoteTo(f, held), f, mixes_ + kChannels * count_ + c);
    }
    if (++count_ == kMost) Flush();
  }
  HWY_INLINE void Flush() {
    const hn::CappedTag<float, kMost> d;
    for (size_t i = 0; i < count_; i += hn::Lanes(d)) {
      hn::Vec<decltype(d)> r, g, b, a;
      hn::LoadInterleaved4(d, mixes_ + kChannels * i, r, g, b, a);
      const size_t k = place_ + i;
      hn::StoreU(r, d, &to_.r[k]), hn::StoreU(g, d, &to_.g[k]);
      hn::StoreU(b, d, &to_.b[k]), hn::StoreU(a, d, &to_.a[k]);
    }
    place_ += count_, count_ = 0;
  }

 private:
  static constexpr size_t kMost = kColorSpare;
  const RampIntegral& ramp_;
  ColorRow& to_;
  size_t place_, count_ = 0;
  float mixes_[kChannels * kMost] = {};
};

/// The pieces of so many places, and where the places are in them.
struct InPieces {
  static constexpr size_t kPlaces = 4;
  const double* c[kPlaces];
  double u[kPlaces];

  /// From vectors of places, the k-th one on.
  template <class Places>
  HWY_INLINE InPieces(const RampIntegral& ramp, const Places& places) {
    const RampD d;
    const hn::Rebind<int32_t, RampD> di;
    const auto set = [&](double v) HWY_ATTR { return hn::Set(d, v); };
    const PieceIndex& index = ramp.index();
    constexpr double kFar = 1e300;
    int32_t buckets[kPlaces];
    for (size_t k = 0; k < kPlaces; k += hn::Lanes(d)) {
      RampV s = hn::Min(hn::Max(places(k), set(-kFar)), set(kFar));
      if (index.period > 0.0)
        s = FusedFrom(set(index.period), hn::Floor(hn::Mul(s, set(index.per_period))), s);
      const RampV last = set(double(index.buckets.size() - 1));
      const RampV bucket = hn::Min(hn::Max(hn::Mul(s, set(index.per_bucket)), hn::Zero(d)), last);
      hn::StoreU(s, d, u + k);
      hn::StoreU(hn::DemoteTo(di, hn::Floor(bucket)), di, buckets + k);
    }
    const double* const begins = index.begins.data();
    for (size_t k = 0; k < kPlaces; ++k) {
      size_t piece = index.buckets[size_t(buckets[k])];
      piece += size_t(u[k] >= begins[piece + 1]);
      piece += size_t(u[k] >= begins[piece + 1]);
      if (index.crowded && u[k] >= begins[piece + 1])
        piece = size_t(std::upper_bound(begins, begins + index.begins.size(), u[k]) - begins) - 1;
      c[k] = &ramp.pieces()[piece].c0[0], u[k] -= begins[piece];
    }
  }
  HWY_INLINE RampV Second(size_t place, size_t channel) const {
    const RampD d;
    const RampV at = hn::Set(d, u[place]);
    const double* const from = c[place] + channel;
    const auto term = [&](size_t k) HWY_ATTR { return hn::LoadU(d, from + kChannels * k); };
    return Fused(Fused(Fused(term(3), at, term(2)), at, term(1)), at, term(0));
  }
  HWY_INLINE RampV Value(size_t place, double on, size_t channel) const {
    const RampD d;
    const RampV two = hn::LoadU(d, c[place] + 2 * kChannels + channel);
    const RampV three = hn::LoadU(d, c[place] + 3 * kChannels + channel);
    return Fused(hn::Set(d, 6.0 * (u[place] + on)), three, hn::Add(two, two));
  }
};

void RampBoxMeans(const RampIntegral& ramp, const RampBoxes& boxes, ColorRow& to, size_t first) {
  const RampD d;
  MixesToPlanes planes(ramp, to, first);
  const RampPlane* p = boxes.planes.data();
  for (const RampBoxes::Group& group : boxes.groups) {
    const RampPlane* const end = boxes.planes.data() + group.end;
    const double share = 1.0 / double(end - p), half = 0.5 * group.width;
    double sums[kChannels] = {};
    for (; p != end; ++p) {
      const double near = narrow(*p), h = half * std::max(std::abs(p->gx), near),
                   v = half * std::max(std::abs(p->gy), near);
      const InPieces at(ramp, [&](size_t k) HWY_ATTR {
        static constexpr double kSides[] = {-1, -1, 1, 1}, kEnds[] = {-1, 1, -1, 1};
        return Fused(hn::LoadU(d, kSides + k), hn::Set(d, h),
                     Fused(hn::LoadU(d, kEnds + k), hn::Set(d, v), hn::Set(d, p->t)));
      });
      // There may be no kink between them.
      const bool straight =
          h + v < ramp.longest() && at.c[0] == at.c[3] && at.u[3] - at.u[0] > h + v;
      const double by = straight ? 1.0 : 0.25 / (h * v);
      for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
        const RampV sum = straight ? at.Value(0, h + v, c)
                                   : hn::Sub(hn::Sub(at.Second(3, c), at.Second(2, c)),
                                             hn::Sub(at.Second(1, c), at.Second(0, c)));
        hn::StoreU(Fused(hn::Set(d, by), sum, hn::LoadU(d, sums + c)), d, sums + c);
      }
    }
    planes.Add(share, [&](size_t c) HWY_ATTR { return hn::LoadU(d, sums + c); });
  }
  planes.Flush();
}

void RampCornerSum(const RampIntegral& ramp, const RampCorner* corners, size_t count, Mix& to) {
  const RampD d;
  for (size_t i = 0; i < count; i += InPieces::kPlaces) {
    const size_t now = std::min(count - i, InPieces::kPlaces);
    double places[InPieces::kPlaces] = {};
    for (size_t k = 0; k < now; ++k) places[k] = corners[i + k].place;
    const InPieces at(ramp, [&](size_t k) HWY_ATTR { return hn::LoadU(d, places + k); });
    for (size_t k = 0; k < now; ++k)
      for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) {
        double* const sum = &to[int(c)];
        const RampV by = hn::Set(d, corners[i + k].weight);
        hn::StoreU(Fused(by, at.Second(k, c), hn::LoadU(d, sum)), d, sum);
      }
  }
}

void RampSeconds(const RampIntegral& ramp, double gx, double from, int x, int until, double* to) {
  const RampD d;
  for (; x < until; x += int(InPieces::kPlaces)) {
    const size_t now = std::min(size_t(until - x), InPieces::kPlaces);
    const InPieces at(ramp, [&](size_t k) HWY_ATTR {
      return Fused(hn::Iota(d, double(x + int(k))), hn::Set(d, gx), hn::Set(d, from));
    });
    for (size_t k = 0; k < now; ++k, to += kChannels)
      for (size_t c = 0; c < kChannels; c += hn::Lanes(d)) hn::StoreU(at.Second(k, c), d, to + c);
  }
}

/// From the second integrals at the upper and the lower corners.
void RampRowMeans(const RampIntegral& ramp, const double* up, const double* down, int count,
                  double by, ColorRow& to) {
  const RampD d;
  MixesToPlanes planes(ramp, to, 0);
  const auto side = [&](const double* above, const double* below)
                        HWY_ATTR { return hn::Sub(hn::LoadU(d, below), hn::LoadU(d, above)); };
  for (int i = 0; i < count; ++i, up += kChannels, down += kChannels)
    planes.Add(by, [&](size_t c) HWY_ATTR {
      return hn::Sub(side(up + kChannels + c, down + kChannels + c), side(up + c, down + c));
    });
  planes.Flush();
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(RampBoxMeans);
HWY_EXPORT(RampCornerSum);
HWY_EXPORT(RampSeconds);
HWY_EXPORT(RampRowMeans);
}  // namespace batch

void ramp_means(const RampIntegral& ramp, const RampBoxes& boxes, ColorRow& to, std::size_t first) {
  to.room_for(first + boxes.groups.size());
  MIEN_DISPATCH(RampBoxMeans)(ramp, boxes, to, first);
}

Mix ramp_sum(const RampIntegral& ramp, std::span<const RampCorner> corners) {
  Mix sum{0.0};
  MIEN_DISPATCH(RampCornerSum)(ramp, corners.data(), corners.size(), sum);
  return sum;
}

RampRows::Line* RampRows::known(const RampIntegral& ramp, double gx, double at, int from) {
  for (Line& l : lines_)
    if (l.of == &ramp && l.gx == gx && l.at == at && l.from <= from && from <= l.until) return &l;
  return nullptr;
}

/// Finds what the line lacks up to there; one that is another one from `from` on.
void RampRows::reach(Line& line, const RampIntegral& ramp, double gx, double at, int from,
                     int until) {
  if (line.of == nullptr)
    line.of = &ramp, line.gx = gx, line.at = at, line.from = line.until = from;
  if (until <= line.until) return;
  line.seconds.resize(4 * std::size_t(until - line.from));
  double* const to = &line.seconds[4 * std::size_t(line.until - line.from)];
  MIEN_DISPATCH(RampSeconds)(ramp, gx, at, line.until, until, to);
  line.until = until;
}

void RampRows::means(const RampIntegral& ramp, const RampPlane& plane, int x, int y, int count,
                     ColorRow& to) {
  to.room_for(std::size_t(count));
  const double near = narrow(plane), middle = plane.t + plane.gy * (y + 0.5);
  const bool flat = std::abs(plane.gy) < near;
  const double above = flat ? middle - 0.5 * near : plane.t + plane.gy * y,
               below = flat ? middle + 0.5 * near : plane.t + plane.gy * (y + 1);
  if (std::abs(plane.gx) < near || above == below) {  // level lines run along the row
    const int differ = plane.gx == 0.0 ? 1 : count;
    boxes_.clear();
    for (int i = 0; i < differ; ++i) {
      boxes_.planes.push_back({plane.at(x + i + 0.5, y + 0.5), plane.gx, plane.gy});
      boxes_.close(1.0);
    }
    ramp_means(ramp, boxes_, to, 0);
    for (auto* c : {&to.r, &to.g, &to.b, &to.a})
      std::fill(c->begin() + differ, c->begin() + count, c->front());
    return;
  }
  Line *up = known(ramp, plane.gx, above, x), *down = known(ramp, plane.gx, below, x);
  const auto other = [&](const Line* l) { return &lines_[l == lines_.data() ? 1 : 0]; };
  if (!up) up = other(down), up->of = nullptr;
  if (!down) down = other(up), down->of = nullptr;
  reach(*up, ramp, plane.gx, above, x, x + count + 1);
  reach(*down, ramp, plane.gx, below, x, x + count + 1);
  MIEN_DISPATCH(RampRowMeans)
  (ramp, up->from_column(x), down->from_column(x), count, 1.0 / (plane.gx * (below - above)), to);
}

}  // namespace mien
#endif
