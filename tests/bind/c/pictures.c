#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

enum { kWidth = 160, kHeight = 90, kRow = kWidth * 4, kBytes = kRow * kHeight };

/* The binary interface: these may never change within libmien_c.so.0 (64 bits). */
typedef char view_is_frozen[sizeof(void*) != 8 || sizeof(mien_view) == 120 ? 1 : -1];
typedef char pixels_are_frozen[sizeof(void*) != 8 || sizeof(mien_pixels) == 32 ? 1 : -1];
typedef char options_are_frozen[sizeof(void*) != 8 || sizeof(mien_render_options) == 56 ? 1 : -1];
typedef char stats_are_frozen[sizeof(mien_render_stats) == 136 ? 1 : -1];
typedef char name_is_frozen[sizeof(void*) != 8 || sizeof(mien_name) == 56 ? 1 : -1];
typedef char canvas_is_frozen[sizeof(void*) != 8 || sizeof(mien_canvas) == 56 ? 1 : -1];

static mien_view small_view(void) {
  mien_view view;
  mien_view_init(&view, sizeof view);
  view.width = kWidth, view.height = kHeight;
  return view;
}

static mien_pixels pixels_in(void* data, size_t bytes, size_t stride, int32_t depth) {
  mien_pixels pixels;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = data, pixels.bytes = bytes, pixels.stride = stride, pixels.depth = depth;
  return pixels;
}

static int32_t asked;
static double last_share;
static int32_t go_on(double done, void* data) {
  ++*(int32_t*)data;
  last_share = done;
  return 0;
}
static int32_t stop_at_once(double done, void* data) {
  (void)done;
  ++*(int32_t*)data;
  return 1;
}
static int32_t stop_pieces(void* data) {
  (void)data;
  return 1;
}
static void one_after_another(int32_t count, void (*job)(int32_t, void*), void* job_data,
                              void* data) {
  int32_t i;
  for (i = count - 1; i >= 0; --i) job(i, job_data);
  ++*(int32_t*)data;
}

static void test_options(mien_renderer* renderer, const mien_scene* scene,
                         const unsigned char* wanted) {
  mien_error* error = NULL;
  unsigned char* drawn = malloc(kBytes);
  mien_view view = small_view();
  mien_pixels pixels = pixels_in(drawn, kBytes, kRow, MIEN_U8);
  mien_render_options options;
  int32_t runs = 0;
  mien_render_options_init(&options, sizeof options);
  CHECK(options.threads == 0 && !options.progress && !options.executor);
  asked = 0;
  options.threads = 2, options.progress = go_on, options.progress_data = &asked;
  OK(mien_render(renderer, scene, &view, &pixels, &options, &error));
  CHECK(asked > 0 && last_share == 1 && memcmp(drawn, wanted, kBytes) == 0);
  options.executor = one_after_another, options.executor_data = &runs;
  OK(mien_render(renderer, scene, &view, &pixels, &options, &error));
  CHECK(runs > 0 && memcmp(drawn, wanted, kBytes) == 0);
  options.progress = stop_at_once;
  FAILS(MIEN_CANCELLED, NULL, mien_render(renderer, scene, &view, &pixels, &options, &error));
  options.progress = NULL, options.most_steps = 1;
  FAILS(MIEN_REFUSED, "steps", mien_render(renderer, scene, &view, &pixels, &options, &error));
  options.most_steps = 0, options.most_memory = 1;
  FAILS(MIEN_REFUSED, "memory", mien_render(renderer, scene, &view, &pixels, &options, &error));
  options.most_memory = 0, options.threads = -1;
  FAILS(MIEN_MISUSE, "threads", mien_render(renderer, scene, &view, &pixels, &options, &error));
  options.size = 8, options.threads = 1; /* an older header's */
  OK(mien_render(renderer, scene, &view, &pixels, &options, &error));
  CHECK(memcmp(drawn, wanted, kBytes) == 0);
  free(drawn);
}

