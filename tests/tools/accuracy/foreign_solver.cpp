// A solver as others would write it: 64 samples of the curve, and not a number for straight ones. Built
// as a shared library for solver_test.cpp.

#include <cmath>
#include <cstddef>

extern "C" void mien_accuracy_solve(const double* curve, const double* x, const double* y,
                                    double* distance, std::size_t count) {
  const double* c = curve;
  const bool is_straight = (c[2] - c[0]) * (c[5] - c[1]) == (c[3] - c[1]) * (c[4] - c[0]);
  for (std::size_t i = 0; i < count; ++i) {
    double least = is_straight ? NAN : HUGE_VAL;
    for (int k = 0; k <= 64; ++k) {
      const double t = k / 64.0, s = 1 - t;
      const double qx = s * s * c[0] + 2 * s * t * c[2] + t * t * c[4] - x[i];
      const double d = std::hypot(qx, s * s * c[1] + 2 * s * t * c[3] + t * t * c[5] - y[i]);
      if (d < least) least = d;
    }
    distance[i] = least;
  }
}

/// The nearest sample as the nearest foot, and no other.
extern "C" void mien_accuracy_feet(const double* curve, const double* x, const double* y,
                                   double* feet, std::size_t count) {
  const double* c = curve;
  for (std::size_t i = 0; i < count; ++i) {
    double* f = feet + 10 * i;
    f[1] = f[6] = HUGE_VAL;
    for (int k = 0; k <= 64; ++k) {
      const double t = k / 64.0, s = 1 - t;
      const double qx = x[i] - (s * s * c[0] + 2 * s * t * c[2] + t * t * c[4]);
      const double qy = y[i] - (s * s * c[1] + 2 * s * t * c[3] + t * t * c[5]);
      const double d = std::hypot(qx, qy);
      if (d < f[1]) f[0] = t, f[1] = d, f[2] = qx / d, f[3] = qy / d, f[4] = 0;
    }
  }
}
