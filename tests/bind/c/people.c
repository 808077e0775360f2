#include <string.h>

#include "tests/bind/c/check.h"

static const uint64_t kTooLarge = (uint64_t)1 << 50;

static void test_seeds(void) {
  mien_error* error = NULL;
  uint64_t seed = 0, again = 1;
  mien_texts *code = NULL, *recipe = NULL, *other = NULL;
  mien_face* face = NULL;
  OK(mien_seed_from_word("ada", END, &seed, &error));
  OK(mien_seed_from_word("ada and others", 3, &again, &error));
  CHECK(seed == again && seed < kTooLarge);
  OK(mien_code_from_seed(seed, &code, &error));
  CHECK(mien_texts_count(code) == 1 && mien_texts_at(code, 1)[0] == 0);
  OK(mien_recipe_from_seed(seed, &recipe, &error));
  OK(mien_recipe_from_code(mien_texts_at(code, 0), END, &other, &error));
  CHECK(holds(mien_texts_at(recipe, 0), "format_version"));
  OK(mien_face_read_text(mien_texts_at(other, 0), END, "recipe", END, &face, &error));
  mien_face_free(face);
  OK(mien_face_from_code(mien_texts_at(code, 0), END, &face, &error));
  CHECK(mien_face_name_count(face) > 100);
  mien_face_free(face);
  mien_texts_free(code), mien_texts_free(recipe), mien_texts_free(other);

  FAILS(MIEN_REFUSED, "2^50", mien_code_from_seed(kTooLarge, &code, &error));
  FAILS(MIEN_REFUSED, "2^50", mien_recipe_from_seed(kTooLarge, &code, &error));
  FAILS(MIEN_MISUSE, "out", mien_seed_from_word("ada", END, NULL, &error));
  FAILS(MIEN_MISUSE, "word", mien_seed_from_word(NULL, END, &seed, &error));
  FAILS(MIEN_UNREADABLE, NULL, mien_face_from_code("AA7Q2-MKX4T-XM", END, &face, &error));
  FAILS(MIEN_UNREADABLE, NULL, mien_recipe_from_code("", 0, &code, &error));
  FAILS(MIEN_MISUSE, "out", mien_code_from_seed(1, NULL, &error));
  FAILS(MIEN_MISUSE, "out", mien_recipe_from_seed(1, NULL, &error));
  FAILS(MIEN_MISUSE, "out", mien_recipe_from_code("x", END, NULL, &error));
}

static void test_relatives(const char* one, const char* other) {
  mien_error* error = NULL;
  mien_texts *near = NULL, *ends = NULL, *child = NULL, *held = NULL;
  double far = -1;
  OK(mien_code_near(one, END, 0.3, 7, &near, &error));
  OK(mien_code_difference(one, END, mien_texts_at(near, 0), END, &far, &error));
  CHECK(far > 0);
  OK(mien_code_difference(one, END, one, END, &far, &error));
  CHECK(far == 0);
  OK(mien_code_between(one, END, other, END, 0, &ends, &error));
  OK(mien_code_difference(one, END, mien_texts_at(ends, 0), END, &far, &error));
  CHECK(far < 0.1);
  OK(mien_code_of_child(one, END, other, END, 3, &child, &error));
  OK(mien_code_hold(one, END, "eye.size=1.05", END, 0, &held, &error));
  CHECK(holds(mien_texts_at(held, 0), "~"));
  mien_texts_free(held);
  FAILS(MIEN_REFUSED, NULL, mien_code_hold(one, END, "eye.size=99", END, 0, &held, &error));
  CHECK(held == NULL);
  OK(mien_code_hold(one, END, "eye.size=99", END, 1, &held, &error));
  mien_texts_free(near), mien_texts_free(ends), mien_texts_free(child), mien_texts_free(held);

  mien_texts *calm = NULL, *calmer = NULL, *recipe = NULL;
  OK(mien_code_hold(one, END, "smile=0.8", END, 0, &held, &error));
  OK(mien_code_neutral(mien_texts_at(held, 0), END, &calm, &error));
  OK(mien_recipe_from_code(mien_texts_at(calm, 0), END, &recipe, &error));
  CHECK(!holds(mien_texts_at(recipe, 0), "\"smile\": 0.8") &&
        !holds(mien_texts_at(recipe, 0), "grin"));
  OK(mien_code_neutral(mien_texts_at(calm, 0), END, &calmer, &error));
  CHECK(strcmp(mien_texts_at(calm, 0), mien_texts_at(calmer, 0)) == 0);
  FAILS(MIEN_UNREADABLE, NULL, mien_code_neutral("nobody", END, &near, &error));
  mien_texts_free(calm), mien_texts_free(calmer), mien_texts_free(recipe), mien_texts_free(held);

  FAILS(MIEN_REFUSED, "by", mien_code_near(one, END, 1.5, 7, &near, &error));
  FAILS(MIEN_REFUSED, "2^50", mien_code_near(one, END, 0.5, kTooLarge, &near, &error));
  FAILS(MIEN_REFUSED, "at", mien_code_between(one, END, other, END, -1, &ends, &error));
  FAILS(MIEN_MISUSE, "other", mien_code_between(one, END, NULL, END, 0, &ends, &error));
  FAILS(MIEN_UNREADABLE, NULL, mien_code_of_child(one, END, "?", END, 3, &child, &error));
  FAILS(MIEN_MISUSE, "out", mien_code_difference(one, END, other, END, NULL, &error));
  FAILS(MIEN_MISUSE, "held", mien_code_hold(one, END, NULL, 9, 0, &held, &error));
}

