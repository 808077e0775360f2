#pragma once
// A hand that draws: every place of the plane a little beside itself, every line a little thicker or thinner, in a way that is
// the person's own.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>

namespace mien {

/// Derivation.  A place p moves by amplitude · (Σ a_k sin(f_k · p + φ_k)) in x and in y: six plane waves whose directions and
///              phases are the person's, 0.7 to 2.6 of them to a face width. What lies together stays together, so clips
///              fit and what touches goes on touching; the slope is below 2π · 2.6 · amplitude, far from a fold.
/// Error.       No place moves farther than `amplitude` in x or in y. The same bits on every machine.
class Hand {
 public:
  /// `amplitude` [face widths]; `width`: the share by which a line is thicker or thinner at most, below 1.
  Hand(std::uint64_t person, double amplitude, double width);

  glm::dvec2 moved(glm::dvec2 p) const;
  /// What the half-width of a line's place number `at` is multiplied by.
  double thickness(std::string_view line, int at) const;

 private:
  struct Wave {
    glm::dvec2 turns;      ///< [degrees] per face width
    double phase, weight;  ///< [degrees], share of the amplitude
  };
  static constexpr int kWaves = 6;
  std::array<std::array<Wave, kWaves>, 2> waves_;
  std::uint64_t person_;
  double amplitude_, width_;
};

}  // namespace mien