static void test_stats(const mien_scene* scene) {
  mien_error* error = NULL;
  unsigned char* drawn = malloc(kBytes);
  mien_view view = small_view();
  mien_pixels pixels = pixels_in(drawn, kBytes, kRow, MIEN_U8);
  mien_renderer* renderer = NULL;
  mien_render_stats stats;
  mien_render_options options;
  memset(&stats, 7, sizeof stats);
  stats.size = sizeof stats;
  OK(mien_renderer_new(&renderer, &error));
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.pixels == 0 && stats.roots == 0 && !stats.cancelled);
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.pixels == kWidth * kHeight && stats.recalled_pixels == 0 && stats.roots > 0);
  CHECK(stats.fill_pixels + stats.varied_pixels + stats.edge_pixels == stats.pixels);
  CHECK(stats.pieces > 100 && stats.regions > 5 && stats.root_seconds > 0 && !stats.cancelled);
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error)); /* begins to remember */
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  stats.size = 40; /* an older header's: nothing beyond is written */
  stats.recalled_pixels = -1;
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.size == 40 && stats.recalled_pixels == -1);
  stats.size = sizeof stats;
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.recalled_pixels == kWidth * kHeight);
  mien_render_options_init(&options, sizeof options);
  options.progress = stop_at_once, options.progress_data = &asked;
  view.width = kWidth / 2;
  FAILS(MIEN_CANCELLED, NULL, mien_render(renderer, scene, &view, &pixels, &options, &error));
  OK(mien_renderer_stats(renderer, &stats, &error));
  CHECK(stats.cancelled);
  FAILS(MIEN_MISUSE, "renderer", mien_renderer_stats(NULL, &stats, &error));
  FAILS(MIEN_MISUSE, "out", mien_renderer_stats(renderer, NULL, &error));
  stats.size = 0;
  FAILS(MIEN_MISUSE, "no size", mien_renderer_stats(renderer, &stats, &error));
  mien_renderer_free(renderer), free(drawn);
}

