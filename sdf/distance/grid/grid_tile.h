#pragma once
// A tile of a grid of points beside a quadratic Bézier: proof of where all its points have their foot on the curve,
// and how to get there from the tile's middle in one or two steps. Derivation: docs/derivations/grid_tiles.md.

#include "sdf/distance/quad_bezier/quad_bezier_frame.h"

#include <glm/vec2.hpp>

namespace mien::batch {

/// What is proven about all points of a tile.
struct GridTile {
  enum class How {
    multiplied,  ///< the start below and one Newton step, with a series for its division, give the foot
    one_step,   ///< … and one Newton step
    two_steps,  ///< … and two
    end,        ///< the foot of all of them is the end t
    uncertain   ///< nothing
  };
  How how = How::uncertain;
  /// The foot of the middle, and the start's two linear forms of the offset e from the middle: with
  /// w = (wx, wy)·e and z = (zx, zy)·e the foot is near t + w + w z.
  double t = 0, wx = 0, wy = 0, zx = 0, zy = 0;
  double inverse = 0;  ///< 1 / (second derivative of |B(t) − p|²) at the middle's foot
};

/// What a curve's certificates have in common, scaled.
struct TileFacts {
  glm::dvec2 a, b;
  double bb, b_length, turn;  ///< turn: where |B'| is least on [0, 1]
  double p_change, s_change;  ///< of P and S2 per length
};

/// Certifies one tile after another. The search for a tile's foot begins at the previous tile's, which changes the
/// time it takes and the last digits of t, never what is proven.
class TileCertifier {
 public:
  /// `frame` must outlive the certifier; coordinates below are its scaled ones.
  explicit TileCertifier(const QuadBezierFrame<double>& frame);

  const TileFacts& facts() const { return c_; }

  /// All points within `reach` of `middle`.
  GridTile certify(glm::dvec2 middle, double reach);

  /// How far the curve's point may be off at a certified foot [scaled]: a quarter of the fast kernel's smallest
  /// unit of error.
  static constexpr double kTolerance = 0x1p-26;
  /// Tiles with a point farther away than this are left to the fast kernel, which is more careful there.
  static constexpr double kClose = 2;

 private:
  struct At;
  struct Branch;
  At at(glm::dvec2 d, double t) const;
  bool convex(glm::dvec2 d, double reach) const;
  glm::dvec2 offset_to(glm::dvec2 p) const;
  GridTile nearest_branch(glm::dvec2 d, glm::dvec2 middle, double reach);
  bool one_sided(glm::dvec2 d, double reach) const;
  double p(glm::dvec2 d) const;
  double main_root(glm::dvec2 d) const;
  bool settle(glm::dvec2 d, double& t) const;
  Branch branch(glm::dvec2 d, double reach, double t) const;
  GridTile followed(const Branch& b, double reach) const;
  GridTile beyond_an_end(glm::dvec2 d, double reach, const Branch& main) const;

  const QuadBezierFrame<double>& f_;
  TileFacts c_;
  glm::dvec2 last_middle_{0, 0}, last_w_{0, 0};
  double last_t_ = 0.5;
};

}  // namespace mien::batch
