// What people are made of: the families, parts, numbers and styles of recipes; and which name was meant.

#include <mien/recipe.h>
#include "bind/c/door_private.h"
#include "bind/c/handles_private.h"
#include "lib/base/nearest_name.h"

#include <algorithm>

using namespace mien::c;

namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

/// The one of that name, or a refusal that names the nearest.
template <class Named>
const Named& named(const std::vector<Named>& all, std::string_view what, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found != all.end()) return *found;
  const std::vector<std::string> names = names_of(all);
  refuse(std::string(name), mien::unknown_name(what, name, {names.begin(), names.end()}));
}

}  // namespace

extern "C" {

mien_status mien_unknown_name(const char* what, size_t what_length, const char* wanted,
                              size_t wanted_length, const char* names, size_t names_length,
                              mien_texts** out, mien_error** error) {
  return pass("mien_unknown_name", error, [&] {
    mien_texts*& made = place(out);
    std::vector<std::string_view> known;
    for (auto left = text_of(names, names_length, "names"); !left.empty();) {
      known.push_back(left.substr(0, left.find('\n')));
      left.remove_prefix(std::min(left.size(), known.back().size() + 1));
    }
    made = new_texts({mien::unknown_name(text_of(what, what_length, "what"),
                                         text_of(wanted, wanted_length, "wanted"), known)});
  });
}

mien_status mien_part_families(mien_texts** out, mien_error** error) {
  return pass("mien_part_families", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts(names_of(mien::part_families()));
  });
}

mien_status mien_part_names(const char* family, size_t length, mien_texts** out,
                            mien_error** error) {
  return pass("mien_part_names", error, [&] {
    mien_texts*& made = place(out);
    const auto families = mien::part_families();
    const auto& of = named(families, "family", text_of(family, length, "family"));
    std::vector<std::string> names = of.parts;
    if (of.optional) names.insert(names.begin(), "none");
    made = new_texts(std::move(names));
  });
}

mien_status mien_part_numbers(mien_texts** out, mien_error** error) {
  return pass("mien_part_numbers", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts(names_of(mien::part_numbers()));
  });
}

mien_status mien_part_number(const char* name, size_t length, double out[3], mien_error** error) {
  return pass("mien_part_number", error, [&] {
    need(out, "out");
    const auto numbers = mien::part_numbers();
    const auto& of = named(numbers, "number", text_of(name, length, "name"));
    out[0] = of.lo, out[1] = of.hi, out[2] = of.rest;
  });
}

mien_status mien_part_styles(mien_texts** out, mien_error** error) {
  return pass("mien_part_styles", error, [&] {
    mien_texts*& made = place(out);
    made = new_texts(mien::part_styles());
  });
}
}
