#include <mien/render/tile/plan.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mien {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Box2 kEverywhere{{-kInf, -kInf}, {kInf, kInf}};
constexpr Box2 kNowhere{{kInf, kInf}, {-kInf, -kInf}};

Box2 box_of(const OffsetShape& s) {
  Box2 box = bounds(s.shape);
  // The boxes of shapes are right to rounding; half a pixel is far more.
  const double grow = std::max(s.offset, 0.0) + 0.5;
  box.lo -= grow, box.hi += grow;
  return box;
}

/// The box of what a layer's program can cover.
Box2 box_of(std::span<const Step> steps, const std::vector<Box2>& outlines,
            std::vector<Box2>& stack) {
  using Kind = Step::Kind;
  stack.clear();
  if (steps.empty()) return kEverywhere;
  for (const Step& step : steps) switch (step.kind) {
      case Kind::outline:
        stack.push_back(outlines[std::size_t(step.outline)]);
        break;
      case Kind::nothing:
        stack.push_back(kNowhere);
        break;
      case Kind::not_:
        stack.back() = kEverywhere;
        break;
      case Kind::and_:
      case Kind::or_: {
        const Box2 b = stack.back();
        stack.pop_back();
        Box2& a = stack.back();
        if (step.kind == Kind::and_)
          a = {glm::max(a.lo, b.lo), glm::min(a.hi, b.hi)};
        else
          a = {glm::min(a.lo, b.lo), glm::max(a.hi, b.hi)};
        break;
      }
    }
  return stack.back();
}

/// An eighth to a quarter of what a pixel may be off at the depth's precision; blending in linear
/// light multiplies a small covered area by up to 12.92 on encoding.
double tolerance_for(Depth depth, Blend blend) {
  const bool fine = depth != Depth::u8, linear = blend == Blend::linear;
  return fine ? (linear ? 0x1p-16 : 0x1p-13) : (linear ? 0x1p-13 : 0x1p-11);
}

}  // namespace

std::uint32_t packed_pixel(const Mix& mix, Blend blend) {
  std::uint32_t value = 0;
  store(mix, blend, Depth::u8, &value);
  return value;
}

Plan::Plan(const Tape& t, Depth d) : tape(t) {
  make(d);
}

void Plan::make(Depth d) {
  ++made;
  depth = d;
  background = packed_pixel(tape.background, tape.blend);
  tolerance = tolerance_for(d, tape.blend);
  plain = true;
  squares.clear(), outlines.clear(), outline_boxes.clear(), layer_boxes.clear(), packed.clear();
  squares.reserve(tape.outlines.size());
  outlines.reserve(tape.outlines.size());
  outline_boxes.reserve(tape.outlines.size());
  for (const OffsetShape& s : tape.outlines) {
    squares.emplace_back(s, glm::dvec2{0.0});
    outlines.emplace_back(s, tolerance / 2.5);
    outline_boxes.push_back(box_of(s));
  }
  for (const TapeLayer& layer : tape.layers) {
    layer_boxes.push_back(
        box_of({tape.steps.data() + layer.first, std::size_t(layer.count)}, outline_boxes, stack_));
    packed.push_back(layer.plain() ? packed_pixel(layer.mix, tape.blend) : 0);
    plain = plain && layer.plain();
  }
}

}  // namespace mien
