/* A progress that asks to stop is heard wherever the drawing is. */
#define _POSIX_C_SOURCE 200809L

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/bind/c/check.h"

enum { kPoints = 20000, kMostText = kPoints * 24 + 1000 };
static const double kHeard = 0.5; /* [s] */

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* One outline that crosses itself millions of times; `around`: what it lies in, `above`: what is before it. */
static mien_face* spiky_face(const char* groups, const char* above, const char* around) {
  mien_error* error = NULL;
  mien_face* face = NULL;
  char* text = malloc(kMostText);
  int used, i;
  used = sprintf(
      text,
      "{\"format\": \"mien-face\", \"format_version\": 1, \"name\": \"spikes\", \"canvas\": "
      "{\"x\": [-1, 1], \"y\": [-1, 1], \"y_axis\": \"up\"}, \"palette\": {\"a\": \"#204080\", "
      "\"b\": \"#fff7e0\"}, \"background\": \"b\", %s \"features\": [%s {\"name\": \"p\", "
      "\"kind\": \"path\", \"paint\": \"a\", %s \"points\": [",
      groups, above, around);
  for (i = 0; i < kPoints; ++i)
    used += sprintf(text + used, "%s[%.3f, %.4f]", i > 0 ? "," : "", i * 7919 % 2000 / 1000.0 - 1,
                    (int)(i * 104729LL % 1999) / 1000.0 - 1);
  used += sprintf(text + used, "]}]}");
  OK(mien_face_read_text(text, (size_t)used, "spikes", END, &face, &error));
  free(text);
  return face;
}

/* When to stop, and when it was asked for. */
typedef struct {
  double from, asked_at;
} stop;
static int32_t stop_after(double done, void* data) {
  stop* when = data;
  (void)done;
  if (seconds() < when->from) return 0;
  if (when->asked_at == 0) when->asked_at = seconds();
  return 1;
}

/* [s] between the answer and the end. */
static double heard_after(mien_scene* scene, int32_t side, int32_t depth, int32_t threads,
                          double begun) {
  mien_error* error = NULL;
  mien_renderer* renderer = NULL;
  mien_view view;
  mien_pixels pixels;
  mien_render_options options;
  stop when = {0, 0};
  double took;
  mien_view_init(&view, sizeof view);
  view.width = view.height = side;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.stride = (size_t)side * (depth == MIEN_U8 ? 4 : 8);
  pixels.bytes = pixels.stride * (size_t)side;
  pixels.depth = depth, pixels.data = malloc(pixels.bytes);
  mien_render_options_init(&options, sizeof options);
  options.threads = threads, options.progress = stop_after, options.progress_data = &when;
  OK(mien_renderer_new(&renderer, &error));
  when.from = seconds() + begun;
  FAILS(MIEN_CANCELLED, NULL, mien_render(renderer, scene, &view, &pixels, &options, &error));
  took = seconds() - when.asked_at;
  mien_renderer_free(renderer);
  free(pixels.data);
  return took;
}

void test_cancelling(void) {
  static const char* const kinds[3][3] = {
      {"", "", ""},
      {"",
       "{\"name\": \"c\", \"kind\": \"disc\", \"paint\": \"b\", \"center\": [0, 0], \"radius\": "
       "0.8},",
       "\"clip\": \"c\","},
      {"\"groups\": {\"g\": {\"mix\": \"multiply\", \"opacity\": 0.9}},", "", "\"group\": \"g\","}};
  static const int32_t sides[] = {64, 256, 1024};
  mien_error* error = NULL;
  int kind, i;
  for (kind = 0; kind < 3; ++kind) {
    mien_face* face = spiky_face(kinds[kind][0], kinds[kind][1], kinds[kind][2]);
    mien_pose* pose = NULL;
    mien_scene* scene = NULL;
    OK(mien_pose_new(face, &pose, &error));
    OK(mien_scene_new(pose, &scene, &error));
    for (i = 0; i < 6; ++i)
      CHECK(heard_after(scene, sides[i / 2], i % 2 ? MIEN_U16 : MIEN_U8, i % 3, 0.03 * i) < kHeard);
    mien_scene_free(scene), mien_pose_free(pose), mien_face_free(face);
  }
}
