#pragma once
// Directions and angles in degrees, with the same bits on every machine.
//
// IEEE 754 fixes + − × ÷, square roots and remainders; sines and arctangents it leaves to each C library, whose last bits
// differ. The face of a code must not depend on them, so these are sums and products alone. Files that use them are
// compiled without fused operations, as all of mien is.

#include <glm/vec2.hpp>

namespace mien {

/// (cos, sin) of an angle.
/// Derivation.  The angle is brought to −45° … 45° from a quarter turn; remainders are exact. There Taylor's series of
///              nine and eight terms leave out less than 2e-19.
/// Error.       Below 3e-16; quarter turns are exact.
/// Source.      Derived here; checked against the C library in tests/lib/math/degrees_test.cpp.
glm::dvec2 direction_at(double degrees);

/// The angle of a direction, −180 … 180; 0 for no direction. Its length does not count.
/// Derivation.  θ ← θ + asin((y cos θ − x sin θ) / r), from the middle of an eighth of a turn. asin s ≈ s + s³/6 leaves
///              out 3/40 s⁵: from 22.5° three steps are enough.
/// Error.       Below 1e-13 degrees.
/// Source.      As above.
double degrees_of(glm::dvec2 direction);

}  // namespace mien
