#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

/* The posed numbers of a face with one setting; the caller frees them. */
static double* posed_with(const mien_face* face, const char* setting) {
  mien_error* error = NULL;
  mien_pose* pose = NULL;
  const int32_t count = mien_face_vector_size(face);
  double* values = malloc(sizeof *values * (size_t)count);
  OK(mien_pose_new(face, &pose, &error));
  if (setting) OK(mien_pose_set(pose, setting, END, &error));
  OK(mien_pose_vector(pose, values, count, &error));
  mien_pose_free(pose);
  return values;
}

/* A face as its file would be with every "from" as "to". */
static mien_face* changed_face(const char* from, const char* to) {
  mien_error* error = NULL;
  mien_face* face = NULL;
  FILE* file = fopen(face_path(), "rb");
  char *text = calloc(1, 1 << 20), *at, *end = text;
  size_t length = fread(text, 1, (1 << 20) - 100, file);
  fclose(file);
  CHECK(strlen(from) == strlen(to));
  for (at = strstr(text, from); at; at = strstr(at + 1, from)) memcpy(at, to, strlen(to)), end = at;
  CHECK(end != text); /* or nothing was changed */
  OK(mien_face_read_text(text, length, NULL, 0, &face, &error));
  free(text);
  return face;
}

static void test_made(const mien_face* rest) {
  mien_error* error = NULL;
  mien_face *other = changed_face("#f6c3a0", "#204a87"), *with = NULL, *again = NULL;
  const mien_face* faces[2];
  const char* names[2] = {"blue", "blue"};
  mien_texts* text = NULL;
  const size_t bytes = sizeof(double) * (size_t)mien_face_vector_size(rest);
  double *wanted, *got, *half, *before;
  int32_t i, between = 0;
  faces[0] = faces[1] = other;
  OK(mien_morphs_text(rest, names, faces, 1, &text, &error));
  CHECK(mien_texts_count(text) == 1 && holds(mien_texts_at(text, 0), "mien-morphs"));
  OK(mien_face_with_morphs_text(rest, mien_texts_at(text, 0), END, NULL, 0, &with, &error));
  CHECK(mien_face_name_count(with) == mien_face_name_count(rest) + 1);
  before = posed_with(rest, NULL), wanted = posed_with(other, NULL);
  got = posed_with(with, "blue=1"), half = posed_with(with, "blue=0.5");
  CHECK(memcmp(got, wanted, bytes) == 0 && memcmp(before, wanted, bytes) != 0);
  for (i = 0; i < mien_face_vector_size(rest); ++i)
    between += (half[i] - before[i]) * (wanted[i] - half[i]) > 0;
  CHECK(between > 0);
  free(got);
  got = posed_with(with, NULL); /* the rest is the rest */
  CHECK(memcmp(got, before, bytes) == 0);
  free(got), free(half), free(before), free(wanted);

  mien_texts_free(text);
  FAILS(MIEN_REFUSED, "blue", mien_morphs_text(rest, names, faces, 2, &text, &error));
  CHECK(text == NULL);
  FAILS(MIEN_UNREADABLE, "mine:1",
        mien_face_with_morphs_text(rest, "{", 1, "mine", END, &again, &error));
  OK(mien_morphs_text(rest, names, faces, 1, &text, &error));
  FAILS(MIEN_UNREADABLE, "blue", /* which it has already */
        mien_face_with_morphs_text(with, mien_texts_at(text, 0), END, NULL, 0, &again, &error));
  mien_texts_free(text), mien_face_free(with), mien_face_free(other);
}

static void test_misused(const mien_face* rest) {
  mien_error* error = NULL;
  mien_face* out = NULL;
  mien_texts* text = NULL;
  const mien_face* faces[1] = {NULL};
  const char* names[1] = {"a"};
  OK(mien_morphs_text(rest, NULL, NULL, 0, &text, &error));
  mien_texts_free(text);
  FAILS(MIEN_MISUSE, "count", mien_morphs_text(rest, names, faces, -1, &text, &error));
  FAILS(MIEN_MISUSE, "faces[0]", mien_morphs_text(rest, names, faces, 1, &text, &error));
  FAILS(MIEN_MISUSE, "names", mien_morphs_text(rest, NULL, faces, 1, &text, &error));
  FAILS(MIEN_MISUSE, "faces", mien_morphs_text(rest, names, NULL, 1, &text, &error));
  FAILS(MIEN_MISUSE, "rest", mien_morphs_text(NULL, names, faces, 0, &text, &error));
  FAILS(MIEN_MISUSE, "out", mien_morphs_text(rest, names, faces, 0, NULL, &error));
  FAILS(MIEN_UNREADABLE, "nowhere.morphs.json",
        mien_face_with_morphs(rest, "nowhere.morphs.json", END, &out, &error));
  FAILS(MIEN_MISUSE, "path", mien_face_with_morphs(rest, "", 0, &out, &error));
  FAILS(MIEN_MISUSE, "face", mien_face_with_morphs(NULL, "a", 1, &out, &error));
  FAILS(MIEN_MISUSE, "out", mien_face_with_morphs(rest, "a", 1, NULL, &error));
  FAILS(MIEN_MISUSE, "text", mien_face_with_morphs_text(rest, NULL, 4, NULL, 0, &out, &error));
  FAILS(MIEN_MISUSE, "face", mien_face_with_morphs_text(NULL, "{", 1, NULL, 0, &out, &error));
}

void test_morphs(void) {
  mien_face* rest = any_face();
  test_made(rest);
  test_misused(rest);
  mien_face_free(rest);
}
