#pragma once
// The colours of a gradient along its place t, in the space the picture is blended in.

#include <mien/paint.h>
#include "render/blend/blender.h"

#include <vector>

namespace mien {

/// Piecewise linear in t, premultiplied, with the gradient's extension beyond its ends. A ramp of
/// no length (all stops at one place) is its last colour from there on and its first before.
class Ramp {
 public:
  /// `opacity` multiplies that of every stop. No stops: transparent.
  Ramp(const Gradient& gradient, double opacity, Blend blend) { make(gradient, opacity, blend); }

  /// Made again; memory is kept.
  void make(const Gradient& gradient, double opacity, Blend blend);

  /// Ends its repetition: as if it went on in the colours of its ends.
  void pad();

  Mix color(double t) const;

  /// For the form in lanes: the stops' places, which do not fall, and their colours.
  const std::vector<double>& at() const { return at_; }
  const std::vector<Mix>& mixes() const { return mix_; }
  Extend extend() const { return extend_; }

  /// Whether the colour changes suddenly anywhere.
  bool jumps() const { return jumps_; }

  /// The least and the largest opacity anywhere.
  double least_opacity() const { return least_opacity_; }
  double most_opacity() const { return most_opacity_; }

  /// The most that a channel changes by per t between two stops.
  double steepest() const;

  /// Writes the places between lo and hi where the colour has a kink or a jump, rising; false where
  /// there are more than `most` (then those alone where a padded ramp begins and ends).
  bool kinks(double lo, double hi, int most, std::vector<double>& to) const;

  /// Whether a stretch lies beyond the ends of a padded ramp, where it has one colour.
  bool beyond(double from, double to) const {
    const double first = at_.front();
    return extend_ == Extend::pad && (to <= first || from >= first + (at_.back() - first));
  }

 private:
  void add_kinks(double begin, bool backward, double lo, double hi,
                 std::vector<double>& kinks) const;

  std::vector<double> at_;
  std::vector<Mix> mix_;
  Extend extend_ = Extend::pad;
  double least_opacity_ = 1, most_opacity_ = 0;
  bool jumps_ = false;
};

}  // namespace mien
