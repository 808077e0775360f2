#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

#define SIDE 48

static mien_view small_view(void) {
  mien_view view;
  mien_view_init(&view, sizeof view);
  view.width = view.height = SIDE;
  return view;
}

static mien_pixels pixels_in(void* data, size_t bytes) {
  mien_pixels pixels;
  mien_pixels_init(&pixels, sizeof pixels);
  pixels.data = data, pixels.bytes = bytes, pixels.stride = 4 * SIDE;
  return pixels;
}

/* Each is another picture, and a region has the pixels of the whole. */
static void test_drawn(void) {
  static unsigned char pictures[6][SIDE * SIDE * 4], part[SIDE * 4];
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_view view = small_view();
  mien_pixels pixels;
  mien_render_options options;
  int i, j;
  for (i = 0; i < 6; ++i) {
    pixels = pixels_in(pictures[i], sizeof pictures[i]);
    OK(mien_debug_picture(scene, &view, i, &pixels, NULL, &error));
    for (j = 0; j < i; ++j) CHECK(memcmp(pictures[i], pictures[j], sizeof pictures[i]) != 0);
  }
  view.has_region = 1, view.region[0] = 8, view.region[1] = 20, view.region[2] = 30,
  view.region[3] = 1;
  pixels = pixels_in(part, sizeof part);
  OK(mien_debug_picture(scene, &view, MIEN_DEBUG_DISTANCE, &pixels, NULL, &error));
  CHECK(memcmp(part, pictures[MIEN_DEBUG_DISTANCE] + 4 * (20 * SIDE + 8), 4 * 30) == 0);
  FAILS(MIEN_MISUSE, "which", mien_debug_picture(scene, &view, 6, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "which", mien_debug_picture(scene, &view, -1, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "scene", mien_debug_picture(NULL, &view, 0, &pixels, NULL, &error));
  FAILS(MIEN_MISUSE, "view", mien_debug_picture(scene, NULL, 0, &pixels, NULL, &error));
  mien_render_options_init(&options, sizeof options);
  options.most_steps = 1;
  FAILS(MIEN_REFUSED, "steps", mien_debug_picture(scene, &view, 0, &pixels, &options, &error));
  pixels.depth = MIEN_F32, pixels.stride *= 4;
  FAILS(MIEN_MISUSE, "", mien_debug_picture(scene, &view, 0, &pixels, NULL, &error));
  mien_scene_free(scene);
}

static void test_moved(void) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_pose* pose = NULL;
  mien_scene *plain = NULL, *points = NULL, *morph = NULL, *none = NULL;
  OK(mien_pose_new(face, &pose, &error));
  OK(mien_pose_time(pose, 1.25, &error));
  OK(mien_scene_new(pose, &plain, &error));
  OK(mien_scene_debug(pose, MIEN_DEBUG_POINTS, &points, &error));
  OK(mien_scene_debug(pose, MIEN_DEBUG_MORPH, &morph, &error));
  CHECK(mien_scene_layer_count(points) > mien_scene_layer_count(plain));
  CHECK(mien_scene_layer_count(morph) > 0);
  FAILS(MIEN_REFUSED, "muscles", mien_scene_debug(pose, MIEN_DEBUG_MUSCLES, &none, &error));
  FAILS(MIEN_MISUSE, "which", mien_scene_debug(pose, 3, &none, &error));
  FAILS(MIEN_MISUSE, "pose", mien_scene_debug(NULL, 0, &none, &error));
  mien_scene_free(plain), mien_scene_free(points), mien_scene_free(morph);
  mien_pose_free(pose), mien_face_free(face), face = NULL, pose = NULL;
  /* People have muscles. */
  OK(mien_face_from_code("A66CB-AA5S0-14", END, &face, &error));
  OK(mien_pose_new(face, &pose, &error));
  OK(mien_scene_debug(pose, MIEN_DEBUG_MUSCLES, &none, &error));
  CHECK(mien_scene_layer_count(none) > 0);
  mien_scene_free(none), mien_pose_free(pose), mien_face_free(face);
}

void test_debug(void) {
  test_drawn();
  test_moved();
}
