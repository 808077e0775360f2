#pragma once
// Blink: from any pose to one closed curve.
//
// Both lid edges end at the same two canthi, so each is given by one point, its bend, and interpolating
// bends interpolates edges. The upper bend u and the lower bend l close by w towards where they meet,
//
//   m = u + s (l − u)        u' = u + w (m − u)        l' = l + w (m − l)
//
// and at w = 1 both are exactly m: the area of the gap is 0, whatever they were before and wherever they
// meet. The bias moves the meeting point: s is 1, at the lower lid, for a bias of −1; the eye's own for 0;
// 0, at the upper lid, for +1; and linear in between.

#include <glm/vec2.hpp>

namespace mien {

/// The share s of the way from the upper to the lower lid; `meet` is its value at bias 0.
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

/// Keeps lids from crossing: afterwards the gap along `up` is at least 0, and lids that come together do so
/// along their whole length (across `up` the bends are at most kMostSlant gaps apart, so no sliver stays
/// open at a canthus when the gap is 0). Lids that are far enough apart keep every bit.
LidPair uncrossed(const LidPair& lids, glm::dvec2 up, double share);

inline constexpr double kMostSlant = 4;

}  // namespace mien
