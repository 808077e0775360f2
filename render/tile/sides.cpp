#include <mien/render/tile/sides.h>

namespace mien {

Sides sides_of(std::span<const Step> steps, std::span<const Sides> outlines,
               std::vector<Sides>& stack) {
  using Kind = Step::Kind;
  if (steps.empty()) return {~std::uint64_t{0}, 0};
  if (steps.size() == 1 && steps[0].kind == Kind::outline)
    return outlines[std::size_t(steps[0].outline)];
  stack.clear();
  for (const Step& step : steps) switch (step.kind) {
      case Kind::outline:
        stack.push_back(outlines[std::size_t(step.outline)]);
        break;
      case Kind::nothing:
        stack.push_back({0, ~std::uint64_t{0}});
        break;
      case Kind::not_:
        std::swap(stack.back().in, stack.back().out);
        break;
      case Kind::and_:
      case Kind::or_: {
        const Sides b = stack.back();
        stack.pop_back();
        Sides& a = stack.back();
        if (step.kind == Kind::and_)
          a.in &= b.in, a.out |= b.out;
        else
          a.in |= b.in, a.out &= b.out;
        break;
      }
    }
  return stack.back();
}

}  // namespace mien
