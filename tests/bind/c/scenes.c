#include <math.h>
#include <string.h>

#include "tests/bind/c/check.h"

static void test_refusals(const mien_scene* scene) {
  mien_error* error = NULL;
  mien_texts* text = NULL;
  mien_scene* none = NULL;
  double d = 0, color[4];
  int32_t at = 0;
  FAILS(MIEN_MISUSE, "pose", mien_scene_new(NULL, &none, &error));
  FAILS(MIEN_MISUSE, "scene", mien_scene_text(NULL, &text, &error));
  FAILS(MIEN_MISUSE, "out", mien_scene_text(scene, NULL, &error));
  FAILS(MIEN_MISUSE, "scene", mien_scene_background(NULL, color, &error));
  FAILS(MIEN_MISUSE, "color", mien_scene_background(scene, NULL, &error));
  FAILS(MIEN_MISUSE, "layer", mien_scene_distance(scene, -1, 0, 0, &d, &error));
  FAILS(MIEN_MISUSE, "layer", mien_scene_distance(scene, 1 << 30, 0, 0, &d, &error));
  FAILS(MIEN_REFUSED, "x", mien_scene_distance(scene, 0, NAN, 0, &d, &error));
  FAILS(MIEN_MISUSE, "out", mien_scene_distance(scene, 0, 0, 0, NULL, &error));
  FAILS(MIEN_MISUSE, "scene", mien_scene_distance(NULL, 0, 0, 0, &d, &error));
  FAILS(MIEN_REFUSED, "y", mien_scene_layer_at(scene, 0, INFINITY, &at, &error));
  FAILS(MIEN_MISUSE, "scene", mien_scene_layer_at(NULL, 0, 0, &at, &error));
  FAILS(MIEN_MISUSE, "out", mien_scene_layer_at(scene, 0, 0, NULL, &error));
  FAILS(MIEN_REFUSED, "x", mien_scene_feature_at(scene, NAN, 0, &text, &error));
  FAILS(MIEN_MISUSE, "scene", mien_scene_feature_at(NULL, 0, 0, &text, &error));
  FAILS(MIEN_MISUSE, "out", mien_scene_feature_at(scene, 0, 0, NULL, &error));
  CHECK(mien_scene_layer_count(NULL) == 0 && mien_scene_layer_name(NULL, 0)[0] == 0);
  CHECK(mien_scene_layer_name(scene, -1)[0] == 0);
  mien_scene_free(NULL);
}

/* Here the topmost layer is opaque, or an outline: its feature is seen. */
static void test_features(const mien_scene* scene) {
  mien_error* error = NULL;
  mien_texts* text = NULL;
  int32_t at = 0;
  OK(mien_scene_feature_at(scene, 0, 0, &text, &error));
  CHECK(mien_texts_count(text) == 1);
  OK(mien_scene_layer_at(scene, 0, 0, &at, &error));
  CHECK(strncmp(mien_texts_at(text, 0), mien_scene_layer_name(scene, at),
                strlen(mien_texts_at(text, 0))) == 0);
  mien_texts_free(text);
  OK(mien_scene_feature_at(scene, 1e9, 1e9, &text, &error));
  OK(mien_scene_layer_at(scene, 1e9, 1e9, &at, &error));
  CHECK((mien_texts_count(text) == 0) == (at < 0));
  mien_texts_free(text);
}

static void test_svg(const mien_scene* scene) {
  mien_error* error = NULL;
  mien_texts* text = NULL;
  mien_view view;
  mien_render_options options;
  mien_view_init(&view, sizeof view);
  view.width = 300, view.height = 200;
  OK(mien_svg(scene, &view, 0, "a-", MIEN_NUL_ENDED, NULL, &text, &error));
  CHECK(mien_texts_count(text) >= 1);
  CHECK(holds(mien_texts_at(text, 0), "viewBox=\"0 0 300 200\""));
  CHECK(holds(mien_texts_at(text, 0), "<path id=\"a-"));
  CHECK(holds(mien_texts_at(text, 0), "</svg>\n"));
  mien_texts_free(text);
  FAILS(MIEN_MISUSE, "scene", mien_svg(NULL, &view, 0, "", 0, NULL, &text, &error));
  FAILS(MIEN_MISUSE, "view", mien_svg(scene, NULL, 0, "", 0, NULL, &text, &error));
  FAILS(MIEN_MISUSE, "id_prefix", mien_svg(scene, &view, 0, NULL, 1, NULL, &text, &error));
  FAILS(MIEN_MISUSE, "out", mien_svg(scene, &view, 0, "", 0, NULL, NULL, &error));
  FAILS(MIEN_REFUSED, "", mien_svg(scene, &view, NAN, "", 0, NULL, &text, &error));
  FAILS(MIEN_REFUSED, "", mien_svg(scene, &view, -1, "", 0, NULL, &text, &error));
  mien_render_options_init(&options, sizeof options);
  options.most_steps = 1;
  FAILS(MIEN_REFUSED, "steps", mien_svg(scene, &view, 0, "", 0, &options, &text, &error));
  view.has_region = 1;
  FAILS(MIEN_REFUSED, "view.region", mien_svg(scene, &view, 0, "", 0, NULL, &text, &error));
  view.has_region = 0, view.width = 0;
  FAILS(MIEN_REFUSED, "", mien_svg(scene, &view, 0, "", 0, NULL, &text, &error));
}

void test_scenes(void) {
  mien_error* error = NULL;
  mien_scene* scene = any_scene();
  mien_texts* text = NULL;
  double d = 0, color[4] = {-1, -1, -1, -1};
  int32_t at = 0, layer, found = 0;
  OK(mien_scene_text(scene, &text, &error));
  CHECK(holds(mien_texts_at(text, 0), "layer"));
  mien_texts_free(text);
  OK(mien_scene_background(scene, color, &error));
  CHECK(color[0] >= 0 && color[3] >= 0 && color[3] <= 1);
  CHECK(mien_scene_layer_count(scene) > 10);
  for (layer = 0; layer < mien_scene_layer_count(scene); ++layer) {
    CHECK(mien_scene_layer_name(scene, layer)[0] != 0);
    OK(mien_scene_distance(scene, layer, 1e6, 1e6, &d, &error));
    CHECK(d > 1e5 || d <= 0);
    if (strncmp(mien_scene_layer_name(scene, layer), "pupil", 5) == 0) ++found;
  }
  CHECK(found > 0);
  OK(mien_scene_layer_at(scene, 0, 0, &at, &error));
  CHECK(at >= 0);
  OK(mien_scene_distance(scene, at, 0, 0, &d, &error));
  CHECK(d <= 0);
  for (layer = at + 1; layer < mien_scene_layer_count(scene); ++layer) {
    OK(mien_scene_distance(scene, layer, 0, 0, &d, &error));
    CHECK(d > 0);
  }
  test_features(scene);
  test_svg(scene);
  test_refusals(scene);
  mien_scene_free(scene);
}
