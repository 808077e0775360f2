// People by seeds, words and codes.

#include <mien/crowd.h>
#include <mien/recipe.h>
#include <mien/relatives.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "lib/parts/code/code_fields.h"
#include "lib/parts/recipe/recipe_file.h"

#include <algorithm>

using namespace mien::c;

namespace {

constexpr int32_t kMostPeople = 100'000;

mien::FaceCode code_of(const char* text, size_t length, std::string_view argument) {
  return must(mien::read_face_code(text_of(text, length, argument)), MIEN_UNREADABLE);
}

mien_texts* one_code(const mien::FaceCode& code) {
  return new_texts({mien::face_code_text(code)});
}

uint64_t need_seed(uint64_t seed) {
  if (seed >> mien::FaceCode::kSeedBits) refuse("seed", "expected a number below 2^50");
  return seed;
}

double need_share(double share, std::string_view argument) {
  if (!(share >= 0 && share <= 1)) refuse(std::string(argument), "expected a number from 0 to 1");
  return share;
}

}  // namespace

extern "C" {

mien_status mien_seed_from_word(const char* word, size_t length, uint64_t* out,
                                mien_error** error) {
  return pass("mien_seed_from_word", error, [&] {
    need(out, "out") = 0;
    *out = mien::seed_from_word(text_of(word, length, "word"));
  });
}

mien_status mien_code_from_seed(uint64_t seed, mien_texts** out, mien_error** error) {
  return pass("mien_code_from_seed", error, [&] {
    mien_texts*& made = place(out);
    made = one_code({.seed = need_seed(seed), .held = {}});
  });
}

mien_status mien_recipe_from_seed(uint64_t seed, mien_texts** out, mien_error** error) {
  return pass("mien_recipe_from_seed", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts({mien::recipe_text(mien::recipe_from_seed(need_seed(seed)))});
  });
}

mien_status mien_recipe_from_code(const char* code, size_t length, mien_texts** out,
                                  mien_error** error) {
  return pass("mien_recipe_from_code", error, [&] {
    mien_texts*& made = place(out);
    const auto recipe =
        must(mien::recipe_from_code(code_of(code, length, "code")), MIEN_UNREADABLE);
    made = new_texts({mien::recipe_text(recipe)});
  });
}

mien_status mien_recipe_in_full(const char* text, size_t length, const char* name,
                                size_t name_length, mien_texts** out, mien_error** error) {
  return pass("mien_recipe_in_full", error, [&] {
    mien_texts*& made = place(out);
    const auto whole = text_of(text, length, "text");
    const auto recipe =
        must(mien::read_recipe_text(whole, name_of(name, name_length, "face")), MIEN_UNREADABLE);
    made = new_texts({must(mien::face_text_from_recipe(recipe), MIEN_UNREADABLE)});
  });
}

mien_status mien_code_hold(const char* code, size_t length, const char* held, size_t held_length,
                           int32_t clamp, mien_texts** out, mien_error** error) {
  return pass("mien_code_hold", error, [&] {
    mien_texts*& made = place(out);
    mien::FaceCode changed = code_of(code, length, "code");
    const auto value =
        must(mien::read_held_value(text_of(held, held_length, "held"), clamp != 0), MIEN_REFUSED);
    std::erase_if(changed.held,
                  [&](const mien::HeldValue& one) { return one.field == value.field; });
    changed.held.push_back(value);
    made = one_code(changed);
  });
}

mien_status mien_code_neutral(const char* code, size_t length, mien_texts** out,
                              mien_error** error) {
  return pass("mien_code_neutral", error, [&] {
    mien_texts*& made = place(out);
    auto recipe = must(mien::recipe_from_code(code_of(code, length, "code")), MIEN_UNREADABLE);
    const auto neutral = mien::neutral_recipe(std::move(recipe));
    made = one_code(must(mien::code_of_recipe(neutral), MIEN_UNREADABLE));
  });
}

mien_status mien_code_near(const char* code, size_t length, double by, uint64_t seed,
                           mien_texts** out, mien_error** error) {
  return pass("mien_code_near", error, [&] {
    mien_texts*& made = place(out);
    const auto from = code_of(code, length, "code");
    made = one_code(
        must(mien::code_near(from, need_share(by, "by"), need_seed(seed)), MIEN_UNREADABLE));
  });
}

mien_status mien_code_between(const char* one, size_t one_length, const char* other,
                              size_t other_length, double at, mien_texts** out,
                              mien_error** error) {
  return pass("mien_code_between", error, [&] {
    mien_texts*& made = place(out);
    const auto from = code_of(one, one_length, "one"), to = code_of(other, other_length, "other");
    made = one_code(must(mien::code_between(from, to, need_share(at, "at")), MIEN_UNREADABLE));
  });
}

mien_status mien_code_of_child(const char* one, size_t one_length, const char* other,
                               size_t other_length, uint64_t seed, mien_texts** out,
                               mien_error** error) {
  return pass("mien_code_of_child", error, [&] {
    mien_texts*& made = place(out);
    const auto from = code_of(one, one_length, "one"), to = code_of(other, other_length, "other");
    made = one_code(must(mien::code_of_child(from, to, need_seed(seed)), MIEN_UNREADABLE));
  });
}

mien_status mien_code_difference(const char* one, size_t one_length, const char* other,
                                 size_t other_length, double* out, mien_error** error) {
  return pass("mien_code_difference", error, [&] {
    need(out, "out") = 0;
    const auto from = code_of(one, one_length, "one"), to = code_of(other, other_length, "other");
    *out = must(mien::difference(from, to), MIEN_UNREADABLE);
  });
}

mien_status mien_crowd(const char* word, size_t length, int32_t count, mien_texts** out,
                       mien_error** error) {
  return pass("mien_crowd", error, [&] {
    mien_texts*& made = place(out);
    if (count < 0 || count > kMostPeople)
      refuse("count", "expected 0 to " + std::to_string(kMostPeople) + " people, got " +
                          std::to_string(count));
    std::vector<std::string> codes;
    for (const auto& code : mien::crowd(text_of(word, length, "word"), count))
      codes.push_back(mien::face_code_text(code));
    made = new_texts(std::move(codes));
  });
}
}
