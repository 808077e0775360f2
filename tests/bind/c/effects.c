#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

enum { kWide = 120, kHigh = 70, kPixels = kWide * kHigh };

static mien_view wide_view(void) {
  mien_view view;
  mien_view_init(&view, sizeof view);
  view.width = kWide, view.height = kHigh;
  return view;
}

static mien_pixels floats_in(float* data, int32_t width, int32_t height) {
  mien_pixels pixels;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.depth = MIEN_F32, pixels.data = data;
  pixels.stride = (size_t)width * 16, pixels.bytes = pixels.stride * (size_t)height;
  return pixels;
}

static mien_pixels bytes_in(unsigned char* data, int32_t width, int32_t height) {
  mien_pixels pixels;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = data, pixels.stride = (size_t)width * 4;
  pixels.bytes = pixels.stride * (size_t)height;
  return pixels;
}

static mien_effects* effects_of(const char* one, const char* other) {
  mien_error* error = NULL;
  mien_effects* effects = NULL;
  OK(mien_effects_new(&effects, &error));
  CHECK(mien_effects_count(effects) == 0);
  if (one) OK(mien_effects_add(effects, one, END, &error));
  if (other) OK(mien_effects_add(effects, other, END, &error));
  CHECK(mien_effects_count(effects) == (one != NULL) + (other != NULL));
  return effects;
}

/* Keeps the most that is told. */
static int32_t keep_most(double done, void* data) {
  double* most = data;
  if (!(done <= *most)) *most = done;
  return 0;
}

static int32_t stop(double done, void* data) {
  (void)done, (void)data;
  return 1;
}

/* Effects that change nothing are as if they were not there, at 8 bits too. */
static void test_idle(mien_renderer* renderer, const mien_scene* scene, const mien_view* view) {
  mien_error* error = NULL;
  unsigned char *plain = malloc(kPixels * 4), *with = malloc(kPixels * 4);
  mien_pixels from = bytes_in(plain, kWide, kHigh), to = bytes_in(with, kWide, kHigh);
  mien_effects* idle = effects_of("mosaic:120", "grid:7,0");
  OK(mien_render(renderer, scene, view, &from, NULL, &error));
  OK(mien_render_with_effects(renderer, scene, view, idle, &to, NULL, &error));
  CHECK(memcmp(plain, with, kPixels * 4) == 0);
  mien_effects_free(idle), free(plain), free(with);
}

/* Drawn with effects is drawn, and then the effects; in parts, too. */
static void test_drawn(mien_renderer* renderer, const mien_scene* scene) {
  mien_error* error = NULL;
  float *plain = malloc(kPixels * 16), *with = malloc(kPixels * 16), *by = malloc(kPixels * 16);
  unsigned char *bytes = malloc(kPixels * 4), *part = malloc(kPixels * 4);
  mien_pixels from = floats_in(plain, kWide, kHigh), to = floats_in(with, kWide, kHigh);
  mien_pixels in_bytes = bytes_in(bytes, kWide, kHigh), some = bytes_in(part, 31, 20);
  mien_view view = wide_view();
  mien_effects *effects = effects_of("mosaic:10,0.3", "grid:7"), *none = effects_of(NULL, NULL);
  mien_render_options options;
  mien_render_stats stats;
  int y;
  OK(mien_render(renderer, scene, &view, &from, NULL, &error));
  OK(mien_apply_effects(effects, &from, &to, kWide, kHigh, &error));
  CHECK(memcmp(plain, with, kPixels * 16) != 0);
  to = floats_in(by, kWide, kHigh);
  OK(mien_render_with_effects(renderer, scene, &view, effects, &to, NULL, &error));
  CHECK(memcmp(with, by, kPixels * 16) == 0);
  stats.size = sizeof stats;
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.pixels == kPixels);
  OK(mien_render_with_effects(renderer, scene, &view, none, &to, NULL, &error));
  CHECK(memcmp(plain, by, kPixels * 16) == 0);
  test_idle(renderer, scene, &view);

  OK(mien_render_with_effects(renderer, scene, &view, effects, &in_bytes, NULL, &error));
  view.has_region = 1;
  view.region[0] = 70, view.region[1] = 33, view.region[2] = 31, view.region[3] = 20;
  OK(mien_render_with_effects(renderer, scene, &view, effects, &some, NULL, &error));
  for (y = 0; y < 20; ++y)
    CHECK(memcmp(part + y * 31 * 4, bytes + ((y + 33) * kWide + 70) * 4, 31 * 4) == 0);

  mien_render_options_init(&options, sizeof options);
  options.progress = stop;
  FAILS(MIEN_CANCELLED, NULL,
        mien_render_with_effects(renderer, scene, &view, effects, &some, &options, &error));
  view.region[0] = 1000;
  FAILS(MIEN_REFUSED, "region",
        mien_render_with_effects(renderer, scene, &view, effects, &some, NULL, &error));
  view = wide_view(), view.width = 9, some = bytes_in(part, 9, kHigh);
  FAILS(MIEN_REFUSED, "10 tiles",
        mien_render_with_effects(renderer, scene, &view, effects, &some, NULL, &error));
  FAILS(MIEN_MISUSE, "effects",
        mien_render_with_effects(renderer, scene, &view, NULL, &some, NULL, &error));
  FAILS(MIEN_MISUSE, "renderer",
        mien_render_with_effects(NULL, scene, &view, effects, &some, NULL, &error));
  FAILS(MIEN_MISUSE, "scene",
        mien_render_with_effects(renderer, NULL, &view, effects, &some, NULL, &error));
  FAILS(MIEN_MISUSE, "pixels",
        mien_render_with_effects(renderer, scene, &view, effects, NULL, NULL, &error));
  mien_effects_free(effects), mien_effects_free(none);
  free(plain), free(with), free(by), free(bytes), free(part);
}

