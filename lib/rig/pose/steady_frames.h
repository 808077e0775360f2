#pragma once
// Faces that follow a camera live, and do not tremble: the 1€ filter.
//
// Each number goes through a low-pass filter of first order, whose cutoff f grows with the number's own speed: a face that
// rests is quiet, and one that moves is not late. With the time T since the last frame,
//
//   x̂ = α(f) x + (1 − α(f)) x̂₋₁        α(f) = 1/(1 + 1/(2π f T))        f = cutoff + beta |ẋ|
//
// where ẋ, the speed as a share of the number's range per second, is filtered alike with f = 1 Hz.
//
// Source: G. Casiez, N. Roussel, D. Vogel, "1€ filter: a simple speed-based low-pass filter for noisy input in interactive
// systems", CHI 2012.

#include <mien/api.h>
#include <mien/face.h>
#include <mien/pose.h>

#include <unordered_map>
#include <vector>

namespace mien {

struct Steadiness {
  double cutoff = 1;  ///< [Hz] above 0: lower is quieter, and later where little moves
  double beta = 2;    ///< 0 or above: higher is less late where much moves
};

/// Frames as they come, one face each.
class SteadyFrames {
 public:
  /// Numbers that are not finite or out of range count as the default ones.
  MIEN_API explicit SteadyFrames(const Steadiness& steadiness = {});

  /// The settings of a frame (settings_at) at its moment [s], with quiet numbers. After a second without frames, or where time
  /// does not go on, it begins again: the frame stays as it is.
  MIEN_API std::vector<Setting> steadied(const Face& face, std::vector<Setting> settings,
                                         double time);

 private:
  struct Number {
    double seen, value, speed;
  };
  double step(Number& number, double seen, double range, double gap) const;

  Steadiness steadiness_;
  double time_ = 0;
  std::unordered_map<int, Number> numbers_;  ///< by control
};

}  // namespace mien
