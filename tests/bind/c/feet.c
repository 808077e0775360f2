#include <math.h>

#include "tests/bind/c/check.h"

enum { kPlaces = 9 };

static double px[kPlaces], py[kPlaces], t[2][kPlaces], d[2][kPlaces], nx[2][kPlaces],
    ny[2][kPlaces], bend[2][kPlaces];
static int32_t piece[2][kPlaces];
static mien_feet feet[2];

static void make_ready(void) {
  int i;
  for (i = 0; i < kPlaces; ++i) px[i] = 0.25 * i + 0.1, py[i] = 0.5;
  for (i = 0; i < 2; ++i) {
    mien_feet_init(&feet[i], sizeof feet[i]);
    CHECK(feet[i].size == sizeof feet[i] && !feet[i].piece && !feet[i].bend);
    feet[i].piece = piece[i], feet[i].t = t[i], feet[i].distance = d[i];
    feet[i].normal_x = nx[i], feet[i].normal_y = ny[i], feet[i].bend = bend[i];
  }
}

/* Two level segments, 0 ... 2 at heights 0 and 2, with a half-width. */
static void check_level(double half_width) {
  int i;
  for (i = 0; i < kPlaces; ++i) {
    const double beyond = px[i] > 2 ? px[i] - 2 : 0;
    CHECK(piece[0][i] == 0 && piece[1][i] == 1);
    CHECK(fabs(d[0][i] - (hypot(beyond, 0.5) - half_width)) < 1e-14);
    CHECK(fabs(d[1][i] - (hypot(beyond, 1.5) - half_width)) < 1e-14);
    CHECK(fabs(t[0][i] - (beyond > 0 ? 1 : px[i] / 2)) < 1e-14);
    CHECK(fabs(nx[0][i] * 0.5 - ny[0][i] * beyond) < 1e-14 && ny[0][i] > 0 && ny[1][i] < 0);
    CHECK(fabs(bend[1][i] - (beyond > 0 ? 1 / hypot(beyond, 1.5) : 0)) < 1e-14);
  }
}

static void test_feet_values(void) {
  mien_error* error = NULL;
  const double quads[12] = {0, 0, 1, 0, 2, 0, 0, 2, 1, 2, 2, 2};
  const double lines[10] = {0, 0, 2, 0, 0.25, 0, 2, 2, 2, 0.25};
  const double tapered[18] = {0, 0, 1, 0, 2, 0, 0.25, 0.25, 0.25,
                              0, 2, 1, 2, 2, 2, 0.25, 0.25, 0.25};
  const double ellipse[6] = {0, 0, 2, 1, 3, 0};
  OK(mien_feet_quads_f64(quads, 2, px, py, kPlaces, &feet[0], &feet[1], &error));
  check_level(0);
  OK(mien_feet_lines_f64(lines, 2, px, py, kPlaces, &feet[0], &feet[1], &error));
  check_level(0.25);
  OK(mien_feet_tapered_f64(tapered, 2, px, py, kPlaces, &feet[0], &feet[1], &error));
  check_level(0.25);
  px[0] = 0, py[0] = 0.25;
  OK(mien_feet_ellipse_f64(ellipse, px, py, 1, &feet[0], &feet[1], &error));
  CHECK(fabs(d[0][0] + 0.75) < 1e-15 && fabs(d[1][0] + 1.25) < 1e-15);
  CHECK(fabs(t[0][0] + t[1][0]) < 1e-15 && fabs(ny[0][0] - 1) < 1e-15);
  OK(mien_feet_quads_f64(quads, 1, px, py, kPlaces, &feet[0], &feet[1], &error));
  CHECK(piece[1][0] == -1 && isinf(d[1][0]) && d[1][0] > 0 && nx[1][0] == 0);
  OK(mien_feet_quads_f64(NULL, 0, px, py, 1, &feet[0], NULL, &error));
  CHECK(piece[0][0] == -1 && isinf(d[0][0]));
  px[0] = NAN;
  OK(mien_feet_quads_f64(quads, 2, px, py, 1, &feet[0], &feet[1], &error));
  CHECK(piece[0][0] == -1 && piece[1][0] == -1);
}

static void test_feet_misuse(void) {
  mien_error* error = NULL;
  double numbers[9] = {0, 0, 1, 1, -1, 0, 1, 1, -1};
  mien_feet only = feet[0], wrong = feet[0];
  only.piece = NULL, only.t = only.normal_x = only.normal_y = only.bend = NULL;
  px[0] = 0, d[0][0] = d[1][0] = 7;
  OK(mien_feet_quads_f64(numbers, 1, px, py, 1, &only, NULL, &error));
  CHECK(d[0][0] != 7 && d[1][0] == 7);
  OK(mien_feet_quads_f64(numbers, 1, NULL, NULL, 0, NULL, NULL, &error));
  wrong.size = 1;
  FAILS(MIEN_MISUSE, "next", mien_feet_quads_f64(numbers, 1, px, py, 1, NULL, &wrong, &error));
  FAILS(MIEN_MISUSE, "curves: is", mien_feet_quads_f64(NULL, 1, px, py, 1, &only, NULL, &error));
  FAILS(MIEN_MISUSE, "x: is", mien_feet_lines_f64(numbers, 0, NULL, py, 1, &only, NULL, &error));
  FAILS(MIEN_MISUSE, "count",
        mien_feet_quads_f64(numbers, 1, px, py, (size_t)-1, &only, NULL, &error));
  FAILS(MIEN_MISUSE, "lines",
        mien_feet_lines_f64(numbers, (size_t)-1, px, py, 1, &only, NULL, &error));
  FAILS(MIEN_REFUSED, "negative", mien_feet_lines_f64(numbers, 1, px, py, 1, &only, NULL, &error));
  FAILS(MIEN_REFUSED, "negative",
        mien_feet_tapered_f64(numbers, 1, px, py, 1, &only, NULL, &error));
  numbers[4] = numbers[5] = 0;
  FAILS(MIEN_REFUSED, "direction", mien_feet_ellipse_f64(numbers, px, py, 1, &only, NULL, &error));
  FAILS(MIEN_MISUSE, "ellipse", mien_feet_ellipse_f64(NULL, px, py, 1, &only, NULL, &error));
}

void test_feet(void) {
  make_ready();
  test_feet_values();
  test_feet_misuse();
}
