#pragma once
// Numbers of 113 bits: what every distance in the laboratory is measured against.
//
// GCC's and Clang's binary128 is the compiler's own arithmetic, fast enough for ten million questions. It
// has 60 bits more than a double, which is more than any family of cases can cancel.
// tests/tools/accuracy/reference_test.cpp checks what is built on it against 100 decimal digits.

#include <cmath>

namespace mien::accuracy {

__extension__ typedef __float128 Quad;

inline Quad magnitude(Quad x) {
  return x < 0 ? -x : x;
}

/// The square root of x >= 0, to the last bit or two; x is first scaled into the range of long double.
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
