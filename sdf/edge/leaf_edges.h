#pragma once
// An outline in many leaves at once.
//
//   const LeafOutlines lid(shape);                              // what depends on the shape alone, once
//   lid.in_leaves({cx, cy, leaves, radius}, outlines, edges);   // 16 leaves take about as long as two
//
// Parabolas (sides and strokes), ellipses and closed outlines (paths, strokes of varying width) are
// expanded in vectors; anything else by edges_near, one leaf after the other. Proofs:
// docs/derivations/leaf_edges.md.

#include <mien/sdf/edge/curve_form.h>
#include <mien/sdf/edge/leaf_edge.h>
#include <mien/sdf/edge/outline_form.h>

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

namespace mien {

/// Up to 16 leaves: squares along the axes by their centres and the half of their diagonal.
struct Leaves {
  static constexpr int kMost = 16;
  alignas(64) std::array<double, kMost> x, y;
  std::uint32_t wanted;  ///< bit i: leaf i is asked for. The centres of all must be finite
  double radius;
};

/// The wanted leaves first, one after the other, and copies of the last behind them: what nobody
/// wants takes no steps.
Leaves packed_to_front(const Leaves& leaves);

/// What the kernels find for 16 leaves: feet, normals and the two outlines' expansions.
struct CurveLeaves {
  using Lanes = std::array<double, Leaves::kMost>;
  alignas(64) Lanes foot;  ///< parabola: its x in the frame
  Lanes side;              ///< signed distance to the curve, along the normal
  Lanes nx, ny;
  struct Level {
    alignas(64) Lanes bend, c3, c4, error;
  };
  std::array<Level, 2> levels;  ///< strokes: at +level and −level; else the first alone
  std::uint32_t proven;         ///< bit i: everything above holds in leaf i
};

void parabola_leaves(const ParabolaForm& form, const Leaves& leaves, CurveLeaves& out);
void ellipse_leaves(const EllipseForm& form, const Leaves& leaves, CurveLeaves& out);

class LeafOutlines {
 public:
  /// `tolerance`: how far the description of a stroke of varying width may be off [px].
  explicit LeafOutlines(const OffsetShape& shape, double tolerance = 0x1p-14);

  /// Describes the outline in every wanted leaf, appending to `edges`. What is not proven says so.
  void in_leaves(const Leaves& leaves, std::span<LeafOutline, Leaves::kMost> outlines,
                 std::vector<LeafEdge>& edges) const;

 private:
  void parabola(const ParabolaForm& form, const Leaves& leaves,
                std::span<LeafOutline, Leaves::kMost> outlines, std::vector<LeafEdge>& edges) const;
  void ellipse(const EllipseForm& form, const Leaves& leaves,
               std::span<LeafOutline, Leaves::kMost> outlines, std::vector<LeafEdge>& edges) const;

  const OffsetShape* shape_;  // outlives this
  std::variant<std::monostate, ParabolaForm, EllipseForm, OutlineForm> form_;
};

/// A closed outline in leaves. Leaves it says nothing of have the error kUnproven.
void outline_leaves(const OutlineForm& form, const Leaves& leaves,
                    std::span<LeafOutline, Leaves::kMost> outlines, std::vector<LeafEdge>& edges);

/// One leaf by edges_near: second order only.
LeafOutline leaf_outline_near(const OffsetShape& shape, glm::dvec2 c, double radius,
                              std::vector<LeafEdge>& edges);

}  // namespace mien
