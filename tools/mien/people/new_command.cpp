// mien new: a face out of parts, by a seed, a code and what is held; its code is printed. mien parts: what there is.

#include <mien/composed_face.h>
#include <mien/recipe.h>
#include <mien/relatives.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/parts/library/part_library.h"
#include "lib/parts/recipe/own_part.h"
#include "render/image/file/written_file.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

namespace mien::command {
namespace {

constexpr std::size_t kLongCode = 40;  ///< signs that people still copy

/// A new seed at each call, from the time in nanoseconds.
std::uint64_t new_seed() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return seed_from_word(
      std::to_string(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()));
}

Expected<FaceCode> read_relative(const NewArguments& arguments, std::uint64_t seed) {
  if (arguments.near) {
    const auto code = read_face_code(*arguments.near);
    if (!code) return code.error();
    const auto by = read_share("by", arguments.by.value_or("0.3"));
    if (!by) return by.error();
    return code_near(*code, *by, seed);
  }
  const std::vector<std::string>& two =
      arguments.between.empty() ? arguments.child_of : arguments.between;
  const auto one = read_face_code(two[0]), other = read_face_code(two[1]);
  if (!one) return one.error();
  if (!other) return other.error();
  if (arguments.between.empty()) return code_of_child(*one, *other, seed);
  const auto at = read_share("at", arguments.at.value_or("0.5"));
  if (!at) return at.error();
  return code_between(*one, *other, *at);
}

Expected<FaceCode> read_code(const NewArguments& arguments) {
  FaceCode code{.seed = arguments.seed ? seed_from_word(*arguments.seed) : new_seed(), .held = {}};
  if (arguments.code) {
    auto given = read_face_code(*arguments.code);
    if (!given) return Error{"--" + given.error().where, given.error().what};
    code = *std::move(given);
  } else if (arguments.near || !arguments.between.empty() || !arguments.child_of.empty()) {
    auto relative = read_relative(arguments, code.seed);
    if (!relative) return relative.error();
    code = *std::move(relative);
  }
  for (const std::string& text : arguments.held) {
    const auto held = read_held_value(text, arguments.clamp);
    if (!held) return Error{"--hold " + held.error().where, held.error().what};
    std::erase_if(code.held, [&](const HeldValue& one) { return one.field == held->field; });
    code.held.push_back(*held);
  }
  return code;
}

/// The first code that cannot be read: as in other commands, that is no wrong use.
std::optional<Error> wrong_code(const NewArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> codes;
  if (arguments.code) codes.emplace_back("--code", *arguments.code);
  if (arguments.near) codes.emplace_back("--near", *arguments.near);
  for (const std::string& one : arguments.between) codes.emplace_back("--between", one);
  for (const std::string& one : arguments.child_of) codes.emplace_back("--child-of", one);
  for (const auto& [option, text] : codes)
    if (const auto read = read_face_code(text); !read)
      return Error{option + " " + one_line(text, 60), read.error().what};
  return {};
}

}  // namespace

int new_command(const NewArguments& arguments) {
  const int ways = int(arguments.code.has_value()) + int(arguments.near.has_value()) +
                   int(!arguments.between.empty()) + int(!arguments.child_of.empty());
  if (ways > 1)
    return complain("--code, --near, --between and --child-of: one of them", kUsedWrongly);
  if (arguments.code && arguments.seed)
    return complain("--seed: the --code has a seed of its own", kUsedWrongly);
  if (arguments.by && !arguments.near) return complain("--by is how far from --near", kUsedWrongly);
  if (arguments.at && arguments.between.empty())
    return complain("--at is where --between", kUsedWrongly);
  if (const auto wrong = wrong_code(arguments)) return complain(*wrong, kFailed);
  const auto code = read_code(arguments);
  if (!code) return complain(code.error(), kUsedWrongly);
  auto recipe = recipe_from_code(*code);
  if (!recipe) return complain(recipe.error(), kFailed);
  if (arguments.style) recipe->style = *arguments.style;
  auto text = face_text_from_recipe(*recipe);
  if (!text) return complain(text.error(), kUsedWrongly);
  if (!arguments.flat) text = recipe_text(*recipe);
  const std::string said = face_code_text(*code);
  if (!arguments.output && said.size() > kLongCode)
    warn({Error{"code",
                fmt::format("of {} signs; -o FILE keeps the person in a file", said.size())}});
  if (!arguments.output) return print(said + "\n");
  const auto done = write_file(*arguments.output, [&](const PutBytes& put) -> Expected<Done> {
    return put(text->data(), text->size());
  });
  if (!done) return complain(done.error(), kFailed);
  return *arguments.output == "-" ? int(kDone) : print(face_code_text(*code) + "\n");
}

namespace {

int begin_part(const PartsArguments& arguments) {
  const auto text = part_skeleton(*arguments.family, arguments.name);
  if (!text) return complain(text.error(), kUsedWrongly);
  const std::string path = arguments.output.value_or(arguments.name + ".part.json");
  std::error_code unknown;  // set if there is none, too
  if (path != "-" && std::filesystem::exists(path, unknown))
    return complain({path, "is there already"}, kFailed);
  const auto done =
      write_file(path, [&](const PutBytes& put) { return put(text->data(), text->size()); });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

/// Composing the plain face first finds faults in the files, in their own places.
int check_parts(const PartsArguments& arguments) {
  CheckArguments check{.faces = {}, .people = {arguments.people.value_or("100")}};
  check.nonsense = true;
  check.seed = arguments.seed;
  check.output = arguments.output;
  Recipe plain;
  for (const std::string& file : arguments.files) {
    auto part = read_part_file(file);
    if (!part) return complain(part.error(), kFailed);
    wear(plain, *part);
    check.worn.push_back(file);
  }
  if (const auto face = face_from_recipe(plain, face_letters()); !face)
    return complain(face.error(), kFailed);
  return nonsense_command(check);
}

}  // namespace

int parts_command(const PartsArguments& arguments) {
  if (arguments.verb == PartsArguments::Verb::begin) return begin_part(arguments);
  if (arguments.verb == PartsArguments::Verb::check) return check_parts(arguments);
  if (arguments.output) {
    if (!arguments.family) return complain("-o: a sheet needs a FAMILY", kUsedWrongly);
    SheetArguments sheet;
    sheet.parts = arguments.family, sheet.output = *arguments.output;
    return sheet_command(sheet);
  }
  if (const auto read = PartLibrary::shipped_or_why(); !read)
    return complain(read.error(), kFailed);
  std::string text;
  const std::vector<PartFamily> families = part_families();
  if (arguments.family) {
    std::vector<std::string_view> names;
    for (const PartFamily& family : families) {
      names.push_back(family.name);
      if (family.name != *arguments.family) continue;
      for (const std::string& part : family.parts) text += family.name + "=" + part + "\n";
      return print(text + (family.optional ? family.name + "=none\n" : ""));
    }
    return complain(unknown_name("family", one_line(*arguments.family, 60), names), kUsedWrongly);
  }
  for (const PartFamily& family : families) {
    std::string line = fmt::format("{:14}{:3}  ", family.name, family.parts.size());
    for (const std::string& part : family.parts) line += part + " ";
    if (family.optional) line += "none ";
    line.pop_back();
    text += line + "\n";
  }
  text += "\n";
  for (const PartNumber& number : part_numbers())
    text += fmt::format("{:18}{:.6g} … {:.6g}, at rest {:.6g}\n", number.name, number.lo, number.hi,
                        number.rest);
  text += "\nstyles:";
  for (const std::string& style : part_styles()) text += " " + style;
  return print(text + "\n");
}

}  // namespace mien::command
