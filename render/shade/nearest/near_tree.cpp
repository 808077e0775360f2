// Which operands of a combination matter around a place: of a union of thousands of shapes a few.

#include "lib/base/watch.h"
#include "render/shade/nearest/near_feet.h"
#include "sdf/csg/combine.h"

#include <algorithm>
#include <cmath>

namespace mien {

/// What of a tree decides somewhere in a disc: of two operands one alone, where the other is farther by more than both
/// can change.
void NearFeet::prune(std::span<const Node> nodes, glm::dvec2 middle, double radius,
                     std::vector<Node>& to) {
  constexpr int kUnused = -4, kNeeded = -3, kOnlyA = -2, kOnlyB = -1;
  worked(60 * std::int64_t(nodes.size()));
  const AreaDistance& area = *area_->area();
  const double change = 2.0 * radius + 1e-3;
  const std::size_t count = nodes.size();
  values_.resize(count), place_.assign(count, kUnused);
  for (std::size_t i = 0; i < count; ++i) {
    const Node& n = nodes[i];
    values_[i] = n.op == Op::shape ? area.of_shape(std::size_t(n.a), middle)
                                   : combine(n.op, values_[std::size_t(n.a)],
                                             values_[std::size_t(n.b)], n.amount);
  }
  place_[count - 1] = kNeeded;
  for (std::size_t i = count; i-- > 0;) {
    const Node& n = nodes[i];
    if (place_[i] == kUnused || n.op == Op::shape) continue;
    const bool binary = n.op == Op::unite || n.op == Op::intersect || n.op == Op::subtract;
    const double sign = n.op == Op::unite ? -1.0 : 1.0;  // the larger one counts
    const double a = sign * values_[std::size_t(n.a)], b = n.op == Op::subtract
                                                               ? -values_[std::size_t(n.b)]
                                                               : sign * values_[std::size_t(n.b)];
    place_[i] = binary && a > b + change ? kOnlyA : binary && b > a + change ? kOnlyB : kNeeded;
    if (place_[i] != kOnlyB) place_[std::size_t(n.a)] = kNeeded;
    if (binary && place_[i] != kOnlyA) place_[std::size_t(n.b)] = kNeeded;
  }
  to.clear();
  for (std::size_t i = 0; i < count; ++i) {
    Node n = nodes[i];
    const int how = place_[i];
    if (how == kUnused) continue;
    if (n.op != Op::shape) {
      const int a = place_[std::size_t(n.a)], b = place_[std::size_t(n.b)];
      const int only = how == kOnlyA ? a : how == kOnlyB ? b : -1;
      if (only >= 0 && !(how == kOnlyB && n.op == Op::subtract)) {
        place_[i] = only;
        continue;
      }
      n.a = only >= 0 ? only : a, n.b = only >= 0 ? only : b;
      if (only >= 0) n.op = Op::complement;
    }
    place_[i] = int(to.size());
    to.push_back(n);
  }
}

/// The tile's tree, as far as it matters at these places.
std::span<const Node> NearFeet::nodes_around(std::span<const float> x, std::span<const float> y) {
  constexpr std::size_t kFewPlaces = 16;
  if (tree_.size() < kLargeTree || x.size() < kFewPlaces) return tree_;
  const auto [x0, x1] = std::minmax_element(x.begin(), x.end());
  const auto [y0, y1] = std::minmax_element(y.begin(), y.end());
  const glm::dvec2 middle{0.5 * (double(*x0) + double(*x1)), 0.5 * (double(*y0) + double(*y1))};
  const double radius = 0.5 * std::hypot(double(*x1) - double(*x0), double(*y1) - double(*y0));
  if (radius > 0.25 * radius_) return tree_;
  prune(tree_, middle_ - area_->center() + middle, radius, near_);
  return near_;
}

}  // namespace mien
