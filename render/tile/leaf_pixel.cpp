// One pixel of a leaf by the scalar forms.

#include <mien/render/cover/arrangement.h>
#include <mien/render/cover/edge_coverage.h>
#include <mien/render/tile/leaf.h>
#include <mien/render/tile/leaf_errors.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace mien {
namespace {

using Sight = LeafView::Sight;

Sight see(const LeafEdge& e, glm::dvec2 p) {
  if (e.has_end()) {
    const glm::dvec2 u = p - glm::dvec2{e.end_x, e.end_y};
    if (glm::dot(u, glm::dvec2{e.along_x, e.along_y}) > 0.0) {
      const double rho = glm::length(u);
      const double d = rho - 1.0 / e.end_bend;
      const bool mine =
          glm::dot(u, glm::dvec2{e.end_nx, e.end_ny}) >= 0.0 ||
          (d > double(kEndHalo) && glm::dot(u, glm::dvec2{e.other_x, e.other_y}) > 0.0);
      if (!mine || rho == 0.0) return {-1e6, {1.0, 0.0}, 0.0};
      return {d, u / rho, e.end_bend};
    }
  }
  LeafEdge::Body b{e.x, e.y, e.nx, e.ny, e.bend, e.c3, e.c4};
  if (e.joined &&
      glm::dot(p - glm::dvec2{e.end_x, e.end_y}, glm::dvec2{e.along_x, e.along_y}) > 0.0)
    b = e.next;
  const glm::dvec2 u = p - glm::dvec2{b.x, b.y}, n{b.nx, b.ny}, m{-n.y, n.x};
  const double x = glm::dot(u, m), y = glm::dot(u, n), k = b.bend, c3 = b.c3, c4 = b.c4;
  if (k == 0.0 && c3 == 0.0 && c4 == 0.0) return {y, n, 0.0};  // a line
  const double f = y + 0.5 * k * glm::dot(u, u);
  const double root = std::sqrt(std::max(1.0 + 2.0 * k * f, 1e-8));
  const glm::dvec2 g = (n + k * u) / root + x * x * (3.0 * c3 + 4.0 * c4 * x) * m;
  return {2.0 * f / (1.0 + root) + x * x * x * (c3 + c4 * x) * (1.0 + 0.5 * k * k * x * x),
          glm::normalize(g), k};
}

/// Resolves squares of one pixel.
class LeafSquare {
 public:
  LeafSquare(const Leaf& leaf, double tolerance, long long& cells)
      : leaf_(leaf), tolerance_(tolerance), cells_(cells) {}

  /// What see_square says.
  static LeafView view(const Leaf& leaf, glm::dvec2 center, double side, double tolerance,
                       std::uint32_t asked, std::uint32_t base) {
    LeafView view{.base = base};
    for (; asked; asked &= asked - 1) {
      const int i = std::countr_zero(asked);
      const LeafEdge& e = leaf.edges[std::size_t(i)];
      view.with_end |= std::uint32_t(e.has_end() && at_line(e, center, side)) << i;
      const Sight& s = view.sights[std::size_t(i)] = see(e, center);
      if (std::abs(s.d) <= reach_of(s, side) || (e.has_end() && at_end(e, center, side)))
        view.active |= 1u << i;
      else
        view.base |= std::uint32_t(s.d < 0.0) << i;
    }
    view.active = mattering(leaf, view.active, view.base);
    double straightened_by = 0.0;
    for (std::uint32_t rest = view.active; rest; rest &= rest - 1) {
      const auto i = std::size_t(std::countr_zero(rest));
      const LeafEdge& e = leaf.edges[i];
      view.divide |=
          e.has_end() && at_end(e, center, side) && end_error(double(e.end_bend), side) > tolerance;
      view.divide |= parabola_error(view.sights[i].bend, side) > tolerance;
      view.divide |= e.joined && at_joint(e, center, side) &&
                     joint_error(double(e.next.bend) - double(e.bend), side) > tolerance;
      straightened_by += together_error(std::abs(view.sights[i].bend), side);
    }
    view.divide |= !std::has_single_bit(view.active) && straightened_by > tolerance;
    return view;
  }

  /// `asked`: edges that may cross the square; `base`: the sides of the others.
  Mix mean(glm::dvec2 center, double side, int depth, std::uint32_t asked, std::uint32_t base) {
    const LeafView seen = view(leaf_, center, side, tolerance_, asked, base);
    if (!seen.active) return color(seen.base);
    constexpr int kDeepest = 6;
    if (seen.divide && depth < kDeepest) {
      const double half = 0.5 * side, quarter = 0.25 * side;
      cells_ += 4;
      Mix sum{0.0};
      for (const double y : {-quarter, quarter})
        for (const double x : {-quarter, quarter})
          sum += 0.25 * mean(center + glm::dvec2{x, y}, half, depth + 1,
                             seen.active | seen.with_end, seen.base & ~seen.with_end);
      return sum;
    }
    if (std::has_single_bit(seen.active)) {
      const Sight& s = seen.sights[std::size_t(std::countr_zero(seen.active))];
      const double bend = std::clamp(s.bend * side, -1.0, 1.0);
      const double covered = bent_edge_coverage(s.d / side, s.n, bend);
      return covered * color(seen.base | seen.active) + (1.0 - covered) * color(seen.base);
    }
    return arranged(seen.sights, seen.active, seen.base, side);
  }

 private:
  static double reach_of(const Sight& s, double side) {
    return 0.5 * side * (std::abs(s.n.x) + std::abs(s.n.y)) + 0.3 * std::abs(s.bend) * side * side;
  }

