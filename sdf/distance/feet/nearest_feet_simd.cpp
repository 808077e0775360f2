// The batches of sdf/distance/feet/nearest_feet.h, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sdf/distance/feet/nearest_feet_simd.cpp"
#include <hwy/foreach_target.h>
#include "sdf/distance/feet/ellipse_feet-inl.h"
#include "sdf/distance/lanes/dispatch-inl.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {

constexpr size_t kMostPlaces = hn::MaxLanes(Doubles());

/// A vector of feet as rows: distance, piece, t, normal, bend.
struct FootRows {
  HWY_ALIGN double rows[6][kMostPlaces];

  void store(const RankedFeet& feet) {
    StoreReals(feet.key, rows[0]), StoreReals(feet.piece, rows[1]), StoreReals(feet.t, rows[2]);
    const Reals no_sign = All(0.0);  // of a 0
    StoreReals(feet.nx + no_sign, rows[3]), StoreReals(feet.ny + no_sign, rows[4]);
    StoreReals(feet.bend, rows[5]);
  }
  void put(const Foot& foot, size_t k) {
    const double all[6] = {foot.distance, double(foot.piece), foot.t,
                           foot.normal.x, foot.normal.y,      foot.bend};
    for (int i = 0; i < 6; ++i) rows[i][k] = all[i];
  }
  void copy(const FootSpans& to, size_t from, size_t count) const {
    const std::span<double> spans[6] = {to.distance, {}, to.t, to.normal_x, to.normal_y, to.bend};
    for (int i = 0; i < 6; ++i)
      if (!spans[i].empty()) std::copy_n(rows[i], count, spans[i].data() + from);
    if (to.piece.empty()) return;
    for (size_t k = 0; k < count; ++k) to.piece[from + k] = std::int32_t(rows[1][k]);
  }
};

HWY_INLINE RankedFeet NoFeet() {
  const Reals zero = All(0.0);
  return {All(std::numeric_limits<double>::infinity()),
          All(-1e300),
          All(-1.0),
          zero,
          zero,
          zero,
          zero,
          zero};
}

/// Walks over the places: kernel(x, y, best, next) tells the lanes that `exact` has to answer.
template <class Kernel, class Exact>
HWY_INLINE void ForPlaces(std::span<const double> x, std::span<const double> y,
                          const FootSpans& nearest, const FootSpans& next, Kernel kernel,
                          const Exact& exact) {
  const size_t step = hn::Lanes(Doubles());
  HWY_ALIGN double places[2][kMostPlaces], asks[kMostPlaces];
  for (size_t i = 0; i < x.size(); i += step) {
    const size_t here = std::min(step, x.size() - i);
    for (size_t k = 0; k < step; ++k) {
      const size_t from = i + std::min(k, here - 1);
      places[0][k] = x[from], places[1][k] = y[from];
    }
    const Reals px = LoadReals(places[0]), py = LoadReals(places[1]);
    RankedFeet feet[2] = {NoFeet(), NoFeet()};
    const Truths near = Both(Size(px) < All(0x1p200), Size(py) < All(0x1p200));
    Truths ask = Without(AllAre(true), near);
    kernel(px, py, feet[0], feet[1], ask);
    FootRows rows[2];
    rows[0].store(feet[0]), rows[1].store(feet[1]);
    if (HWY_UNLIKELY(Any(ask))) {
      StoreTruths(ask, asks);
      for (size_t k = 0; k < here; ++k) {
        if (!(asks[k] > 0.5)) continue;
        const Feet found = exact(glm::dvec2{places[0][k], places[1][k]});
        rows[0].put(found.nearest, k), rows[1].put(found.next, k);
      }
    }
    rows[0].copy(nearest, i, here), rows[1].copy(next, i, here);
  }
}

void FeetOnPieces(std::span<const FootFrame> frames, std::span<const FootPiece> pieces,
                  std::span<const double> x, std::span<const double> y, const FootSpans& nearest,
                  const FootSpans& next) {
  const auto kernel = [&](Reals px, Reals py, RankedFeet& best, RankedFeet& second,
                          Truths&) HWY_ATTR {
    for (size_t i = 0; i < frames.size(); ++i) {
      const FootFrame& f = frames[i];
      const FootPiece& c = f.piece;
      if (!c.exists || !Any(Without(AllAre(true), IsFarther(f, px, py, second.key)))) continue;
      const Truths falls = c.before < 0 ? AllAre(true) : FallsAtEnd(frames[c.before], px, py);
      const TwoMinima at = Checked(
          c, px, py, falls,
          c.tapers() ? MinimaOf<true>(f, px, py, falls) : MinimaOf<false>(f, px, py, falls));
      for (int k = 0; k < 2; ++k)
        if (Any(at.is_there[k]))
          RankFeet(FeetAt(f, int(i), px, py, at.t[k], at.at_end[k]), at.is_there[k], best, second);
    }
  };
  ForPlaces(x, y, nearest, next, kernel, [&](glm::dvec2 p) { return nearest_feet(pieces, p); });
}

