#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bind/c/check.h"

/* The text of the face's file; the caller frees it. */
static char* file_text(size_t* length) {
  FILE* file = fopen(face_path(), "rb");
  char* text = calloc(1, 1 << 20);
  *length = fread(text, 1, (1 << 20) - 1, file);
  fclose(file);
  return text;
}

static void test_pointers(const char* text, size_t length) {
  mien_error* error = NULL;
  mien_texts* pointers = NULL;
  mien_face* face = any_face();
  mien_name name;
  int32_t i, slices = 0;
  name.size = sizeof name;
  OK(mien_face_pointers(text, length, NULL, 0, &pointers, &error));
  CHECK(mien_texts_count(pointers) == mien_face_name_count(face));
  for (i = 0; i < mien_texts_count(pointers); ++i) {
    OK(mien_face_name_at(face, i, &name, &error));
    if (name.is_control) CHECK(mien_texts_at(pointers, i)[0] == 0);
    if (strcmp(name.name, "palette/skin") == 0)
      CHECK(strcmp(mien_texts_at(pointers, i), "/palette/skin") == 0);
    slices += mien_texts_at(pointers, i)[0] == '/';
  }
  CHECK(slices > 100);
  mien_texts_free(pointers);
  mien_face_free(face);
  FAILS(MIEN_UNREADABLE, "mine:1", mien_face_pointers("{", 1, "mine", END, &pointers, &error));
  CHECK(pointers == NULL);
  FAILS(MIEN_MISUSE, "text", mien_face_pointers(NULL, 3, NULL, 0, &pointers, &error));
  FAILS(MIEN_MISUSE, "out", mien_face_pointers(text, length, NULL, 0, NULL, &error));
}

static void test_recipes_in_full(const char* in_full, size_t length) {
  mien_error* error = NULL;
  mien_texts *recipe = NULL, *made = NULL;
  mien_face* face = NULL;
  OK(mien_recipe_from_code("A66CB-AA5S0-14", END, &recipe, &error));
  OK(mien_recipe_in_full(mien_texts_at(recipe, 0), END, NULL, 0, &made, &error));
  CHECK(mien_texts_count(made) == 1 && holds(mien_texts_at(made, 0), "\"format_version\": 1"));
  OK(mien_face_read_text(mien_texts_at(made, 0), END, NULL, 0, &face, &error));
  mien_face_free(face);
  mien_texts_free(recipe);
  mien_texts_free(made);
  FAILS(MIEN_UNREADABLE, "mine:", mien_recipe_in_full(in_full, length, "mine", END, &made, &error));
  CHECK(made == NULL);
  FAILS(MIEN_MISUSE, "text", mien_recipe_in_full(NULL, 3, NULL, 0, &made, &error));
  FAILS(MIEN_MISUSE, "out", mien_recipe_in_full(in_full, length, NULL, 0, NULL, &error));
}

static void test_edits(const char* text, size_t length) {
  mien_error* error = NULL;
  mien_texts *made = NULL, *same = NULL;
  mien_face* face = NULL;
  const char* settings[3] = {"palette/skin=#102030", "gaze.x=0.01", "palette/skin=#123456"};
  const char* unknown[1] = {"palette/skim=#102030"};
  const char* none[1] = {NULL};
  OK(mien_face_text_with(text, length, NULL, 0, settings, 3, &made, &error));
  CHECK(mien_texts_count(made) == 2 && strcmp(mien_texts_at(made, 1), "gaze.x") == 0);
  CHECK(holds(mien_texts_at(made, 0), "#123456") && !holds(text, "#123456"));
  OK(mien_face_read_text(mien_texts_at(made, 0), END, NULL, 0, &face, &error));
  mien_face_free(face);
  mien_texts_free(made);
  OK(mien_face_text_with(text, length, NULL, 0, NULL, 0, &same, &error));
  CHECK(mien_texts_count(same) == 1 && strcmp(mien_texts_at(same, 0), text) == 0);
  mien_texts_free(same);
  FAILS(MIEN_REFUSED, "skim",
        mien_face_text_with(text, length, NULL, 0, unknown, 1, &made, &error));
  CHECK(made == NULL);
  FAILS(MIEN_UNREADABLE, "mine:1",
        mien_face_text_with("{", 1, "mine", END, NULL, 0, &made, &error));
  FAILS(MIEN_MISUSE, "count",
        mien_face_text_with(text, length, NULL, 0, settings, -1, &made, &error));
  FAILS(MIEN_MISUSE, "settings",
        mien_face_text_with(text, length, NULL, 0, NULL, 1, &made, &error));
  FAILS(MIEN_MISUSE, "settings[0]",
        mien_face_text_with(text, length, NULL, 0, none, 1, &made, &error));
  FAILS(MIEN_MISUSE, "text", mien_face_text_with(NULL, 2, NULL, 0, NULL, 0, &made, &error));
  FAILS(MIEN_MISUSE, "out", mien_face_text_with(text, length, NULL, 0, NULL, 0, NULL, &error));
}

void test_face_texts(void) {
  size_t length;
  char* text = file_text(&length);
  test_pointers(text, length);
  test_recipes_in_full(text, length);
  test_edits(text, length);
  free(text);
}
