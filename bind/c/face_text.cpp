// Face files with other numbers, where in them numbers stand, and faces of recipes in full.

#include <mien/face_edit.h>
#include <mien/face_pointers.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "lib/parts/recipe/recipe_file.h"

#include <fmt/format.h>

#include <iterator>

using namespace mien::c;

namespace {

std::string_view name_of(const char* name, size_t length) {
  return name ? text_of(name, length, "name") : std::string_view("face");
}

std::vector<std::string> settings_of(const char* const* settings, int32_t count) {
  if (count < 0) misuse("count", "is " + std::to_string(count));
  if (count > 0) need(settings, "settings");
  std::vector<std::string> all;
  for (int32_t i = 0; i < count; ++i)
    all.emplace_back(&need(settings[i], fmt::format("settings[{}]", i)));
  return all;
}

}  // namespace

extern "C" {

mien_status mien_face_pointers(const char* text, size_t length, const char* name,
                               size_t name_length, mien_texts** out, mien_error** error) {
  return pass("mien_face_pointers", error, [&] {
    mien_texts*& made = place(out);
    const auto whole = text_of(text, length, "text");
    made = new_texts(must(mien::face_pointers(whole, name_of(name, name_length)), MIEN_UNREADABLE));
  });
}

mien_status mien_face_text_with(const char* text, size_t length, const char* name,
                                size_t name_length, const char* const* settings, int32_t count,
                                mien_texts** out, mien_error** error) {
  return pass("mien_face_text_with", error, [&] {
    mien_texts*& made = place(out);
    const auto whole = text_of(text, length, "text");
    const auto called = name_of(name, name_length);
    const std::vector<std::string> wanted = settings_of(settings, count);
    auto edited = mien::edit_face_text(whole, wanted, called);
    if (!edited) {
      const bool is_face = bool(mien::face_pointers(whole, called));
      throw Refusal{is_face ? MIEN_REFUSED : MIEN_UNREADABLE, edited.error()};
    }
    std::vector<std::string> texts{std::move(edited->text)};
    std::move(edited->left.begin(), edited->left.end(), std::back_inserter(texts));
    made = new_texts(std::move(texts));
  });
}

mien_status mien_recipe_in_full(const char* text, size_t length, const char* name,
                                size_t name_length, mien_texts** out, mien_error** error) {
  return pass("mien_recipe_in_full", error, [&] {
    mien_texts*& made = place(out);
    const auto whole = text_of(text, length, "text");
    const auto recipe =
        must(mien::read_recipe_text(whole, name_of(name, name_length)), MIEN_UNREADABLE);
    made = new_texts({must(mien::face_text_from_recipe(recipe), MIEN_UNREADABLE)});
  });
}
}