static void test_buffers(mien_renderer* renderer, const mien_scene* scene,
                         const unsigned char* wanted) {
  enum { kStride = kRow + 12, kAll = kStride * kHeight };
  mien_error* error = NULL;
  unsigned char* drawn = malloc(kAll);
  mien_view view = small_view();
  mien_pixels pixels = pixels_in(drawn, kAll - 12, kStride, MIEN_U8);
  int y, gap;
  memset(drawn, 0xCD, kAll);
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  for (y = 0; y < kHeight; ++y) {
    CHECK(memcmp(drawn + y * kStride, wanted + y * kRow, kRow) == 0);
    for (gap = kRow; gap < kStride; ++gap) CHECK(drawn[y * kStride + gap] == 0xCD);
  }
  pixels.bytes = kAll - 13;
  FAILS(MIEN_MISUSE, "bytes", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels.bytes = kAll, pixels.stride = kRow - 4;
  FAILS(MIEN_MISUSE, "stride", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels.stride = 0;
  FAILS(MIEN_MISUSE, "stride", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels = pixels_in(NULL, kAll, kStride, MIEN_U8);
  FAILS(MIEN_MISUSE, "data", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels = pixels_in(drawn + 1, (size_t)-1, kRow * 4, MIEN_F32);
  FAILS(MIEN_MISUSE, "multiples", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels = pixels_in(drawn, kAll, kStride, 3);
  FAILS(MIEN_MISUSE, "depth", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  pixels = pixels_in(drawn, kAll, kStride, MIEN_U8);
  pixels.size = sizeof pixels + 1;
  FAILS(MIEN_MISUSE, "older", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  free(drawn);
}

static void test_views(mien_renderer* renderer, const mien_scene* scene) {
  mien_error* error = NULL;
  unsigned char* drawn = malloc(kBytes);
  mien_pixels pixels = pixels_in(drawn, kBytes, kRow, MIEN_U8);
  mien_view view = small_view();
  int32_t rect[4];
  view.width = 0;
  FAILS(MIEN_REFUSED, NULL, mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view = small_view(), view.fit = 2;
  FAILS(MIEN_MISUSE, "fit", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view = small_view(), view.blend = -1;
  FAILS(MIEN_MISUSE, "blend", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view = small_view(), view.has_light = 1, view.light[2] = 0;
  FAILS(MIEN_REFUSED, "light", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view = small_view(), view.has_background = 1, view.background[1] = NAN;
  FAILS(MIEN_REFUSED, "background", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view.background[0] = view.background[1] = view.background[2] = 0, view.background[3] = 0;
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  view = small_view(), view.has_region = 1;
  view.region[0] = 150, view.region[1] = -5, view.region[2] = 50, view.region[3] = 20;
  OK(mien_drawn_rect(&view, rect, &error));
  CHECK(rect[0] == 150 && rect[1] == 0 && rect[2] == 10 && rect[3] == 15);
  view.region[0] = 500;
  FAILS(MIEN_REFUSED, "region", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "view", mien_drawn_rect(NULL, rect, &error));
  FAILS(MIEN_MISUSE, "rect", mien_drawn_rect(&view, NULL, &error));
  FAILS(MIEN_MISUSE, "renderer", mien_render(NULL, scene, &view, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "scene", mien_render(renderer, NULL, &view, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "view", mien_render(renderer, scene, NULL, &pixels, NULL, &error));
  view = small_view();
  FAILS(MIEN_MISUSE, "pixels", mien_render(renderer, scene, &view, NULL, NULL, &error));
  view.size = 0;
  FAILS(MIEN_MISUSE, "no size", mien_render(renderer, scene, &view, &pixels, NULL, &error));
  free(drawn);
  mien_view_init(NULL, sizeof view), mien_pixels_init(NULL, 0), mien_render_options_init(NULL, 7);
  memset(&view, 7, sizeof view);
  mien_view_init(&view, 12); /* an older header's: nothing beyond is written */
  CHECK(view.size == 12 && view.width == 512 && view.fit == 0x07070707);
  mien_view_init(&view, sizeof view + 1);
  CHECK(view.size == 12);
}

static void test_colors(void) {
  mien_error* error = NULL;
  double color[4];
  OK(mien_color_from_text("#ff0000 and more", 7, color, &error));
  CHECK(color[0] == 1 && color[1] == 0 && color[2] == 0 && color[3] == 1);
  OK(mien_color_from_text("#00000000", END, color, &error));
  CHECK(color[0] == 0 && color[3] == 0);
  FAILS(MIEN_REFUSED, "colour", mien_color_from_text("red", END, color, &error));
  FAILS(MIEN_MISUSE, "text", mien_color_from_text(NULL, END, color, &error));
  FAILS(MIEN_MISUSE, "color", mien_color_from_text("#ff0000", END, NULL, &error));
}

static void test_places(const mien_scene* scene) {
  mien_error* error = NULL;
  mien_view view = small_view();
  double face[2], pixel[2];
  OK(mien_face_from_pixel(scene, &view, 40.5, 30.25, face, &error));
  OK(mien_pixel_from_face(scene, &view, face[0], face[1], pixel, &error));
  CHECK(fabs(pixel[0] - 40.5) < 1e-9 && fabs(pixel[1] - 30.25) < 1e-9);
  FAILS(MIEN_REFUSED, "x", mien_face_from_pixel(scene, &view, NAN, 0, face, &error));
  FAILS(MIEN_MISUSE, "out", mien_face_from_pixel(scene, &view, 0, 0, NULL, &error));
  FAILS(MIEN_MISUSE, "scene", mien_pixel_from_face(NULL, &view, 0, 0, face, &error));
  FAILS(MIEN_MISUSE, "view", mien_pixel_from_face(scene, NULL, 0, 0, face, &error));
}

static void test_pieces(const mien_scene* scene, const unsigned char* wanted) {
  mien_error* error = NULL;
  mien_view view = small_view();
  mien_pieces* pieces = NULL;
  mien_render_options options;
  unsigned char* drawn = malloc(kBytes);
  int32_t piece[4] = {0, 0, 0, kHeight / 2}, i;
  mien_pixels pixels;
  OK(mien_pieces_new(scene, &view, MIEN_U8, NULL, &pieces, &error));
  for (i = 3; i >= 0; --i) { /* quarters, from the last to the first */
    piece[0] = i % 2 * (kWidth / 2), piece[1] = i / 2 * (kHeight / 2), piece[2] = kWidth / 2;
    pixels = pixels_in(drawn + piece[1] * kRow + piece[0] * 4, kRow * (kHeight / 2) - kRow / 2,
                       kRow, MIEN_U8);
    OK(mien_pieces_draw(pieces, piece, &pixels, NULL, NULL, &error));
  }
  CHECK(memcmp(drawn, wanted, kBytes) == 0);
  pixels = pixels_in(drawn, kBytes, kRow, MIEN_U8);
  piece[0] = 1 << 30;
  FAILS(MIEN_REFUSED, "piece", mien_pieces_draw(pieces, piece, &pixels, NULL, NULL, &error));
  piece[0] = 0, piece[2] = 2147483647;
  FAILS(MIEN_REFUSED, "piece", mien_pieces_draw(pieces, piece, &pixels, NULL, NULL, &error));
  piece[2] = kWidth;
  FAILS(MIEN_CANCELLED, NULL, mien_pieces_draw(pieces, piece, &pixels, stop_pieces, NULL, &error));
  pixels.depth = MIEN_U16, pixels.stride *= 2;
  FAILS(MIEN_MISUSE, "depth", mien_pieces_draw(pieces, piece, &pixels, NULL, NULL, &error));
  FAILS(MIEN_MISUSE, "piece", mien_pieces_draw(pieces, NULL, &pixels, NULL, NULL, &error));
  FAILS(MIEN_MISUSE, "pixels", mien_pieces_draw(pieces, piece, NULL, NULL, NULL, &error));
  FAILS(MIEN_MISUSE, "pieces", mien_pieces_draw(NULL, piece, &pixels, NULL, NULL, &error));
  mien_pieces_free(pieces), mien_pieces_free(NULL), free(drawn);
  mien_render_options_init(&options, sizeof options);
  options.most_steps = 1;
  FAILS(MIEN_REFUSED, "steps", mien_pieces_new(scene, &view, MIEN_U8, &options, &pieces, &error));
  options.most_steps = 0, options.most_memory = 1;
  FAILS(MIEN_REFUSED, "memory", mien_pieces_new(scene, &view, MIEN_U8, &options, &pieces, &error));
  FAILS(MIEN_MISUSE, "depth", mien_pieces_new(scene, &view, 9, NULL, &pieces, &error));
  FAILS(MIEN_MISUSE, "scene", mien_pieces_new(NULL, &view, MIEN_U8, NULL, &pieces, &error));
  FAILS(MIEN_MISUSE, "view", mien_pieces_new(scene, NULL, MIEN_U8, NULL, &pieces, &error));
}

void test_pictures(void) {
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_renderer* renderer = NULL;
  unsigned char* wanted = malloc(kBytes);
  mien_view view = small_view();
  mien_pixels pixels = pixels_in(wanted, kBytes, kRow, MIEN_U8);
  OK(mien_renderer_new(&renderer, &error));
  OK(mien_render(renderer, scene, &view, &pixels, NULL, &error));
  CHECK(memcmp(wanted, wanted + kRow * (kHeight / 2), kRow) != 0);
  test_options(renderer, scene, wanted);
  test_stats(scene);
  test_buffers(renderer, scene, wanted);
  test_views(renderer, scene);
  test_colors();
  test_places(scene);
  test_pieces(scene, wanted);
  FAILS(MIEN_MISUSE, "out", mien_renderer_new(NULL, &error));
  mien_renderer_free(renderer), mien_renderer_free(NULL), mien_scene_free(scene);
  free(wanted);
}
