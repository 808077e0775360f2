#pragma once
// A layer's lit paint point by point, in double precision and by definition: what the means of
// LitPaint are means of.
//
// The relief's profile has kinks at a few depths. Between two of them, in a *zone*, it is smooth;
// asked for beyond its zone, a zone's profile goes on as it was.

#include "render/shade/paint.h"

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace mien {

/// Where a lit paint is smooth: in a zone of its profile and, if it has a ramp, between two kinks of that. Beyond
/// them it goes on smoothly, so a square around a cell never sees what lies beyond a jump.
struct LitPiece {
  int zone;
  const RampSegment* segment;  ///< none: the whole ramp
  LitPiece(int of_zone, const RampSegment* between = nullptr) : zone(of_zone), segment(between) {}
};

/// Refers to the paint and the distances it is made of. Coordinates: the whole picture's pixels,
/// origin top left, y down.
class LitSurface {
 public:
  /// `center`: where the paint's own origin lies.
  LitSurface(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
             glm::dvec2 center) {
    make(paint, distances, blend, center);
  }
  LitSurface() = default;

  /// Made anew; memory is kept.
  void make(const GridPaint& paint, std::span<const AreaDistance> distances, Blend blend,
            glm::dvec2 center);

  /// Depths (signed distances, falling from 0) where the profile has a kink; none: one zone.
  std::span<const double> levels() const { return levels_; }
  int zones() const { return int(levels_.size()) + 1; }
  /// Zone 0 is outside, zone k between levels k − 1 and k, the last one beyond the last level.
  int zone_of(double d) const;
  /// The same where what is painted is inside, and only a rounding of its distance says otherwise: a hundredth of a pixel
  /// beyond the layer's own outline, a hundredth of that beyond another, where colours change.
  int zone_inside(double d) const;
  /// Whether the profile does not rise there.
  bool flat(int zone) const;

  Outward outward(glm::dvec2 p) const;
  /// By what of the area's tree decides near p.
  Outward outward(glm::dvec2 p, std::span<const Node> nodes) const;
  /// The profile's rise per pixel.
  double rise(int zone, double depth) const;
  /// Whether a highlight that shows may lie within `reach` of p, so narrow that a few places do not see it: near a round
  /// profile's outline, or at a steep dome's foot, it may be a hundredth of a pixel wide.
  bool highlight_hides(int zone, glm::dvec2 p, const Outward& at, double reach) const;
  /// Rise per pixel at p: x right, y UP in the picture.
  glm::dvec2 slope(int zone, glm::dvec2 p, const Outward& outward) const;
  /// Premultiplied, in the blending space.
  Mix color(const LitPiece& piece, glm::dvec2 p, const Outward& outward) const;

  const GridPaint& paint() const { return *paint_; }
  const GridRelief& relief() const { return *paint_->relief; }
  const AreaDistance* area() const { return area_; }
  /// The area that its gradient goes by; null if it does not go by a distance.
  const AreaDistance* gradient_area() const { return gradient_area_; }
  Blend blend() const { return blend_; }
  glm::dvec2 center() const { return center_; }

 private:
  Mix base(const LitPiece& piece, glm::dvec2 p, double d) const;
  double turns_by(int zone, glm::dvec2 p, const Outward& at, double reach) const;

  const GridPaint* paint_ = nullptr;
  const AreaDistance *area_ = nullptr, *gradient_area_ = nullptr;
  Blend blend_ = Blend::linear;
  glm::dvec2 center_{0.0};
  std::vector<double> levels_;
  std::vector<double> rises_;  ///< of a table, by step
};

}  // namespace mien
