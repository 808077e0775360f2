// Classifier::classify, compiled once per instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mien/sdf/edge/classify_simd.cpp"
#include <hwy/foreach_target.h>
#include <mien/sdf/edge/classify-inl.h>
#include <mien/sdf/edge/classify.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace mien::batch {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D, class V>
HWY_INLINE void StoreSides(D d, Verdict<V> v, std::int8_t* to) {
  const hn::RebindToSigned<D> di;
  const hn::Rebind<std::int8_t, D> d8;
  const V zero = hn::Zero(d);
  const V out = hn::IfThenElse(hn::Gt(v.out, zero), hn::Set(d, 1), zero);
  const V side = hn::IfThenElse(hn::Gt(v.in, zero), hn::Set(d, -1), out);
  hn::StoreU(hn::DemoteTo(d8, hn::ConvertTo(di, side)), d8, to);
}

/// step squares at a time: ask(x, y, sides). The rest is padded with its last square.
template <class D, class Ask>
HWY_INLINE void ForSquares(D, size_t step, const float* x, const float* y, size_t count,
                           std::int8_t* sides, Ask ask) {
  constexpr size_t kMost = kParts * hn::MaxLanes(D());
  for (size_t i = 0; i < count; i += step) {
    if (HWY_LIKELY(count - i >= step)) {
      ask(x + i, y + i, sides + i);
      continue;
    }
    const size_t left = count - i;
    HWY_ALIGN float rest[2][kMost];
    std::int8_t answers[kMost];
    for (size_t k = 0; k < step; ++k) {
      rest[0][k] = x[i + std::min(k, left - 1)], rest[1][k] = y[i + std::min(k, left - 1)];
    }
    ask(rest[0], rest[1], answers);
    std::copy_n(answers, left, sides + i);
  }
}

template <class Frame>
void Classify(const Frame& frame, const float* x, const float* y, size_t count, float half_diagonal,
              std::int8_t* sides) {
  const hn::ScalableTag<float> d;
  const auto ask = [&](const float* at_x, const float* at_y, std::int8_t* to) MIEN_LANES {
    StoreSides(d, Against(d, frame, hn::LoadU(d, at_x), hn::LoadU(d, at_y), half_diagonal), to);
  };
  ForSquares(d, hn::Lanes(d), x, y, count, sides, ask);
}

void ClassifyHalfPlane(const HalfPlaneSquares& f, const float* x, const float* y, size_t count,
                       float half_diagonal, std::int8_t* sides) {
  Classify(f, x, y, count, half_diagonal, sides);
}
void ClassifyParabola(const ParabolaSquares& f, const float* x, const float* y, size_t count,
                      float half_diagonal, std::int8_t* sides) {
  Classify(f, x, y, count, half_diagonal, sides);
}
void ClassifyEllipse(const EllipseSquares& f, const float* x, const float* y, size_t count,
                     float half_diagonal, std::int8_t* sides) {
  Classify(f, x, y, count, half_diagonal, sides);
}
void ClassifySegment(const SegmentSquares& f, const float* x, const float* y, size_t count,
                     float half_diagonal, std::int8_t* sides) {
  Classify(f, x, y, count, half_diagonal, sides);
}

void ClassifyStroke(const StrokeSquares& f, const float* x, const float* y, size_t count,
                    float half_diagonal, std::int8_t* sides) {
  const hn::ScalableTag<float> d;
  const size_t n = hn::Lanes(d);
  using V = hn::Vec<decltype(d)>;
  const auto ask = [&](const float* at_x, const float* at_y, std::int8_t* to) MIEN_LANES {
    const auto v = AgainstStroke(d, f, LoadPack(d, at_x), LoadPack(d, at_y), half_diagonal);
    StoreSides(d, Verdict<V>{v.out.a, v.in.a}, to);
    StoreSides(d, Verdict<V>{v.out.b, v.in.b}, to + n);
    StoreSides(d, Verdict<V>{v.out.c, v.in.c}, to + 2 * n);
    StoreSides(d, Verdict<V>{v.out.d, v.in.d}, to + 3 * n);
  };
  ForSquares(d, kParts * n, x, y, count, sides, ask);
}

}  // namespace HWY_NAMESPACE
}  // namespace mien::batch
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <mien/sdf/batch/one_by_one.h>
#include <mien/sdf/distance.h>
#include <mien/sdf/shape/path.h>

#include <cmath>

