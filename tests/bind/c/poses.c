#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

static double* vector_of(mien_pose* pose, int32_t count) {
  mien_error* error = NULL;
  double* values = malloc((size_t)count * sizeof *values);
  OK(mien_pose_vector(pose, values, count, &error));
  return values;
}

static int differ(const double* a, const double* b, int32_t count) {
  return memcmp(a, b, (size_t)count * sizeof *a) != 0;
}

/* What each way of posing changes, and that clearing takes it back. */
static void test_what_moves(mien_pose* pose, int32_t count, const double* rest) {
  mien_error* error = NULL;
  int way;
  for (way = 0; way < 5; ++way) {
    double* moved;
    if (way == 0) OK(mien_pose_set(pose, "blink=0.5", END, &error));
    if (way == 1) OK(mien_pose_set(pose, "gaze.x=0.04 and more", 11, &error));
    if (way == 2) OK(mien_pose_time(pose, 1.25, &error));
    if (way == 3) OK(mien_pose_look_at(pose, 5, 0, 1, &error));
    if (way == 4) OK(mien_pose_unwrap(pose, 0.5, MIEN_UNWRAP_SINE, &error));
    moved = vector_of(pose, count);
    CHECK(way == 4 || differ(moved, rest, count)); /* not every face has a chart */
    free(moved);
    OK(mien_pose_clear(pose, &error));
    moved = vector_of(pose, count);
    CHECK(!differ(moved, rest, count));
    free(moved);
  }
}

