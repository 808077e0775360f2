// mien code: the code of a recipe, and the parts and numbers of a code.

#include <mien/recipe.h>
#include "lib/parts/code/edition.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/commands/posed_face.h"
#include "tools/mien/people/code_of_person.h"
#include "tools/mien/terminal/messages.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien::command {
namespace {

int print_code_of(const std::string& file) {
  std::vector<Error> warnings;
  const auto code = code_of_person(file, &warnings);
  warn(warnings);
  return code ? print(face_code_text(*code) + "\n") : complain(code.error(), kFailed);
}

/// Every part and number, as --hold takes them; after each that the code holds against its seed, the seed's choice.
int print_meaning_of(const FaceCode& code) {
  const auto recipe = recipe_from_code(code);
  if (!recipe) return complain(recipe.error(), kFailed);
  const Recipe seeds = recipe_from_seed(code.seed);
  std::string text = fmt::format("code {}\nedition {}\n", face_code_text(code), kEdition);
  const auto add = [&](const std::string& name, const std::string& value,
                       const std::string& of_seed) {
    const bool held = std::ranges::any_of(code.held, [&](const HeldValue& one) {
      return one.field == read_held_value(name + "=" + value, true).value().field;
    });
    text += fmt::format("{}={}", name, value);
    if (held) text += fmt::format("  held; the seed says {}", of_seed);
    text += "\n";
  };
  for (const PartFamily& family : part_families()) {
    const auto part_of = [&](const Recipe& one) {
      const auto part = one.parts.find(family.name);
      return part == one.parts.end() ? std::string("none") : part->second;
    };
    add(family.name, part_of(*recipe), part_of(seeds));
  }
  for (const PartNumber& number : part_numbers())
    add(number.name, fmt::format("{:.6g}", recipe->numbers.at(number.name)),
        fmt::format("{:.6g}", seeds.numbers.at(number.name)));
  return print(text);
}

}  // namespace

int code_command(const CodeArguments& arguments) {
  if (arguments.face.has_value() == arguments.seed.has_value())
    return complain("code: a FACE or a --seed is needed, one of them", kUsedWrongly);
  if (arguments.seed)
    return print(face_code_text({.seed = seed_from_word(*arguments.seed), .held = {}}) + "\n");
  if (!is_given_as_code(*arguments.face)) return print_code_of(*arguments.face);
  const auto code = read_face_code(*arguments.face);
  return code ? print_meaning_of(*code) : complain(code.error(), kFailed);
}

}  // namespace mien::command
