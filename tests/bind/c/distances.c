#include <math.h>

#include "tests/bind/c/check.h"

enum { kCount = 37 };

static float xf[kCount], yf[kCount], df[kCount];
static double xd[kCount], yd[kCount], dd[kCount];

static void place_points(void) {
  int i;
  for (i = 0; i < kCount; ++i) xd[i] = xf[i] = (float)i / 8 - 2, yd[i] = yf[i] = (float)(i % 5) / 4;
}

/* All points are kinds of one segment from (0,0) to (1,0), with a half-width for strokes. */
static double to_segment(double x, double y) {
  return hypot(x - (x < 0 ? 0 : x > 1 ? 1 : x), y);
}

static void check_all(double half_width) {
  int i;
  for (i = 0; i < kCount; ++i) {
    const double true_distance = to_segment(xd[i], yd[i]) - half_width;
    CHECK(fabs(df[i] - true_distance) < 1e-5);
    CHECK(fabs(dd[i] - true_distance) < 1e-12);
  }
}

/* From (x, y) to y = (x - 0.5)^2, negative above it, by samples. */
static double to_parabola(double x, double y) {
  double nearest = 1e9, u;
  for (u = -4; u < 4; u += 1e-4) nearest = fmin(nearest, hypot(x - 0.5 - u, y - u * u));
  return y > (x - 0.5) * (x - 0.5) ? -nearest : nearest;
}

static void test_more_quads(const double* quad) {
  mien_error* error = NULL;
  double two[12] = {9, 9, 9, 9, 9, 9};
  float grid[kCount * 5];
  int i, j;
  for (i = 0; i < 6; ++i) two[6 + i] = quad[i];
  OK(mien_distances_quads_f32(two, 2, xf, yf, df, kCount, &error));
  check_all(0);
  OK(mien_distances_quad_accurate_f32(quad, xf, yf, df, kCount, &error));
  check_all(0);
  OK(mien_distances_quads_f32(NULL, 0, xf, yf, df, kCount, &error));
  CHECK(isinf(df[0]) && df[0] > 0);
  OK(mien_distances_quad_on_grid_f32(quad, -2, 0, 0.125, kCount, 5, grid, &error));
  for (j = 0; j < 5; ++j)
    for (i = 0; i < kCount; ++i)
      CHECK(fabs(grid[j * kCount + i] - to_segment(i * 0.125 - 2, j * 0.125)) < 1e-5);
}

static void test_values(void) {
  mien_error* error = NULL;
  const double quad[6] = {0, 0, 0.5, 0, 1, 0}, cubic[8] = {0, 0, 0.25, 0, 0.75, 0, 1, 0};
  const double tapered[9] = {0, 0, 0.5, 0, 1, 0, 0.25, 0.25, 0.25};
  const double disc[6] = {0, 0, 2, 2, 0, 3}, parabola[5] = {0.5, 0, 0, 2, 1};
  int i;
  OK(mien_distances_quad_f32(quad, xf, yf, df, kCount, &error));
  OK(mien_distances_quad_f64(quad, xd, yd, dd, kCount, &error));
  check_all(0);
  OK(mien_distances_cubic_f32(cubic, xf, yf, df, kCount, &error));
  OK(mien_distances_cubic_f64(cubic, xd, yd, dd, kCount, &error));
  check_all(0);
  test_more_quads(quad);
  OK(mien_distances_tapered_f32(tapered, xf, yf, df, kCount, &error));
  OK(mien_distances_tapered_f64(tapered, xd, yd, dd, kCount, &error));
  check_all(0.25);
  OK(mien_distances_ellipse_f32(disc, xf, yf, df, kCount, &error));
  OK(mien_distances_ellipse_f64(disc, xd, yd, dd, kCount, &error));
  for (i = 0; i < kCount; ++i) {
    CHECK(fabs(df[i] - (hypot(xd[i], yd[i]) - 2)) < 1e-5);
    CHECK(fabs(dd[i] - (hypot(xd[i], yd[i]) - 2)) < 1e-12);
  }
  OK(mien_distances_parabola_f32(parabola, xf, yf, df, kCount, &error));
  OK(mien_distances_parabola_f64(parabola, xd, yd, dd, kCount, &error));
  for (i = 0; i < kCount; ++i) {
    CHECK(fabs(df[i] - to_parabola(xd[i], yd[i])) < 1e-3);
    CHECK(fabs(dd[i] - to_parabola(xd[i], yd[i])) < 1e-3);
  }
  OK(mien_distances_quad_f64(quad, xd, yd, xd, kCount, &error)); /* in place */
  CHECK(xd[0] == 2);
  xd[0] = NAN;
  OK(mien_distances_quad_f64(quad, xd, yd, dd, 1, &error));
  CHECK(isinf(dd[0]) && dd[0] > 0);
}

static void test_misuse(void) {
  mien_error* error = NULL;
  double curve[9] = {0, 0, 1, 1, 1, 0, 1, 1, 1};
  OK(mien_distances_quad_f32(curve, NULL, NULL, NULL, 0, &error));
  FAILS(MIEN_MISUSE, "curve", mien_distances_quad_f32(NULL, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "curve", mien_distances_cubic_f64(NULL, xd, yd, dd, 1, &error));
  FAILS(MIEN_MISUSE, "x: is", mien_distances_quad_f32(curve, NULL, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "y: is", mien_distances_quad_f64(curve, xd, NULL, dd, 1, &error));
  FAILS(MIEN_MISUSE, "d: is", mien_distances_cubic_f32(curve, xf, yf, NULL, 1, &error));
  FAILS(MIEN_MISUSE, "count", mien_distances_quad_f32(curve, xf, yf, df, (size_t)-1, &error));
  curve[4] = curve[5] = 0;
  FAILS(MIEN_REFUSED, "direction", mien_distances_ellipse_f32(curve, xf, yf, df, 1, &error));
  curve[4] = 1, curve[2] = -1;
  FAILS(MIEN_REFUSED, "negative", mien_distances_ellipse_f64(curve, xd, yd, dd, 1, &error));
  curve[8] = -1;
  FAILS(MIEN_REFUSED, "negative", mien_distances_tapered_f32(curve, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "stroke", mien_distances_tapered_f64(NULL, xd, yd, dd, 1, &error));
  curve[2] = curve[3] = 0;
  FAILS(MIEN_REFUSED, "axis", mien_distances_parabola_f32(curve, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "side", mien_distances_parabola_f64(NULL, xd, yd, dd, 1, &error));
  FAILS(MIEN_MISUSE, "curve", mien_distances_quad_accurate_f32(NULL, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "curves", mien_distances_quads_f32(NULL, 1, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "count", mien_distances_quads_f32(curve, (size_t)-1, xf, yf, df, 1, &error));
  FAILS(MIEN_MISUSE, "d: is", mien_distances_quads_f32(curve, 1, xf, yf, NULL, 1, &error));
  OK(mien_distances_quad_on_grid_f32(curve, 0, 0, 1, 0, 9, NULL, &error));
  FAILS(MIEN_MISUSE, "d: is", mien_distances_quad_on_grid_f32(curve, 0, 0, 1, 1, 1, NULL, &error));
  FAILS(MIEN_MISUSE, "rows",
        mien_distances_quad_on_grid_f32(curve, 0, 0, 1, 99, (size_t)-1, df, &error));
  FAILS(MIEN_MISUSE, "curve", mien_distances_quad_on_grid_f32(NULL, 0, 0, 1, 1, 1, df, &error));
}

void test_distances(void) {
  place_points();
  test_values();
  test_misuse();
}
