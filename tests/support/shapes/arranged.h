#pragma once
// Outlines arranged with a look for every set of them: two regions look alike only if they are inside
// of the same outlines, so that no fault of an arrangement can hide behind a colour. Or as opaque layers, of which
// most crossings are hidden.

#include "sdf/arrange/sweep.h"
#include "sdf/outline/outline_maker.h"

#include <algorithm>
#include <bit>
#include <map>
#include <span>
#include <vector>

#include "tests/support/random/random.h"
#include "tests/support/shapes/outline_sight.h"

namespace mien::test {

/// Each set has a number of its own; that of the empty one is 0.
class SetRule final : public LookRule {
 public:
  explicit SetRule(int outlines) : words_(std::size_t(outlines + 63) / 64) {}

  int state_words() const override { return 1; }
  int first_look(std::uint64_t* state) override {
    state[0] = 0;
    return look_of(std::vector<std::uint64_t>(words_, 0));
  }
  /// Its word counts the outlines in the set.
  int look(const std::uint64_t* inside, int outline, const std::uint64_t* before, int,
           std::uint64_t* state) override {
    ++asked;
    state[0] = before[0] + (inside[outline >> 6] >> (outline & 63) & 1 ? 1u : ~std::uint64_t{0});
    counts_right = counts_right && state[0] == count(inside);
    return look_of({inside, inside + words_});
  }

  int look_of(const std::vector<std::uint64_t>& set) {
    return numbers_.try_emplace(set, int(numbers_.size())).first->second;
  }

  int asked = 0;
  bool counts_right = true;  ///< the words given were those of the region come from

 private:
  std::uint64_t count(const std::uint64_t* inside) const {
    std::uint64_t sum = 0;
    for (std::size_t w = 0; w < words_; ++w) sum += std::uint64_t(std::popcount(inside[w]));
    return sum;
  }

  std::size_t words_;
  std::map<std::vector<std::uint64_t>, int> numbers_;
};

/// The look of a set is its last outline: layers on top of each other.
class TopmostRule final : public LookRule {
 public:
  explicit TopmostRule(int) {}

  int state_words() const override { return 0; }
  int first_look(std::uint64_t*) override { return 0; }
  int look(const std::uint64_t* inside, int outline, const std::uint64_t*, int look_before,
           std::uint64_t*) override {
    if (outline + 1 < look_before) return look_before;
    int top = std::max(outline + 1, look_before);
    while (top > 0 && !(inside[(top - 1) >> 6] >> ((top - 1) & 63) & 1)) --top;
    return top;
  }
  int look_of(const std::vector<std::uint64_t>& set) const {
    for (std::size_t w = set.size(); w-- > 0;)
      if (set[w]) return int(64 * w) + int(std::bit_width(set[w]));
    return 0;
  }
};

template <class Rule>
struct ArrangedBy {
  Outlines outlines;
  double top, bottom;
  Rule rule;
  Regions regions;
  Sweep sweep;

  ArrangedBy(Outlines o, double from, double to)
      : outlines(std::move(o)), top(from), bottom(to), rule(int(outlines.rules.size())) {
    regions.begin(int(outlines.rules.size()), rule);
    sweep.run(outlines, top, bottom, regions);
  }

  /// The look of a place, by the outlines one by one.
  int look_at(glm::dvec2 p) {
    std::vector<std::uint64_t> set((outlines.rules.size() + 63) / 64, 0);
    for (std::size_t i = 0; i < outlines.rules.size(); ++i)
      if (is_inside(outlines, int(i), p)) set[i / 64] |= std::uint64_t{1} << (i % 64);
    return rule.look_of(set);
  }

  struct Crossed {
    double x;
    int left, right;
  };
  /// The fragments at a height, from left to right.
  std::vector<Crossed> row(double y) const {
    std::vector<Crossed> found;
    for (const Fragment& f : sweep.fragments())
      if (f.top <= y && y < f.bottom)
        found.push_back({mien::x_at(sweep.piece(f.piece), y), f.left, f.right});
    std::stable_sort(found.begin(), found.end(),
                     [](const Crossed& a, const Crossed& b) { return a.x < b.x; });
    return found;
  }

  /// The look that the fragments left of a place lead to, beginning with that left of all; −1 where
  /// they do not join. By sums: the order of those at one place is of no matter.
  int shown(glm::dvec2 p) {
    std::map<int, int> balance;
    ++balance[look_at({-1e6, p.y})];
    for (const Crossed& c : row(p.y))
      if (c.x < p.x) --balance[c.left], ++balance[c.right];
    int look = -1;
    for (const auto& [which, count] : balance) {
      if (count == 0) continue;
      if (count != 1 || look >= 0) return -1;
      look = which;
    }
    return look;
  }
};

using Arranged = ArrangedBy<SetRule>;
using ArrangedLayers = ArrangedBy<TopmostRule>;

/// The outlines of shapes whose units are pixels.
inline Outlines outlines_of(std::span<const Shape> shapes, const Box2& window,
                            double tolerance = 1.0 / 800) {
  Outlines made;
  OutlineMaker maker;
  maker.begin({{}, window, tolerance}, made);
  for (const Shape& shape : shapes) maker.fill(shape);
  maker.finish();
  return made;
}

}  // namespace mien::test