static void test_parts(void) {
  mien_error* error = NULL;
  mien_texts *families = NULL, *list = NULL;
  double range[3] = {0, 0, 0};
  OK(mien_part_families(&families, &error));
  CHECK(mien_texts_count(families) > 10);
  for (int32_t i = 0; i < mien_texts_count(families); ++i) {
    OK(mien_part_names(mien_texts_at(families, i), END, &list, &error));
    CHECK(mien_texts_count(list) > 0);
    mien_texts_free(list);
  }
  mien_texts_free(families);
  OK(mien_part_names("glasses", END, &list, &error));
  CHECK(strcmp(mien_texts_at(list, 0), "none") == 0 && mien_texts_count(list) > 3);
  mien_texts_free(list);
  OK(mien_part_names("mouth", END, &list, &error));
  CHECK(strcmp(mien_texts_at(list, 0), "none") != 0);
  mien_texts_free(list);
  OK(mien_part_styles(&list, &error));
  CHECK(mien_texts_count(list) > 1);
  mien_texts_free(list);
  OK(mien_part_numbers(&list, &error));
  for (int32_t i = 0; i < mien_texts_count(list); ++i) {
    OK(mien_part_number(mien_texts_at(list, i), END, range, &error));
    CHECK(range[0] < range[1] && range[0] <= range[2] && range[2] <= range[1]);
  }
  mien_texts_free(list);

  OK(mien_unknown_name("key", END, "Tilt", END, "yaw\npitch\nroll\n", END, &list, &error));
  CHECK(strcmp(mien_texts_at(list, 0), "no key named \"Tilt\"; did you mean \"roll\"?") == 0);
  mien_texts_free(list);
  OK(mien_unknown_name("key", END, "yaw", END, "", 0, &list, &error));
  CHECK(strcmp(mien_texts_at(list, 0), "no key named \"yaw\"") == 0);
  mien_texts_free(list);
  FAILS(MIEN_MISUSE, "wanted", mien_unknown_name("key", END, NULL, 3, "", 0, &list, &error));
  FAILS(MIEN_REFUSED, "did you mean \"hair\"", mien_part_names("hai", END, &list, &error));
  FAILS(MIEN_REFUSED, "did you mean \"age\"", mien_part_number("aged", END, range, &error));
  FAILS(MIEN_MISUSE, "out", mien_part_number("age", END, NULL, &error));
  FAILS(MIEN_MISUSE, "family", mien_part_names(NULL, 3, &list, &error));
  FAILS(MIEN_MISUSE, "out", mien_part_numbers(NULL, &error));
  FAILS(MIEN_MISUSE, "out", mien_part_styles(NULL, &error));
}

void test_people(void) {
  mien_error* error = NULL;
  mien_texts *three = NULL, *five = NULL;
  test_seeds();
  test_parts();
  OK(mien_crowd("chorus", END, 3, &three, &error));
  OK(mien_crowd("chorus", END, 5, &five, &error));
  CHECK(mien_texts_count(three) == 3 && mien_texts_count(five) == 5);
  CHECK(strcmp(mien_texts_at(three, 2), mien_texts_at(five, 2)) == 0);
  CHECK(strcmp(mien_texts_at(five, 3), mien_texts_at(five, 4)) != 0);
  test_relatives(mien_texts_at(five, 0), mien_texts_at(five, 1));
  mien_texts_free(three), mien_texts_free(five);
  OK(mien_crowd("chorus", END, 0, &three, &error));
  CHECK(mien_texts_count(three) == 0);
  mien_texts_free(three);
  FAILS(MIEN_REFUSED, "people", mien_crowd("chorus", END, -1, &three, &error));
  FAILS(MIEN_REFUSED, "people", mien_crowd("chorus", END, 2000000000, &three, &error));
  FAILS(MIEN_MISUSE, "out", mien_crowd("chorus", END, 1, NULL, &error));
}
