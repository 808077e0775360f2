#pragma once
// Blink: from any pose to one shut curve.
//
// Both lid edges hang on the same two canthi, so an edge is known by one point, its bend, and mixing
// bends mixes edges. Upper u and lower l close by w towards where they meet,
//
//   m = u + s (l − u)        u' = u + w (m − u)        l' = l + w (m − l)
//
// and at w = 1 both ARE m: the gap's area is 0, whatever they were before and wherever they meet.
// The bias moves the meeting: s = 1, at the lower lid, for −1; the eye's own for 0; 0, at the upper
// lid, for +1; straight lines between.

#include <glm/vec2.hpp>

namespace mien {

/// The share s of the way from the upper to the lower lid; `meet` is that at bias 0.
constexpr double meeting_share(double bias, double meet) {
  return bias < 0 ? meet - bias * (1 - meet) : meet - bias * meet;
}

/// Two lids, by their bends (or by the coefficients of two parabolas).
struct LidPair {
  glm::dvec2 upper, lower;
  friend bool operator==(const LidPair&, const LidPair&) = default;
};

/// a at 0, b at 1, exactly.
constexpr glm::dvec2 mixed(glm::dvec2 a, glm::dvec2 b, double t) {
  return t == 1 ? b : a + t * (b - a);
}

/// Closed by `blink`, 0 … 1; at 0 the lids as they are, bit for bit.
constexpr LidPair blinked(const LidPair& lids, double blink, double share) {
  if (blink == 0) return lids;
  const glm::dvec2 meeting = mixed(lids.upper, lids.lower, share);
  return {mixed(lids.upper, meeting, blink), mixed(lids.lower, meeting, blink)};
}

/// Lids whose poses would cross, kept from crossing: the gap along `up` is at least 0, and lids that
/// come together do so along their whole length (the way between the bends across `up` is at most
/// kMostSlant gaps, so no sliver stays open at a canthus when the gap is 0). Apart lids keep every
/// bit.
LidPair uncrossed(const LidPair& lids, glm::dvec2 up, double share);

inline constexpr double kMostSlant = 4;

}  // namespace mien