  Mix color(std::uint32_t sides) const {
    return {leaf_.palette[0][sides], leaf_.palette[1][sides], leaf_.palette[2][sides],
            leaf_.palette[3][sides]};
  }

  /// Whether parts of the square may see more of the edge than its centre does: across its end's line,
  /// or where the round end is the other edge's.
  static bool at_line(const LeafEdge& e, glm::dvec2 center, double side) {
    const double r = 0.7072 * side;
    const glm::dvec2 u = center - glm::dvec2{e.end_x, e.end_y};
    const double beyond = glm::dot(u, glm::dvec2{e.along_x, e.along_y});
    if (beyond < -r) return false;
    return beyond < r || glm::dot(u, glm::dvec2{e.end_nx, e.end_ny}) < r;
  }

  /// Whether the square may hold the place where a body becomes its round end.
  static bool at_end(const LeafEdge& e, glm::dvec2 center, double side) {
    const double r = 0.7072 * side;
    const glm::dvec2 u = center - glm::dvec2{e.end_x, e.end_y};
    const double beyond = glm::dot(u, glm::dvec2{e.along_x, e.along_y});
    if (!(std::abs(beyond) < r)) return false;
    const double up = glm::dot(u, glm::dvec2{e.end_nx, e.end_ny});
    return up > -r && std::abs(glm::length(u) - 1.0 / e.end_bend) < 2.0 * r;
  }

  /// Whether the square may hold a joint.
  static bool at_joint(const LeafEdge& e, glm::dvec2 center, double side) {
    const glm::dvec2 u = center - glm::dvec2{e.end_x, e.end_y};
    return glm::dot(u, u) <= side * side;
  }

  /// Drops edges whose side changes no colour, for the sides of the others that may occur.
  static std::uint32_t mattering(const Leaf& leaf, std::uint32_t active, std::uint32_t base) {
    std::uint32_t kept = active;
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const std::uint32_t bit = rest & -rest, others = kept & ~bit;
      bool matters = false;
      for (std::uint32_t sub = others;; sub = (sub - 1) & others) {
        matters |= leaf.same[base | sub] != leaf.same[base | sub | bit];
        if (sub == 0 || matters) break;
      }
      if (!matters) kept &= ~bit;
    }
    return kept;
  }

  Mix arranged(const std::array<Sight, Leaf::kMostEdges>& sights, std::uint32_t active,
               std::uint32_t base, double side) const {
    thread_local Arrangement arrangement;
    std::array<Cut, Leaf::kMostEdges> cuts;
    std::array<std::uint32_t, Leaf::kMostEdges> bits;
    std::size_t count = 0;
    for (std::uint32_t rest = active; rest; rest &= rest - 1) {
      const Sight& s = sights[std::size_t(std::countr_zero(rest))];
      bits[count] = rest & -rest;
      cuts[count++] = {straightened(s.d / side, s.n, s.bend * side), s.n};
    }
    Mix mix{0.0};
    for (const Arrangement::Piece& piece : arrangement.cut({cuts.data(), count})) {
      std::uint32_t sides = base;
      for (std::size_t i = 0; i < count; ++i)
        if (piece.inside >> i & 1u) sides |= bits[i];
      mix += piece.area * color(sides);
    }
    return mix;
  }

  const Leaf& leaf_;
  const double tolerance_;
  long long& cells_;
};

}  // namespace

Mix leaf_square(const Leaf& leaf, double x, double y, double side, std::uint32_t asked,
                std::uint32_t base, double tolerance, long long& cells) {
  return LeafSquare(leaf, tolerance, cells).mean({x, y}, side, 0, asked, base);
}

LeafView see_square(const Leaf& leaf, glm::dvec2 center, double side, double tolerance,
                    std::uint32_t asked, std::uint32_t base) {
  return LeafSquare::view(leaf, center, side, tolerance, asked, base);
}

BlockSides see_block(const Leaf& leaf, glm::dvec2 center) {
  constexpr double kPastEnd = 3.0;  // half a block's diagonal, and what kEndHalo lacks to it
  BlockSides sides{0, 0};
  for (int i = 0; i < leaf.edge_count; ++i) {
    const LeafEdge& e = leaf.edges[std::size_t(i)];
    const glm::dvec2 from_end = center - glm::dvec2{e.end_x, e.end_y};
    if (e.has_end() && glm::dot(from_end, glm::dvec2{e.along_x, e.along_y}) > -kPastEnd) {
      sides.crossed |= 1u << i;
      continue;
    }
    const Sight s = see(e, center);
    const double bend = std::max({std::abs(s.bend), std::abs(double(e.bend)),
                                  e.joined ? std::abs(double(e.next.bend)) : 0.0});
    // Half a block's side along the normal, the bend over its half diagonal, and rounding.
    const double reach = 2.0 * (std::abs(s.n.x) + std::abs(s.n.y)) + 4.5 * bend + 2e-3 +
                         double(e.error) + (e.joined ? 3.0 * kMostJointTurn : 0.0);
    if (std::abs(s.d) <= reach)
      sides.crossed |= 1u << i;
    else
      sides.inside |= std::uint32_t(s.d < 0.0) << i;
  }
  return sides;
}

Mix leaf_pixel(const Leaf& leaf, double x, double y, double tolerance, long long& cells) {
  return leaf_square(leaf, x, y, 1.0, (1u << leaf.edge_count) - 1u, 0, tolerance, cells);
}

}  // namespace mien
