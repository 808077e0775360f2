#include <mien_image_c.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

typedef char options_are_frozen[sizeof(void*) != 8 || sizeof(mien_write_options) == 72 ? 1 : -1];

enum { kWidth = 64, kHeight = 36, kRow = kWidth * 4, kBytes = kRow * kHeight };
static char path[1000];

static const char* in(const char* folder, const char* name) {
  snprintf(path, sizeof path, "%s/%s", folder, name);
  return path;
}

/* A file's bytes, which the caller frees; NULL: there is none. */
static unsigned char* bytes_of(const char* file, size_t* count) {
  FILE* const in = fopen(file, "rb");
  unsigned char* bytes = malloc(1 << 20);
  *count = in ? fread(bytes, 1, 1 << 20, in) : 0;
  if (in) return fclose(in), bytes;
  return free(bytes), NULL;
}

static int32_t stop(double done, void* data) {
  (void)done, (void)data;
  return 1;
}

static void test_kinds(const mien_scene* scene, const char* folder) {
  static const char* const names[] = {"a.png", "a.tif", "a.exr", "a.jpg"};
  mien_error* error = NULL;
  mien_view view;
  mien_write_options options;
  size_t i, count = 0;
  mien_view_init(&view, sizeof view);
  view.width = kWidth, view.height = kHeight;
  for (i = 0; i < 4; ++i) {
    unsigned char* bytes;
    remove(in(folder, names[i]));
    OK(mien_write_picture(scene, &view, path, END, NULL, &error));
    bytes = bytes_of(path, &count);
    CHECK(bytes && count > 100);
    free(bytes);
  }
  mien_write_options_init(&options, sizeof options);
  options.type = MIEN_FILE_PNG, options.depth = MIEN_U16, options.recipe = "of a test";
  options.threads = 1;
  OK(mien_write_picture(scene, &view, in(folder, "png.of.another.name"), END, &options, &error));
  options.depth = 7;
  FAILS(MIEN_MISUSE, "depth", mien_write_picture(scene, &view, path, END, &options, &error));
  options.depth = -1, options.progress = stop;
  remove(in(folder, "never.png"));
  FAILS(MIEN_CANCELLED, NULL, mien_write_picture(scene, &view, path, END, &options, &error));
  CHECK(bytes_of(path, &count) == NULL);
  options.progress = NULL, options.jpeg_quality = 0;
  FAILS(MIEN_REFUSED, "quality", mien_write_picture(scene, &view, path, END, &options, &error));
  options.jpeg_quality = 95, options.dpi = 0.5;
  FAILS(MIEN_REFUSED, "dpi", mien_write_picture(scene, &view, path, END, &options, &error));
  options.dpi = 0, options.memory = 1;
  FAILS(MIEN_NOT_WRITTEN, NULL, mien_write_picture(scene, &view, path, END, &options, &error));
  view.has_region = 1, view.region[0] = 999, view.region[2] = view.region[3] = 1;
  FAILS(MIEN_REFUSED, "region", mien_write_picture(scene, &view, path, END, NULL, &error));
}

static void test_refusals(const mien_scene* scene, const char* folder) {
  mien_error* error = NULL;
  mien_view view;
  mien_write_options options;
  mien_view_init(&view, sizeof view);
  mien_write_options_init(&options, sizeof options);
  OK(mien_check_output_path(in(folder, "b.png"), END, NULL, &error));
  FAILS(MIEN_NOT_WRITTEN, NULL, mien_check_output_path(in(folder, "b.doc"), END, NULL, &error));
  FAILS(MIEN_NOT_WRITTEN, NULL, mien_check_output_path(in(folder, "c/b.png"), END, NULL, &error));
  FAILS(MIEN_MISUSE, "path", mien_check_output_path(NULL, END, NULL, &error));
  options.type = 5;
  FAILS(MIEN_MISUSE, "type", mien_check_output_path("b.png", END, &options, &error));
  options.type = 0, options.threads = -2;
  FAILS(MIEN_MISUSE, "threads", mien_check_output_path("b.png", END, &options, &error));
  options.size = 1000;
  FAILS(MIEN_MISUSE, "older", mien_check_output_path("b.png", END, &options, &error));
  in(folder, "b.png");
  FAILS(MIEN_MISUSE, "scene", mien_write_picture(NULL, &view, path, END, NULL, &error));
  FAILS(MIEN_MISUSE, "view", mien_write_picture(scene, NULL, path, END, NULL, &error));
  FAILS(MIEN_MISUSE, "path", mien_write_picture(scene, &view, "", 0, NULL, &error));
  mien_write_options_init(NULL, 4);
}

/* Pixels written are the picture written. */
static void test_pixels(const mien_scene* scene, const char* folder) {
  mien_error* error = NULL;
  mien_renderer* renderer = NULL;
  mien_view view;
  mien_pixels pixels;
  unsigned char *one, *other;
  size_t one_size = 0, other_size = 0;
  mien_view_init(&view, sizeof view);
  view.width = kWidth, view.height = kHeight;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = malloc(kBytes), pixels.bytes = kBytes, pixels.stride = kRow;
  OK(mien_renderer_new(&renderer, &error));
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  OK(mien_write_image(&pixels, kWidth, kHeight, in(folder, "pixels.png"), END, NULL, &error));
  one = bytes_of(path, &one_size);
  OK(mien_write_picture(scene, &view, in(folder, "picture.png"), END, NULL, &error));
  other = bytes_of(path, &other_size);
  CHECK(one && other && one_size == other_size && memcmp(one, other, one_size) == 0);
  ((unsigned char*)pixels.data)[3] = 7; /* not opaque any more */
  FAILS(MIEN_NOT_WRITTEN, NULL,
        mien_write_image(&pixels, kWidth, kHeight, in(folder, "pixels.jpg"), END, NULL, &error));
  FAILS(MIEN_MISUSE, "hold", mien_write_image(&pixels, kWidth, 37, path, END, NULL, &error));
  FAILS(MIEN_MISUSE, "hold", mien_write_image(&pixels, 65, 1, path, END, NULL, &error));
  FAILS(MIEN_REFUSED, "sides", mien_write_image(&pixels, 0, 1, path, END, NULL, &error));
  FAILS(MIEN_MISUSE, "pixels", mien_write_image(NULL, 1, 1, path, END, NULL, &error));
  free(one), free(other), free(pixels.data);
  pixels.data = NULL;
  FAILS(MIEN_MISUSE, "data", mien_write_image(&pixels, 1, 1, path, END, NULL, &error));
  mien_renderer_free(renderer);
}

void test_files(const char* folder) {
  mien_scene* scene = any_scene();
  test_kinds(scene, folder);
  test_refusals(scene, folder);
  test_pixels(scene, folder);
  mien_scene_free(scene);
}
