// Compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shade/ramp/rows_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "render/shade/ramp/rows.h"
#include "sdf/distance/lanes/dispatch-inl.h"
#include "sdf/distance/lanes/fma-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr size_t kPlaces = RampRows::kMost + 16;

/// Of every place its piece and where it is in that.
struct FoundPlaces {
  unsigned piece[kPlaces];
  double u[kPlaces];
};

/// No fused steps of doubles: the same bits on every machine. NaN is taken for 0.
HWY_INLINE void FindPieces(const PieceIndex& index, const RampRowPlaces& at, FoundPlaces& to) {
  const hn::CappedTag<double, 8> d;
  HWY_ALIGN double s[kPlaces], bucket[kPlaces];
  const size_t count = at.step == 0.0 ? 1 : size_t(at.count) + 1;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto v = hn::Add(hn::Set(d, at.first),
                     hn::Mul(hn::Set(d, at.step), hn::Iota(d, double(at.from + int(i)))));
    if (index.period() > 0.0) {
      const auto turns = hn::Floor(hn::Mul(v, hn::Set(d, index.per_period())));
      v = hn::Sub(v, hn::Mul(hn::Set(d, index.period()), turns));
    }
    hn::Store(v, d, s + i);
    const auto b = hn::Min(hn::Max(hn::Mul(v, hn::Set(d, index.per_bucket())), hn::Zero(d)),
                           hn::Set(d, index.most()));
    hn::Store(b, d, bucket + i);
  }
  const PieceIndex::Bucket* const buckets = index.buckets();
  bool missed = false;
  for (size_t i = 0; i < count; ++i) {
    const PieceIndex::Bucket& b = buckets[int(bucket[i])];
    const double at_s = s[i];
    const bool one = at_s >= b.begin[1], two = at_s >= b.begin[2];
    missed |= at_s >= b.begin[3];
    to.piece[i] = unsigned(b.piece) + unsigned(one) + unsigned(two);
    to.u[i] = at_s - b.begin[unsigned(one) + unsigned(two)];
  }
  for (size_t i = 0; missed && i < count; ++i)
    to.u[i] = s[i], to.piece[i] = unsigned(index.find(to.u[i]));
}

/// Four channels side by side.
HWY_INLINE void MeansOfRow(const RampRows::Piece* pieces, const FoundPlaces& found,
                           const RampRowPlaces& at, float* means) {
  const hn::CappedTag<double, 4> d;
  const hn::Rebind<float, decltype(d)> singles;
  for (size_t k = 0; k < 4; k += hn::Lanes(d)) {
    const auto mean = hn::LoadU(d, &at.mean[int(k)]), per_step = hn::Set(d, at.per_step);
    const auto value = [&](int i) HWY_ATTR {
      const double* c = &pieces[found.piece[i]].c[0][int(k)];
      const auto u = hn::Set(d, found.u[i]);
      const auto next = [&](auto high, int n)
                            HWY_ATTR { return hn::Add(hn::LoadU(d, c + 4 * n), hn::Mul(u, high)); };
      return next(next(next(hn::LoadU(d, c + 12), 2), 1), 0);
    };
    const auto put = [&](int i, auto own) HWY_ATTR {
      hn::StoreU(hn::DemoteTo(singles, hn::Add(mean, own)), singles, means + 4 * size_t(i) + k);
    };
    if (at.level) {
      const auto same = value(0);
      for (int i = 0; i < at.count; ++i) put(i, at.step == 0.0 ? same : value(i));
      continue;
    }
    auto left = value(0);
    for (int i = 0; i < at.count; ++i) {
      const auto right = value(i + 1);
      put(i, hn::Mul(per_step, hn::Sub(right, left)));
      left = right;
    }
  }
}

void RowMeans(const PieceIndex& index, const RampRows::Piece* pieces, const RampRowPlaces& at,
              ColorRow& to) {
  const hn::CappedTag<float, 16> d;
  FoundPlaces found;
  HWY_ALIGN float means[4 * kPlaces];
  FindPieces(index, at, found);
  MeansOfRow(pieces, found, at, means);
  for (size_t i = 0; i < size_t(at.count); i += hn::Lanes(d)) {
    hn::Vec<decltype(d)> r, g, b, a;
    hn::LoadInterleaved4(d, means + 4 * i, r, g, b, a);
    const auto put = [&](float* plane, auto v) HWY_ATTR { hn::StoreU(v, d, plane + i); };
    put(to.r.data(), r), put(to.g.data(), g), put(to.b.data(), b), put(to.a.data(), a);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mien {
namespace batch {
HWY_EXPORT(RowMeans);
}  // namespace batch

void means_of_ramp_row(const PieceIndex& index, const RampRows::Piece* pieces,
                       const RampRowPlaces& at, ColorRow& to) {
  MIEN_DISPATCH(RowMeans)(index, pieces, at, to);
}

}  // namespace mien
#endif