void FeetOnEllipse(const Ellipse& ellipse, std::span<const double> x, std::span<const double> y,
                   const FootSpans& nearest, const FootSpans& next) {
  const EllipseNumbers frame{ellipse.center.x, ellipse.center.y, ellipse.axis.x,
                             ellipse.axis.y,   ellipse.radii.x,  ellipse.radii.y};
  const auto kernel = [&](Reals px, Reals py, RankedFeet& best, RankedFeet& second, Truths& ask)
                          HWY_ATTR { EllipseFeet(frame, px, py, best, second, ask); };
  ForPlaces(x, y, nearest, next, kernel, [&](glm::dvec2 p) { return nearest_feet(ellipse, p); });
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "sdf/distance/spans.h"

namespace mien {
namespace batch {
HWY_EXPORT(FeetOnPieces);
HWY_EXPORT(FeetOnEllipse);
namespace {

/// Asserts that results have the coordinates' length, or none, and lie clear of them.
void fit_feet(std::span<const double>& x, std::span<const double>& y, const FootSpans& to) {
  const auto fit = [&](auto span) {
    if (span.empty()) return;
    assert(span.size() == x.size() && y.size() == x.size() && "spans of equal length");
    assert(span.data() != static_cast<const void*>(x.data()) && !overlap_partly(x, span) &&
           !overlap_partly(y, span) && "results are clear of the coordinates");
    x = x.first(std::min({x.size(), y.size(), span.size()})), y = y.first(x.size());
  };
  fit(to.piece), fit(to.t), fit(to.distance), fit(to.normal_x), fit(to.normal_y), fit(to.bend);
}

template <class Exact>
void feet_one_by_one(std::span<const double> x, std::span<const double> y, const FootSpans& nearest,
                     const FootSpans& next, const Exact& exact) {
  const auto put = [](const Foot& foot, const FootSpans& to, size_t i) {
    if (!to.piece.empty()) to.piece[i] = foot.piece;
    if (!to.t.empty()) to.t[i] = foot.t;
    if (!to.distance.empty()) to.distance[i] = foot.distance;
    if (!to.normal_x.empty()) to.normal_x[i] = foot.normal.x;
    if (!to.normal_y.empty()) to.normal_y[i] = foot.normal.y;
    if (!to.bend.empty()) to.bend[i] = foot.bend;
  };
  for (size_t i = 0; i < x.size(); ++i) {
    const Feet found = exact(glm::dvec2{x[i], y[i]});
    put(found.nearest, nearest, i), put(found.next, next, i);
  }
}

template <class Figure>
void feet_on(std::span<const Figure> figures, std::span<const double> x, std::span<const double> y,
             const FootSpans& nearest, const FootSpans& next) {
  fit_feet(x, y, nearest), fit_feet(x, y, next);
  const std::vector<FootPiece> pieces = foot_pieces(figures);
  std::vector<FootFrame> frames;
  frames.reserve(pieces.size());
  bool fit = true;
  for (const FootPiece& piece : pieces) {
    frames.push_back(foot_frame(piece));
    fit = fit && (frames.back().fits || !piece.exists);
  }
  if (!fit)
    return feet_one_by_one(x, y, nearest, next, [&](glm::dvec2 p) {
      return nearest_feet(std::span<const FootPiece>(pieces), p);
    });
  MIEN_DISPATCH(FeetOnPieces)(frames, pieces, x, y, nearest, next);
}

}  // namespace
}  // namespace batch

void nearest_feet(std::span<const QuadBezier> curves, std::span<const double> x,
                  std::span<const double> y, const FootSpans& nearest, const FootSpans& next) {
  batch::feet_on(curves, x, y, nearest, next);
}
void nearest_feet(std::span<const Line> lines, std::span<const double> x, std::span<const double> y,
                  const FootSpans& nearest, const FootSpans& next) {
  batch::feet_on(lines, x, y, nearest, next);
}
void nearest_feet(std::span<const TaperedStroke> strokes, std::span<const double> x,
                  std::span<const double> y, const FootSpans& nearest, const FootSpans& next) {
  batch::feet_on(strokes, x, y, nearest, next);
}
void nearest_feet(const Ellipse& ellipse, std::span<const double> x, std::span<const double> y,
                  const FootSpans& nearest, const FootSpans& next) {
  batch::fit_feet(x, y, nearest), batch::fit_feet(x, y, next);
  const double longer = std::max(ellipse.radii.x, ellipse.radii.y);
  const double shorter = std::min(ellipse.radii.x, ellipse.radii.y);
  const double far = std::max(std::abs(ellipse.center.x), std::abs(ellipse.center.y));
  // Powers up to the twelfth of what lanes see stay in range.
  constexpr double kLargest = 0x1p60, kSmallest = 0x1p-60, kThinnest = 1e-3;
  const bool fits =
      longer < kLargest && far < kLargest && longer > kSmallest && shorter >= kThinnest * longer;
  if (!fits)
    return batch::feet_one_by_one(x, y, nearest, next,
                                  [&](glm::dvec2 p) { return nearest_feet(ellipse, p); });
  MIEN_DISPATCH(FeetOnEllipse)(ellipse, x, y, nearest, next);
}

}  // namespace mien
#endif
