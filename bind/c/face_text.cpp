// Face files with other numbers, and where in them numbers stand.

#include <mien/face_edit.h>
#include <mien/face_pointers.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"

#include <fmt/format.h>

#include <iterator>

using namespace mien::c;

namespace {

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
    made = new_texts(
        must(mien::face_pointers(whole, name_of(name, name_length, "face")), MIEN_UNREADABLE));
  });
}

mien_status mien_face_text_with(const char* text, size_t length, const char* name,
                                size_t name_length, const char* const* settings, int32_t count,
                                mien_texts** out, mien_error** error) {
  return pass("mien_face_text_with", error, [&] {
    mien_texts*& made = place(out);
    const auto whole = text_of(text, length, "text");
    const auto called = name_of(name, name_length, "face");
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
}
