#include <string.h>

#include "tests/bind/c/check.h"

void test_errors(void) {
  mien_error* error;
  CHECK(mien_version() > 0 && mien_abi_version() == MIEN_C_ABI);
  CHECK(mien_version_text()[0] != 0);
  CHECK(strcmp(mien_error_what(NULL), "") == 0 && strcmp(mien_error_where(NULL), "") == 0);
  mien_error_free(NULL);
  error = mien_error_new("here", END, "and thus", 3);
  CHECK(strcmp(mien_error_where(error), "here") == 0);
  CHECK(strcmp(mien_error_what(error), "and") == 0);
  mien_error_free(error);
  error = mien_error_new(NULL, 4, "x", END);
  CHECK(holds(mien_error_what(error), "NULL"));
  mien_error_free(error);
  CHECK(mien_texts_count(NULL) == 0 && strcmp(mien_texts_at(NULL, 0), "") == 0);
  mien_texts_free(NULL);
  /* nobody has to want the error */
  CHECK(mien_face_from_code("x", END, NULL, NULL) == MIEN_MISUSE);
}

static void test_reading(void) {
  mien_error* error = NULL;
  mien_face* face = NULL;
  OK(mien_face_read(face_path(), strlen(face_path()), &face, &error));
  mien_face_free(face);
  FAILS(MIEN_UNREADABLE, "no/such", mien_face_read("no/such.json", END, &face, &error));
  CHECK(face == NULL);
  FAILS(MIEN_MISUSE, "path: is NULL", mien_face_read(NULL, END, &face, &error));
  FAILS(MIEN_MISUSE, "is empty", mien_face_read("", END, &face, &error));
  FAILS(MIEN_MISUSE, "holds a NUL", mien_face_read("a\0b", 3, &face, &error));
  FAILS(MIEN_MISUSE, "out: is NULL", mien_face_read(face_path(), END, NULL, &error));
  FAILS(MIEN_UNREADABLE, "mine:1:", mien_face_read_text("{", 1, "mine", END, &face, &error));
  FAILS(MIEN_UNREADABLE, "face", mien_face_read_text("{}", END, NULL, 0, &face, &error));
  FAILS(MIEN_UNREADABLE, NULL, mien_face_read_text(NULL, 0, NULL, 0, &face, &error));
  FAILS(MIEN_MISUSE, "text: is NULL", mien_face_read_text(NULL, 3, NULL, 0, &face, &error));
  FAILS(MIEN_MISUSE, "longer", mien_face_read_text("{}", (size_t)-2, NULL, 0, &face, &error));
}

static void test_names(const mien_face* face) {
  mien_error* error = NULL;
  mien_name name;
  double values[4] = {7, 7, 7, 7};
  int32_t i, controls = 0, numbers = 0;
  const int32_t count = mien_face_name_count(face);
  name.size = sizeof name;
  for (i = 0; i < count; ++i) {
    OK(mien_face_name_at(face, i, &name, &error));
    CHECK(name.name[0] != 0 && name.count > 0 && name.lo < name.hi && name.reserved == 0);
    CHECK(name.is_control ? name.begin == -1 : name.begin == numbers);
    if (name.is_control) {
      ++controls;
      OK(mien_face_values_at(face, i, values, 1, &error));
      CHECK(values[0] >= name.lo && values[0] <= name.hi);
    } else {
      numbers += name.count;
    }
  }
  CHECK(controls > 0 && numbers == mien_face_vector_size(face));
  FAILS(MIEN_MISUSE, "index", mien_face_name_at(face, count, &name, &error));
  FAILS(MIEN_MISUSE, "index", mien_face_name_at(face, -1, &name, &error));
  FAILS(MIEN_MISUSE, "out: is NULL", mien_face_name_at(face, 0, NULL, &error));
  FAILS(MIEN_MISUSE, "face: is NULL", mien_face_name_at(NULL, 0, &name, &error));
  FAILS(MIEN_MISUSE, "count", mien_face_values_at(face, 0, values, 2, &error));
  FAILS(MIEN_MISUSE, "count", mien_face_values_at(face, 0, values, -1, &error));
  FAILS(MIEN_MISUSE, "values: is NULL", mien_face_values_at(face, 0, NULL, 1, &error));
  FAILS(MIEN_MISUSE, "face: is NULL", mien_face_values_at(NULL, 0, values, 1, &error));
  name.size = sizeof name + 8;
  FAILS(MIEN_MISUSE, "older", mien_face_name_at(face, 0, &name, &error));
  name.size = 0;
  FAILS(MIEN_MISUSE, "size", mien_face_name_at(face, 0, &name, &error));
  name.size = 16, name.begin = 99; /* an older caller's: nothing beyond is written */
  OK(mien_face_name_at(face, 0, &name, &error));
  CHECK(name.size == 16 && name.begin == 99);
}

static void test_canvas(const mien_face* face) {
  mien_error* error = NULL;
  mien_canvas canvas;
  canvas.size = sizeof canvas;
  OK(mien_face_canvas(face, &canvas, &error));
  CHECK(canvas.box[0] < canvas.box[2] && canvas.box[1] < canvas.box[3] && canvas.unit[0] != 0);
  FAILS(MIEN_MISUSE, "face", mien_face_canvas(NULL, &canvas, &error));
  FAILS(MIEN_MISUSE, "out", mien_face_canvas(face, NULL, &error));
}

void test_faces(void) {
  mien_face* face = any_face();
  int32_t clips = mien_face_clip_count(face);
  test_reading();
  CHECK(mien_face_retain(face) == face);
  mien_face_free(face);
  CHECK(strcmp(mien_face_title(face), "") != 0);
  CHECK(mien_face_credit(face) != NULL);
  test_names(face);
  test_canvas(face);
  CHECK(clips > 0 && mien_face_clip_name(face, 0)[0] != 0);
  CHECK(mien_face_clip_name(face, clips)[0] == 0 && mien_face_clip_name(face, -1)[0] == 0);
  CHECK(mien_face_clip_length(face, 0) > 0);
  CHECK(mien_face_clip_length(face, clips) == 0 && mien_face_clip_length(face, -1) == 0);
  mien_face_free(face);

  CHECK(mien_face_retain(NULL) == NULL);
  mien_face_free(NULL);
  CHECK(mien_face_title(NULL)[0] == 0 && mien_face_credit(NULL)[0] == 0);
  CHECK(mien_face_name_count(NULL) == 0 && mien_face_vector_size(NULL) == 0);
  CHECK(mien_face_clip_count(NULL) == 0 && mien_face_clip_name(NULL, 0)[0] == 0);
  CHECK(mien_face_clip_length(NULL, 0) == 0);
}