namespace mien {
namespace batch {
HWY_EXPORT(ClassifyHalfPlane);
HWY_EXPORT(ClassifyParabola);
HWY_EXPORT(ClassifyEllipse);
HWY_EXPORT(ClassifySegment);
HWY_EXPORT(ClassifyStroke);
}  // namespace batch

namespace {

struct Squares {
  std::span<const float> x, y;
  float half_diagonal;
  std::span<std::int8_t> sides;

  void operator()(const HalfPlaneSquares& f) const {
    HWY_DYNAMIC_DISPATCH(batch::ClassifyHalfPlane)
    (f, x.data(), y.data(), x.size(), half_diagonal, sides.data());
  }
  void operator()(const ParabolaSquares& f) const {
    HWY_DYNAMIC_DISPATCH(batch::ClassifyParabola)
    (f, x.data(), y.data(), x.size(), half_diagonal, sides.data());
  }
  void operator()(const EllipseSquares& f) const {
    HWY_DYNAMIC_DISPATCH(batch::ClassifyEllipse)
    (f, x.data(), y.data(), x.size(), half_diagonal, sides.data());
  }
  void operator()(const SegmentSquares& f) const {
    HWY_DYNAMIC_DISPATCH(batch::ClassifySegment)
    (f, x.data(), y.data(), x.size(), half_diagonal, sides.data());
  }
  void operator()(const StrokeSquares& f) const {
    HWY_DYNAMIC_DISPATCH(batch::ClassifyStroke)
    (f, x.data(), y.data(), x.size(), half_diagonal, sides.data());
  }

  /// Only squares that no side comes near ask for the winding number, and of those only the ones that are
  /// not in a disc without outline around another that did.
  void operator()(const PathSquares& f) const {
    constexpr size_t kMost = 256;
    float d[kMost];
    struct Known {
      glm::dvec2 center;
      double clear;  ///< no outline is so near
      std::int8_t side;
    };
    constexpr size_t kMostKnown = 8;
    Known known[kMostKnown];
    size_t count_known = 0;
    const auto side_at = [&](glm::dvec2 c, double clear) {
      for (size_t j = 0; j < count_known; ++j) {
        const glm::dvec2 way = c - known[j].center;
        if (way.x * way.x + way.y * way.y < known[j].clear * known[j].clear) return known[j].side;
      }
      const auto side = std::int8_t(is_inside(f.path.rule, winding(f.path, c)) ? -1 : 1);
      if (count_known < kMostKnown) known[count_known++] = {c, clear, side};
      return side;
    };
    for (size_t i = 0; i < x.size(); i += kMost) {
      const size_t count = std::min(kMost, x.size() - i);
      distances(f.sides, x.subspan(i, count), y.subspan(i, count), std::span(d, count));
      for (size_t k = 0; k < count; ++k) {
        const glm::dvec2 c{x[i + k], y[i + k]};
        const double margin = double(kClassifyRounding) *
                              (std::abs(c.x) + std::abs(c.y) + double(d[k]) + 2 * double(f.size));
        const double reach = double(half_diagonal) + margin;
        const bool clear = std::isfinite(d[k]) && double(d[k]) > reach;
        sides[i + k] = clear ? side_at(c, double(d[k]) - margin) : std::int8_t{};
      }
    }
  }

  void operator()(const AnySquares& f) const {
    for (size_t i = 0; i < x.size(); ++i) {
      const glm::dvec2 c = f.origin + glm::dvec2{x[i], y[i]};
      const double d = distance(f.shape, c);
      // The scalar forms' own error is some 2⁻⁵⁰ of the coordinates; far less than this.
      const double reach =
          double(half_diagonal) + 0x1p-40 * (std::abs(c.x) + std::abs(c.y) + std::abs(d));
      sides[i] =
          std::isfinite(x[i] + y[i]) ? std::int8_t((d > reach) - (d < -reach)) : std::int8_t{};
    }
  }
};

}  // namespace

Classifier::Classifier(const OffsetShape& shape, glm::dvec2 origin)
    : frame_(classify_frame(shape, origin)) {}

void Classifier::classify(std::span<const float> x, std::span<const float> y, float half_diagonal,
                          std::span<std::int8_t> sides) const {
  const batch::Span to{sides.data(), sides.size(), 1};
  batch::require_spans("classify", batch::span_of(x), batch::span_of(y), to);
  if (x.empty()) return;
  std::visit(Squares{x, y, half_diagonal, sides}, frame_);
}

}  // namespace mien
#endif
