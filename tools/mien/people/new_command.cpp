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
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/people/code_of_person.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>

namespace mien::command {
namespace {

constexpr std::size_t kLongCode = 40;  ///< signs that people still copy

/// Another word at each call, from the time in nanoseconds.
std::string new_word() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return fmt::format("{:x}", std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
}

/// The people that options name, each with its option.
std::vector<std::pair<std::string, std::string>> named_people(const NewArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> people;
  if (arguments.code) people.emplace_back("--code", *arguments.code);
  if (arguments.near) people.emplace_back("--near", *arguments.near);
  for (const std::string& one : arguments.between) people.emplace_back("--between", one);
  for (const std::string& one : arguments.child_of) people.emplace_back("--child-of", one);
  return people;
}

/// Their codes. Warnings have been printed.
Expected<std::vector<FaceCode>> codes_of(
    const std::vector<std::pair<std::string, std::string>>& people) {
  std::vector<FaceCode> codes;
  for (const auto& [option, person] : people) {
    std::vector<Error> warnings;
    const auto code = code_of_person(person, &warnings);
    warn(warnings);
    if (!code) {
      const bool of_file = !is_given_as_code(person) && !code.error().where.empty();
      return Error{option + " " + (of_file ? code.error().where : one_line(person, 60)),
                   code.error().what};
    }
    codes.push_back(*code);
  }
  return codes;
}

/// The code of the person asked for, before what is held.
Expected<FaceCode> code_from(const NewArguments& arguments, const std::vector<FaceCode>& people,
                             std::uint64_t seed) {
  if (people.empty()) return FaceCode{.seed = seed, .held = {}};
  if (arguments.code) return people[0];
  if (arguments.near) {
    const auto by = read_share("by", arguments.by.value_or("0.3"));
    return by ? code_near(people[0], *by, seed) : by.error();
  }
  if (arguments.between.empty()) return code_of_child(people[0], people[1], seed);
  const auto at = read_share("at", arguments.at.value_or("0.5"));
  return at ? code_between(people[0], people[1], *at) : at.error();
}

Expected<FaceCode> with_held(Expected<FaceCode> code, const NewArguments& arguments) {
  if (!code) return code;
  for (const std::string& text : arguments.held) {
    const auto held = read_held_value(text, arguments.clamp);
    if (!held) return Error{"--hold " + held.error().where, held.error().what};
    std::erase_if(code->held, [&](const HeldValue& one) { return one.field == held->field; });
    code->held.push_back(*held);
  }
  return code;
}

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) || std::string_view("-_=./~,+@%").find(char(c)) != std::string::npos;
  });
  if (plain && text[0] != '~') return text;
  std::string quoted(1, '\'');
  for (const char c : text)
    if (c == '\'')
      quoted.append("'\\''");
    else
      quoted.push_back(c);
  quoted.push_back('\'');
  return quoted;
}

/// The command that writes the same person into a file.
std::string command_with_file(const NewArguments& arguments, const std::string& seed) {
  std::string text = "mien new";
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) text += fmt::format(" {} {}", option, shell_word(*value));
  };
  add("--code", arguments.code), add("--near", arguments.near), add("--by", arguments.by);
  for (const auto* two : {&arguments.between, &arguments.child_of}) {
    if (two->empty()) continue;
    add(two == &arguments.between ? "--between" : "--child-of", two->front());
    text += fmt::format(" {}", shell_word(two->back()));
  }
  add("--at", arguments.at);
  if (!arguments.code && arguments.between.empty()) add("--seed", seed);
  for (const std::string& held : arguments.held) add("--hold", held);
  add("--style", arguments.style);
  text += fmt::format("{}{}", arguments.clamp ? " --clamp" : "", arguments.flat ? " --flat" : "");
  const bool child = !arguments.child_of.empty();
  return text + (child ? " -o child.face.json" : " -o mine.face.json");
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
  const auto people = codes_of(named_people(arguments));
  if (!people) return complain(people.error(), kFailed);
  const std::string word = arguments.seed.value_or(new_word());
  const auto code = with_held(code_from(arguments, *people, seed_from_word(word)), arguments);
  if (!code) return complain(code.error(), kUsedWrongly);
  auto recipe = recipe_from_code(*code);
  if (!recipe) return complain(recipe.error(), kFailed);
  if (arguments.style) recipe->style = *arguments.style;
  auto text = face_text_from_recipe(*recipe);
  if (!text) return complain(text.error(), kUsedWrongly);
  if (!arguments.flat) text = recipe_text(*recipe);
  const std::string said = face_code_text(*code);
  if (!arguments.output && said.size() > kLongCode)
    warn({Error{"code", fmt::format("it has {} signs; `{}` keeps the person in a file, which goes "
                                    "wherever a code does",
                                    said.size(), command_with_file(arguments, word))}});
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
    for (const char* command : {"new", "check"}) names.push_back(command);
    std::string what = unknown_name("family", one_line(*arguments.family, 60), names);
    if (!what.ends_with('?')) what += "; mien parts lists them";
    return complain(what, kUsedWrongly);
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
