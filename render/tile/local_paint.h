#pragma once
// What a paint is like inside one square: its place t (or its distance) as a bilinear function,
// found from the square's corners and centre, and how far off that may be.
//
// Whole pixels take their distances from lattices of 8 × 8 pixels (distance_lattice.h) at absolute
// places of the picture, so they never depend on what else is drawn.

#include <mien/render/cover/arrangement.h>
#include <mien/render/tile/distance_lattice.h>
#include <mien/render/tile/tape.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace mien {

/// f(u) ≈ mean + x u.x + y u.y + xy u.x u.y for u in [−1/2, 1/2]².
struct Bilinear {
  double mean = 0, x = 0, y = 0, xy = 0;
  double residual =
      0;  ///< how far it is from f at the centre, at most xy/4 and what is not bilinear

  double at(glm::dvec2 u) const { return mean + x * u.x + y * u.y + xy * (u.x * u.y); }
  double reach() const {  ///< at most so far from the mean
    return 0.5 * (std::abs(x) + std::abs(y)) + 0.25 * std::abs(xy);
  }
};

/// From a function's values at a square's corners (by y, then x) and centre. Written so that a mirrored picture gives
/// exactly mirrored numbers. The mean is that of the quadratic through the five values: 2/3 of the centre and 1/3 of
/// the corners, since the corners are twice as far from it as the square's own second moment (1/4 + 1/4 against
/// 1/12 + 1/12, times 1/3).
Bilinear bilinear(const std::array<double, 4>& corners, double center);

/// A paint in a square.
struct LocalPaint {
  const TapePaint* paint;
  Blend blend;
  glm::dvec2 center;
  double side;
  Bilinear place;     ///< of the gradient
  Bilinear distance;  ///< of the relief

  /// The colour at a place of the square, u in [−1/2, 1/2]².
  Mix color(glm::dvec2 u) const;
  /// The relief's rise per pixel there: x right, y UP in the picture. Only with a relief.
  glm::dvec2 slope(glm::dvec2 u) const;
};

/// Makes local paints. One per thread.
class PaintSampler {
 public:
  PaintSampler(const Tape& tape) : tape_(tape), lattices_(tape.distances.size()) {}

  /// The paint in a square; of a whole pixel if side is 1.
  LocalPaint local(int paint, glm::dvec2 center, double side);

  /// How wrong the mean colour over the square, or over a part of it, may come out; appends the
  /// lines along which the colour has a kink or jump.
  double error(const LocalPaint& local, bool whole, std::vector<Cut>& cuts);

  /// The mean over a square, a whole pixel if side is 1; nothing where a gradient jumps, and for reliefs that
  /// follow an outline.
  struct Mean {
    Mix mix;
    Mix change{0.0};  ///< channels are at most so far from the mean
    Mix error{0.0};   ///< of the mean
    Mix bent{0.0};  ///< the same of the mean over a piece, beyond what a linear change makes it off
  };
  std::optional<Mean> mean(int paint, glm::dvec2 center, double side);

  /// Whether the relief's distance is too far from bilinear for its slope to mean anything.
  bool creased(const LocalPaint& local) const;

  /// The one colour that the paint has all over a disc, if so.
  std::optional<Mix> constant(int paint, glm::dvec2 center, double radius);

 private:
  Mean ramp_mean(const Ramp& ramp, const Bilinear& t, const Ramp::Range& range) const;
  Mean lit(const LocalPaint& local, const Mean& unlit) const;
  Bilinear distance_in(int distance, glm::dvec2 center, double side);
  Bilinear place_in(const PaintField& field, glm::dvec2 center, double side);

  const Tape& tape_;
  std::vector<DistanceLattice> lattices_;
  std::vector<double> kinks_;
};

}  // namespace mien