/* Rows above a region are drawn too, and a strip goes on below it: progress ends at 1 nevertheless. */
static void test_progress(mien_renderer* renderer, const mien_scene* scene) {
  mien_error* error = NULL;
  unsigned char part[kWide * 4 * 4];
  mien_pixels some = bytes_in(part, kWide, 4);
  mien_view view = wide_view();
  mien_effects* effects = effects_of("grid:7", NULL);
  mien_render_options options;
  double most = 0;
  mien_render_options_init(&options, sizeof options);
  options.progress = keep_most, options.progress_data = &most;
  view.has_region = 1;
  view.region[0] = 0, view.region[1] = 6, view.region[2] = kWide, view.region[3] = 4;
  OK(mien_render_with_effects(renderer, scene, &view, effects, &some, &options, &error));
  CHECK(most > 0.5 && most <= 1);
  mien_effects_free(effects);
}

/* A mosaic of one tile is the mean of a picture. */
static void test_own_picture(void) {
  mien_error* error = NULL;
  float from[4 * 4] = {0, 0, 0, 1, 1, 0, 0, 1, 0, 0.5F, 0, 1, 0, 0.5F, 0, 1}, to[4 * 4];
  unsigned char bytes[4 * 4];
  mien_pixels in = floats_in(from, 2, 2), out = floats_in(to, 2, 2),
              rounded = bytes_in(bytes, 2, 2);
  mien_effects *one = effects_of("mosaic:1", NULL), *three = effects_of("mosaic:3", NULL);
  OK(mien_apply_effects(one, &in, &out, 2, 2, &error));
  CHECK(fabs(to[0] - 0.25) < 1e-6 && fabs(to[13] - 0.25) < 1e-6 && to[3] == 1);
  OK(mien_apply_effects(one, &in, &rounded, 2, 2, &error));
  CHECK(bytes[0] == 137 && bytes[3] == 255); /* 0.25 of light, encoded */
  FAILS(MIEN_REFUSED, "tiles", mien_apply_effects(three, &in, &out, 2, 2, &error));
  FAILS(MIEN_MISUSE, "from", mien_apply_effects(one, &in, &in, 2, 2, &error));
  FAILS(MIEN_MISUSE, "F32", mien_apply_effects(one, &rounded, &out, 2, 2, &error));
  FAILS(MIEN_MISUSE, "bytes", mien_apply_effects(one, &in, &out, 2, 3, &error));
  FAILS(MIEN_REFUSED, "sides", mien_apply_effects(one, &in, &out, 0, 2, &error));
  FAILS(MIEN_MISUSE, "NULL", mien_apply_effects(one, NULL, &out, 2, 2, &error));
  FAILS(MIEN_MISUSE, "NULL", mien_apply_effects(one, &in, NULL, 2, 2, &error));
  FAILS(MIEN_MISUSE, "effects", mien_apply_effects(NULL, &in, &out, 2, 2, &error));
  mien_effects_free(one), mien_effects_free(three);
}

static void test_lists(void) {
  static const char face[] =
      "{\"format\": \"mien-face\", \"format_version\": 1, \"name\": \"plain\",\n"
      " \"canvas\": {\"x\": [0, 1], \"y\": [0, 1], \"y_axis\": \"up\", \"unit\": \"width\"},\n"
      " \"palette\": {\"black\": \"#000000\"}, \"background\": \"black\", \"features\": [], "
      "\"effects\": [\"grid:4\"]}";
  mien_error* error = NULL;
  mien_face *with = NULL, *without = any_face();
  mien_effects* effects = NULL;
  OK(mien_face_read_text(face, END, NULL, 0, &with, &error));
  OK(mien_effects_of_face(with, &effects, &error));
  CHECK(mien_effects_count(effects) == 1);
  FAILS(MIEN_REFUSED, "blur", mien_effects_add(effects, "blur:3", END, &error));
  FAILS(MIEN_MISUSE, "text", mien_effects_add(effects, NULL, 3, &error));
  FAILS(MIEN_MISUSE, "effects", mien_effects_add(NULL, "grid:4", END, &error));
  CHECK(mien_effects_count(effects) == 1 && mien_effects_count(NULL) == 0);
  mien_effects_free(effects), mien_effects_free(NULL);
  OK(mien_effects_of_face(without, &effects, &error));
  CHECK(mien_effects_count(effects) == 0);
  mien_effects_free(effects), mien_face_free(with), mien_face_free(without);
  FAILS(MIEN_MISUSE, "out", mien_effects_new(NULL, &error));
  FAILS(MIEN_MISUSE, "face", mien_effects_of_face(NULL, &effects, &error));
  FAILS(MIEN_MISUSE, "out", mien_effects_of_face(NULL, NULL, &error));
}

void test_effects(void) {
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_renderer* renderer = NULL;
  OK(mien_renderer_new(&renderer, &error));
  test_drawn(renderer, scene);
  test_progress(renderer, scene);
  test_own_picture();
  test_lists();
  mien_renderer_free(renderer), mien_scene_free(scene);
}
