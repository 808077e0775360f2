#pragma once
// Numbers of 113 bits: what every distance in the laboratory is measured against.
//
// GCC's and Clang's binary128. Chosen over arbitrary precision (MPFR, cpp_bin_float) because the
// reference is asked ten million times: it is 20 to 60 times faster, and 113 bits leave 60 beyond a
// double's, more than any family of cases can cancel. reference_test.cpp checks it against 100
// decimal digits.

#include <cmath>

namespace mien::accuracy {

__extension__ typedef __float128 Quad;

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

/// The square root of x >= 0, to the last bit or two; x is first brought into long double's
/// comfort.
inline Quad square_root(Quad x) {
  if (!(x > 0)) return 0;
  Quad scale = 1;
  while (x > Quad(0x1p2000L)) x *= Quad(0x1p-2000L), scale *= Quad(0x1p1000L);
  while (x < Quad(0x1p-2000L)) x *= Quad(0x1p2000L), scale *= Quad(0x1p-1000L);
  Quad y = std::sqrt(static_cast<long double>(x));
  y = (y + x / y) / 2;
  return (y + x / y) / 2 * scale;
}

}  // namespace mien::accuracy
