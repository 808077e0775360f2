#pragma once
// Closing: from any pose to one closed curve.
//
// Both inner edges end at the same two corners, so each is given by its bends, and mixing bends mixes edges. An upper
// bend u and the lower bend l below it close by c towards the seam at the share s of the way from u to l,
//
//   m = (1 − s) u + s l        u' = (1 − c) u + c m        l' = (1 − c) l + c m
//
// At c = 1 both are m, bit for bit: the area between the lips is 0, whatever jaw, muscles and head have done before.
// (u + c (m − u) would miss m in one of 500 roundings.)

#include <glm/vec2.hpp>

namespace mien {

/// A bend of the upper edge and the one below it, with y up.
struct LipPair {
  glm::dvec2 upper, lower;
  friend bool operator==(const LipPair&, const LipPair&) = default;
};

/// Closed by `closure`, 0 … 1; at 0 the lips as they are, bit for bit.
constexpr LipPair closed(const LipPair& lips, double closure, double seam) {
  if (closure == 0) return lips;
  const glm::dvec2 meeting = (1 - seam) * lips.upper + seam * lips.lower;
  return {(1 - closure) * lips.upper + closure * meeting,
          (1 - closure) * lips.lower + closure * meeting};
}

/// Lips that have crossed touch halfway.
constexpr LipPair uncrossed(const LipPair& lips) {
  if (lips.lower.y <= lips.upper.y) return lips;
  const glm::dvec2 meeting = 0.5 * (lips.upper + lips.lower);
  return {meeting, meeting};
}

}  // namespace mien
