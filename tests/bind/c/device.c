#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

#define SIDE 40

static mien_device_pixels pixels_in(void* data, size_t bytes, int32_t format, size_t stride) {
  mien_device_pixels pixels;
  mien_device_pixels_init(&pixels, sizeof pixels);
  pixels.data = data, pixels.bytes = bytes, pixels.format = format, pixels.stride = stride;
  return pixels;
}

/* BGRX has the levels of 8-bit pixels; the others have as many bits as they are to have. */
static void test_formats(void) {
  static unsigned char rgba[SIDE * SIDE * 4], bgrx[SIDE * SIDE * 4];
  static unsigned short packed[SIDE * SIDE], swapped[SIDE * SIDE];
  static unsigned char bits[SIDE * (SIDE / 8) + 1];
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_renderer* renderer = NULL;
  mien_view view;
  mien_pixels pixels;
  mien_device_pixels out;
  int i;
  mien_view_init(&view, sizeof view);
  view.width = view.height = SIDE;
  OK(mien_renderer_new(&renderer, &error));
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = rgba, pixels.bytes = sizeof rgba, pixels.stride = 4 * SIDE;
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  out = pixels_in(bgrx, sizeof bgrx, MIEN_BGRX, 4 * SIDE);
  OK(mien_render_for_device(scene, &view, &out, NULL, &error));
  for (i = 0; i < SIDE * SIDE; ++i) {
    CHECK(bgrx[4 * i] == rgba[4 * i + 2] && bgrx[4 * i + 1] == rgba[4 * i + 1]);
    CHECK(bgrx[4 * i + 2] == rgba[4 * i] && bgrx[4 * i + 3] == 255);
  }
  out = pixels_in(packed, sizeof packed, MIEN_RGB565, 2 * SIDE);
  OK(mien_render_for_device(scene, &view, &out, NULL, &error));
  out = pixels_in(swapped, sizeof swapped, MIEN_RGB565_SWAPPED, 2 * SIDE);
  OK(mien_render_for_device(scene, &view, &out, NULL, &error));
  for (i = 0; i < SIDE * SIDE; ++i) {
    CHECK(swapped[i] == (unsigned short)(packed[i] << 8 | packed[i] >> 8));
    /* 5 bits of red tell 8 bits of it to within a step, the dither's. */
    CHECK(abs((packed[i] >> 11) * 255 / 31 - rgba[4 * i]) <= 9);
  }
  bits[sizeof bits - 1] = 0x5a;
  out = pixels_in(bits, sizeof bits - 1, MIEN_MONO, SIDE / 8);
  OK(mien_render_for_device(scene, &view, &out, NULL, &error));
  CHECK(bits[sizeof bits - 1] == 0x5a);
  mien_renderer_free(renderer);
  mien_scene_free(scene);
}

static int32_t never(double done, void* data) {
  (void)done, (void)data;
  return 1;
}

static void test_misuse(void) {
  static unsigned short data[SIDE * SIDE + 1];
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_view view;
  mien_render_options options;
  mien_device_pixels out = pixels_in(data, 2 * SIDE * SIDE, MIEN_RGB565, 2 * SIDE);
  mien_view_init(&view, sizeof view);
  view.width = view.height = SIDE;
  FAILS(MIEN_MISUSE, "scene", mien_render_for_device(NULL, &view, &out, NULL, &error));
  FAILS(MIEN_MISUSE, "view", mien_render_for_device(scene, NULL, &out, NULL, &error));
  FAILS(MIEN_MISUSE, "pixels", mien_render_for_device(scene, &view, NULL, NULL, &error));
  out.format = 4;
  FAILS(MIEN_MISUSE, "pixels.format", mien_render_for_device(scene, &view, &out, NULL, &error));
  out.format = MIEN_RGB565, out.stride = 2 * SIDE - 2;
  FAILS(MIEN_MISUSE, "pixels.stride", mien_render_for_device(scene, &view, &out, NULL, &error));
  out.stride = 2 * SIDE, out.bytes = 2 * SIDE * SIDE - 1;
  FAILS(MIEN_MISUSE, "pixels.bytes", mien_render_for_device(scene, &view, &out, NULL, &error));
  out.bytes = 2 * SIDE * SIDE, out.data = (char*)data + 1;
  FAILS(MIEN_MISUSE, "pixels", mien_render_for_device(scene, &view, &out, NULL, &error));
  out.data = NULL;
  FAILS(MIEN_MISUSE, "pixels.data", mien_render_for_device(scene, &view, &out, NULL, &error));
  out.data = data, view.has_region = 1, view.region[0] = SIDE;
  FAILS(MIEN_REFUSED, "view.region", mien_render_for_device(scene, &view, &out, NULL, &error));
  view.has_region = 0;
  mien_render_options_init(&options, sizeof options);
  options.progress = never;
  FAILS(MIEN_CANCELLED, "", mien_render_for_device(scene, &view, &out, &options, &error));
  mien_scene_free(scene);
}

void test_device(void) {
  test_formats();
  test_misuse();
}
