#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

static const char* const take_text = "time,HeadYaw,tongueOut,jawOpen\n0,0,0,0\n1,-0.2,0.5,1.5\n";

static mien_motion* take(void) {
  mien_error* error = NULL;
  mien_motion* motion = NULL;
  OK(mien_motion_read_text(take_text, END, "take.csv", END, &motion, &error));
  return motion;
}

static void test_read(void) {
  mien_error* error = NULL;
  mien_motion* motion = take();
  mien_texts* texts = NULL;
  int32_t i, yaw = -1;
  CHECK(mien_motion_length(motion) == 1);
  CHECK(mien_motion_channel_count(motion) == 3);
  for (i = 0; i < 3; ++i)
    if (!strcmp(mien_motion_channel_name(motion, i), "yaw")) yaw = i;
  CHECK(yaw >= 0 && fabs(mien_motion_value(motion, yaw, 0.5) - 5.7296) < 1e-3);
  CHECK(mien_motion_value(motion, 9, 0) == 0 && !strcmp(mien_motion_channel_name(motion, -1), ""));
  OK(mien_motion_told(motion, &texts, &error));
  CHECK(mien_texts_count(texts) == 1 && holds(mien_texts_at(texts, 0), "arkit.jawOpen"));
  mien_texts_free(texts);
  mien_motion_free(motion);
  FAILS(MIEN_UNREADABLE, "nowhere.csv", mien_motion_read("nowhere.csv", END, &motion, &error));
  FAILS(MIEN_UNREADABLE, "a:1", mien_motion_read_text("x", 1, "a", END, &motion, &error));
  FAILS(MIEN_MISUSE, "out", mien_motion_read_text("x", 1, NULL, 0, NULL, &error));
  FAILS(MIEN_MISUSE, "motion", mien_motion_told(NULL, &texts, &error));
  CHECK(mien_motion_length(NULL) == 0 && mien_motion_channel_count(NULL) == 0);
  mien_motion_free(NULL);
}

/* The posed numbers; the caller frees them. */
static double* numbers(const mien_face* face, mien_pose* pose) {
  mien_error* error = NULL;
  const int32_t count = mien_face_vector_size(face);
  double* values = malloc(sizeof *values * (size_t)count);
  OK(mien_pose_vector(pose, values, count, &error));
  return values;
}

static void test_played(void) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_motion *motion = take(), *other = NULL;
  mien_pose* pose = NULL;
  mien_texts* texts = NULL;
  const size_t bytes = sizeof(double) * (size_t)mien_face_vector_size(face);
  double *rest, *moved, *followed;
  OK(mien_motion_read_text("time,emotion.glee\n0,0\n1,1\n", END, "t", END, &other, &error));
  OK(mien_motion_unfollowed(other, face, &texts, &error));
  CHECK(mien_texts_count(texts) == 1 && holds(mien_texts_at(texts, 0), "emotion.glee"));
  mien_texts_free(texts), mien_motion_free(other);
  OK(mien_pose_new(face, &pose, &error));
  rest = numbers(face, pose);
  OK(mien_pose_motion(pose, motion, 1, 0, &error));
  OK(mien_pose_time(pose, 1, &error));
  moved = numbers(face, pose);
  CHECK(memcmp(rest, moved, bytes) != 0);
  OK(mien_pose_clear(pose, &error));
  OK(mien_pose_follow(pose, "{\"headYaw\": -0.2, \"jawOpen\": 1}", END, &error));
  followed = numbers(face, pose);
  CHECK(memcmp(rest, followed, bytes) != 0);
  FAILS(MIEN_REFUSED, "frame:1", mien_pose_follow(pose, "{\"jawOpen\": }", END, &error));
  FAILS(MIEN_MISUSE, "motion", mien_pose_motion(pose, NULL, 1, 0, &error));
  FAILS(MIEN_REFUSED, "weight", mien_pose_motion(pose, motion, NAN, 0, &error));
  FAILS(MIEN_MISUSE, "pose", mien_pose_follow(NULL, "{}", END, &error));
  free(rest), free(moved), free(followed);
  mien_pose_free(pose), mien_motion_free(motion), mien_face_free(face);
}

/* A frame between two that a filter has seen: it goes a part of the way. */
static void test_steadied(void) {
  mien_error* error = NULL;
  mien_face* face = any_face();
  mien_pose *pose = NULL, *plain = NULL;
  mien_steadier* steadier = NULL;
  const size_t bytes = sizeof(double) * (size_t)mien_face_vector_size(face);
  double *first, *second, *whole;
  OK(mien_pose_new(face, &pose, &error) || mien_pose_new(face, &plain, &error));
  OK(mien_steadier_new(1, 0, &steadier, &error));
  OK(mien_pose_follow_steadily(pose, steadier, 5, "{\"headYaw\": 0}", END, &error));
  first = numbers(face, pose);
  OK(mien_pose_follow_steadily(pose, steadier, 5.03, "{\"headYaw\": -0.2}", END, &error));
  second = numbers(face, pose);
  OK(mien_pose_follow(plain, "{\"headYaw\": -0.2}", END, &error));
  whole = numbers(face, plain);
  CHECK(memcmp(first, second, bytes) != 0 && memcmp(second, whole, bytes) != 0);
  free(second);
  OK(mien_pose_follow_steadily(pose, steadier, 9, "{\"headYaw\": -0.2}", END, &error));
  second = numbers(face, pose);
  CHECK(memcmp(second, whole, bytes) == 0); /* after a pause */
  FAILS(MIEN_REFUSED, "frame:1",
        mien_pose_follow_steadily(pose, steadier, 9, "{\"jawOpen\": }", END, &error));
  FAILS(MIEN_MISUSE, "steadier", mien_pose_follow_steadily(pose, NULL, 9, "{}", END, &error));
  FAILS(MIEN_REFUSED, "seconds", mien_pose_follow_steadily(pose, steadier, NAN, "{}", END, &error));
  mien_steadier_free(steadier);
  FAILS(MIEN_REFUSED, "cutoff", mien_steadier_new(0, 0, &steadier, &error));
  FAILS(MIEN_REFUSED, "beta", mien_steadier_new(1, -1, &steadier, &error));
  FAILS(MIEN_MISUSE, "out", mien_steadier_new(1, 1, NULL, &error));
  mien_steadier_free(NULL);
  free(first), free(second), free(whole);
  mien_pose_free(pose), mien_pose_free(plain), mien_face_free(face);
}

void test_motions(void) {
  test_read();
  test_played();
  test_steadied();
}