static void test_by_index(const mien_face* face, mien_pose* pose, int32_t count) {
  mien_error* error = NULL;
  mien_name name;
  double half = 0.5, most[4] = {1e300, 1e300, 1e300, 1e300};
  double *by_text, *by_index;
  int32_t i;
  name.size = sizeof name;
  for (i = 0; i < mien_face_name_count(face); ++i) {
    OK(mien_face_name_at(face, i, &name, &error));
    if (strcmp(name.name, "blink") == 0) break;
  }
  OK(mien_pose_set(pose, "blink=0.5", END, &error));
  by_text = vector_of(pose, count);
  OK(mien_pose_clear(pose, &error));
  OK(mien_pose_set_at(pose, i, &half, 1, &error));
  by_index = vector_of(pose, count);
  CHECK(!differ(by_text, by_index, count));
  free(by_text), free(by_index);
  FAILS(MIEN_REFUSED, "blink", mien_pose_set_at(pose, i, most, 1, &error));
  most[0] = NAN;
  FAILS(MIEN_REFUSED, "blink", mien_pose_set_at(pose, i, most, 1, &error));
  FAILS(MIEN_MISUSE, "count", mien_pose_set_at(pose, i, &half, 2, &error));
  FAILS(MIEN_MISUSE, "values", mien_pose_set_at(pose, i, NULL, 1, &error));
  FAILS(MIEN_MISUSE, "index", mien_pose_set_at(pose, -1, &half, 1, &error));
  FAILS(MIEN_MISUSE, "index", mien_pose_set_at(pose, 1 << 30, &half, 1, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_set_at(NULL, i, &half, 1, &error));
  i = mien_face_name_count(face) - 1; /* the last slice */
  OK(mien_face_name_at(face, i, &name, &error));
  FAILS(MIEN_REFUSED, name.name, mien_pose_set_at(pose, i, most, name.count, &error));
  OK(mien_pose_clear(pose, &error));
}

static void test_refusals(mien_pose* pose) {
  mien_error* error = NULL;
  FAILS(MIEN_REFUSED, "did you mean \"gaze.x\"", mien_pose_set(pose, "gaze.z=1", END, &error));
  FAILS(MIEN_REFUSED, "goes from", mien_pose_set(pose, "blink=7", END, &error));
  FAILS(MIEN_REFUSED, NULL, mien_pose_set(pose, "", 0, &error));
  FAILS(MIEN_REFUSED, NULL, mien_pose_set(pose, "\xff\xfe\n=1", END, &error));
  FAILS(MIEN_MISUSE, "text", mien_pose_set(pose, NULL, END, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_set(NULL, "blink=1", END, &error));
  FAILS(MIEN_REFUSED, "clip", mien_pose_clip(pose, "no such", END, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_clip(NULL, "a", END, &error));
  FAILS(MIEN_REFUSED, NULL, mien_pose_express(pose, "emotion", END, "none", END, 0, &error));
  FAILS(MIEN_REFUSED, NULL, mien_pose_express(pose, "no set", END, "joy", END, 0, &error));
  FAILS(MIEN_MISUSE, "set", mien_pose_express(pose, NULL, END, "joy", END, 0, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_express(NULL, "emotion", END, "joy", END, 0, &error));
  FAILS(MIEN_REFUSED, "finite", mien_pose_time(pose, INFINITY, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_time(NULL, 1, &error));
  FAILS(MIEN_REFUSED, "finite", mien_pose_time(pose, NAN, &error));
  FAILS(MIEN_REFUSED, "finite", mien_pose_look_at(pose, NAN, 0, 1, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_look_at(NULL, 0, 0, 1, &error));
  FAILS(MIEN_REFUSED, "an empty word is no seed", mien_pose_seed(pose, "", END, &error));
  FAILS(MIEN_MISUSE, "word", mien_pose_seed(pose, NULL, END, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_seed(NULL, "a", END, &error));
  FAILS(MIEN_REFUSED, "goes from 0 to 2, got 3", mien_pose_liveliness(pose, 3, &error));
  FAILS(MIEN_REFUSED, "liveliness", mien_pose_liveliness(pose, NAN, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_liveliness(NULL, 1, &error));
  FAILS(MIEN_REFUSED, "go from 0 to 2, got -1", mien_pose_gestures(pose, -1, &error));
  FAILS(MIEN_REFUSED, "gestures", mien_pose_gestures(pose, NAN, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_gestures(NULL, 1, &error));
  FAILS(MIEN_REFUSED, "share", mien_pose_unwrap(pose, 1.5, MIEN_UNWRAP_LINEAR, &error));
  FAILS(MIEN_MISUSE, "mode", mien_pose_unwrap(pose, 0.5, 3, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_unwrap(NULL, 0.5, MIEN_UNWRAP_DELAYED, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_clear(NULL, &error));
}

/* The same word gives any face the same time; without liveliness it rests. */
static void test_seeds(void) {
  mien_error* error = NULL;
  mien_texts* code = NULL;
  mien_face* face = NULL;
  mien_pose* pose = NULL;
  double *rest, *own, *other, *still;
  int32_t count;
  OK(mien_code_from_seed(5, &code, &error));
  OK(mien_face_from_code(mien_texts_at(code, 0), END, &face, &error));
  count = mien_face_vector_size(face);
  OK(mien_pose_new(face, &pose, &error));
  rest = vector_of(pose, count);
  OK(mien_pose_time(pose, 1.25, &error));
  own = vector_of(pose, count);
  OK(mien_pose_seed(pose, "ada", END, &error));
  other = vector_of(pose, count);
  CHECK(differ(own, other, count));
  free(other);
  OK(mien_pose_seed(pose, mien_texts_at(code, 0), END, &error)); /* a person's own is her code */
  other = vector_of(pose, count);
  CHECK(!differ(own, other, count));
  OK(mien_pose_liveliness(pose, 0, &error));
  OK(mien_pose_gestures(pose, 0.5, &error));
  still = vector_of(pose, count);
  CHECK(!differ(rest, still, count));
  mien_pose_free(pose), mien_face_free(face), mien_texts_free(code);
  free(rest), free(own), free(other), free(still);
}

/* People by code have emotions. */
static void test_emotions(void) {
  mien_error* error = NULL;
  mien_texts* code = NULL;
  mien_face* face = NULL;
  mien_pose* pose = NULL;
  double *rest, *joy;
  int32_t count;
  OK(mien_code_from_seed(5, &code, &error));
  OK(mien_face_from_code(mien_texts_at(code, 0), END, &face, &error));
  OK(mien_pose_new(face, &pose, &error));
  count = mien_face_vector_size(face);
  mien_face_free(face); /* the pose lives on */
  rest = vector_of(pose, count);
  OK(mien_pose_express(pose, "emotion", END, "joy=0.8", END, 0, &error));
  joy = vector_of(pose, count);
  CHECK(differ(rest, joy, count));
  FAILS(MIEN_REFUSED, "0 to 1", mien_pose_express(pose, "emotion", 7, "joy=3", 5, 0, &error));
  OK(mien_pose_express(pose, "emotion", END, "joy=3", END, 1, &error));
  mien_pose_free(pose), mien_texts_free(code);
  free(rest), free(joy);
}

void test_poses(void) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_pose* pose = NULL;
  const int32_t count = mien_face_vector_size(face);
  double* rest;
  OK(mien_pose_new(face, &pose, &error));
  rest = vector_of(pose, count);
  test_what_moves(pose, count, rest);
  test_by_index(face, pose, count);
  test_refusals(pose);
  OK(mien_pose_time(pose, 0.5, &error));
  OK(mien_pose_clip(pose, mien_face_clip_name(face, 0), END, &error));
  FAILS(MIEN_MISUSE, "count", mien_pose_vector(pose, rest, count - 1, &error));
  FAILS(MIEN_MISUSE, "values", mien_pose_vector(pose, NULL, count, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_vector(NULL, rest, count, &error));
  mien_pose_free(pose), mien_face_free(face), mien_pose_free(NULL);
  FAILS(MIEN_MISUSE, "face", mien_pose_new(NULL, &pose, &error));
  CHECK(pose == NULL);
  free(rest);
  test_emotions();
  test_seeds();
}
