// The part of VariedSquare that cuts cells and chooses the places in them from which colours are seen.

#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/varied_square.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

constexpr double kGauss = 0.28867513459481287;  // 1/√12

}  // namespace

/// A cell whose paints are known, by its edges: divided until those are straight.
void VariedSquare::edges(const Leaf& leaf, const Cell& cell, glm::dvec2 center, double side,
                         int depth, std::uint32_t asked, std::uint32_t base) {
  if (!asked && cuts_.empty())
    return sample_gauss(base, center, side, side * side, cell.index, cell.pixel);
  const LeafView view = see_square(leaf, center, side, tolerance_, asked, base);
  if (!view.active && cuts_.empty())
    return sample_gauss(view.base, center, side, side * side, cell.index, cell.pixel);
  bool divide = view.divide;
  in_share_ = out_share_ = 1.0;
  if (std::has_single_bit(view.active) && cuts_.empty())
    divide |= !put_right(view.sights[std::size_t(std::countr_zero(view.active))], side);
  for (std::uint32_t rest = view.active; rest && !divide; rest &= rest - 1) {
    // What is left of a bend is that colours are seen where its chord is; of one whose area is not put right, bend/24
    // of a square's area, in one or two of them.
    constexpr double kMostBend = 0.25, kMostArea = 1.0 / 4096;
    const double bend = std::abs(view.sights[std::size_t(std::countr_zero(rest))].bend) * side;
    divide = bend > kMostBend || (!cuts_.empty() && bend * side * side / 24 > kMostArea);
  }
  if (!divide || depth >= kEdgeDepth) return sample_pieces(view, cell, center, side);
  for (const double y : {-0.25, 0.25})
    for (const double x : {-0.25, 0.25})
      edges(leaf, cell, center + side * glm::dvec2{x, y}, 0.5 * side, depth + 1,
            view.active | view.with_end, view.base & ~view.with_end);
}

/// How much the two pieces that a straightened edge cuts count for, so that their areas are those of the bent
/// one. False: a piece is too small to stand for what is missing.
bool VariedSquare::put_right(const LeafView::Sight& edge, double side) {
  const double bend = std::clamp(edge.bend * side, -1.0, 1.0);
  const double straight =
      straight_edge_coverage(straightened(edge.d / side, edge.n, edge.bend * side), edge.n);
  const double bent = bent_edge_coverage(edge.d / side, edge.n, bend);
  constexpr double kSmall = 0.05, kOff = 1.0 / 4096;
  if (std::abs(bent - straight) * side * side <= kOff) return true;
  if (straight < kSmall || straight > 1.0 - kSmall) return false;
  in_share_ = bent / straight, out_share_ = (1.0 - bent) / (1.0 - straight);
  return true;
}

void VariedSquare::sample(std::uint32_t sides, glm::dvec2 at, double weight, int cell, int pixel) {
  Stack& stack = stacks_[stack_of_[sides]];
  stack.x.push_back(float(at.x)), stack.y.push_back(float(at.y));
  stack.cell.push_back(cell);
  stack.weight.push_back(weight);
  stack.pixel.push_back(std::uint16_t(pixel));
}

void VariedSquare::sample_gauss(std::uint32_t sides, glm::dvec2 center, double side, double weight,
                                int cell, int pixel) {
  const double k = kGauss * side;
  if (stacks_[stack_of_[sides]].paints == 0) return sample(sides, center, weight, cell, pixel);
  for (const double y : {-k, k})
    for (const double x : {-k, k})
      sample(sides, center + glm::dvec2{x, y}, 0.25 * weight, cell, pixel);
}

/// Cut by its active edges, taken for straight lines, and by the kinks of the cell's paints. The
/// area of one bent edge alone is put right.
void VariedSquare::sample_pieces(const LeafView& view, const Cell& cell, glm::dvec2 center,
                                 double side) {
  all_cuts_.clear();
  std::array<std::uint32_t, Leaf::kMostEdges> bits;
  std::size_t count = 0;
  for (std::uint32_t rest = view.active; rest; rest &= rest - 1) {
    const LeafView::Sight& s = view.sights[std::size_t(std::countr_zero(rest))];
    bits[count++] = rest & -rest;
    all_cuts_.push_back({straightened(s.d / side, s.n, s.bend * side), s.n});
  }
  // Kinks are told from the cell's middle in its sides.
  const glm::dvec2 from_cell = (center - cell.center) / cell.side;
  if (all_cuts_.size() + cuts_.size() <= Arrangement::kMaxCuts)
    for (const Cut& cut : cuts_)
      all_cuts_.push_back(
          {(cut.d + glm::dot(from_cell, cut.normal)) * (cell.side / side), cut.normal});
  if (all_cuts_.empty())
    return sample_gauss(view.base, center, side, side * side, cell.index, cell.pixel);
  const auto pieces = arrangement_.cut(all_cuts_);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::uint32_t sides = view.base;
    for (std::size_t k = 0; k < count; ++k)
      if (pieces[i].inside >> k & 1u) sides |= bits[k];
    const double share = pieces[i].inside & 1u ? in_share_ : out_share_;
    const std::span<const glm::dvec2> p = arrangement_.corners(i);
    if (stacks_[stack_of_[sides]].paints == 0) {
      sample(sides, center, share * pieces[i].area * side * side, cell.index, cell.pixel);
      continue;
    }
    constexpr double kNear = 2.0 / 3.0, kFar = 1.0 / 6.0;
    for (std::size_t k = 2; k < p.size(); ++k) {
      const glm::dvec2 a = p[k - 1] - p[0], b = p[k] - p[0];
      const double area = 0.5 * (a.x * b.y - a.y * b.x);
      if (!(area > 0.0)) continue;
      const double weight = share * area * side * side / 3.0;
      const auto at = [&](glm::dvec2 u) {
        sample(sides, center + side * u, weight, cell.index, cell.pixel);
      };
      at(kNear * p[0] + kFar * (p[k - 1] + p[k]));
      at(kNear * p[k - 1] + kFar * (p[0] + p[k]));
      at(kNear * p[k] + kFar * (p[0] + p[k - 1]));
    }
  }
}

}  // namespace mien
