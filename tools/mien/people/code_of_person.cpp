#include "tools/mien/people/code_of_person.h"

#include <mien/recipe.h>
#include "lib/parts/code/code_fields.h"
#include "tools/mien/commands/posed_face.h"

#include <fmt/format.h>

#include <cmath>

namespace mien::command {
namespace {

void tell_left_out(const std::string& file, const Recipe& recipe, const Recipe& held,
                   std::vector<Error>& all) {
  if (recipe.style != held.style)
    all.push_back(
        {file, fmt::format("no code holds a style: say --style {} with it", recipe.style)});
  for (const auto& [family, part] : recipe.parts)
    if (recipe.own_parts.contains(part))
      all.push_back({file, fmt::format("no code holds a part of one's own: {} is left out", part)});
  for (const PartNumber& number : part_numbers()) {
    const auto said = recipe.numbers.find(number.name);
    if (said == recipe.numbers.end()) continue;
    const double value = held.numbers.at(number.name), range = number.hi - number.lo;
    constexpr double kSeen = 1e-6;  // of the range
    if (std::abs(value - said->second) > kSeen * range)
      all.push_back({file, fmt::format("a code holds steps of {:.6g}: {} is {:.6g}, not {:.6g}",
                                       range / 1023, number.name, value, said->second)});
  }
}

}  // namespace

Expected<FaceCode> code_of_person(const std::string& given, std::vector<Error>* warnings) {
  if (is_given_as_code(given)) return read_face_code(given);
  const auto recipe = read_given_recipe(given, warnings);
  if (!recipe) return recipe.error();
  const auto code = code_of_recipe(*recipe);
  if (!code) return code.error();
  const auto held = recipe_from_code(*code);
  if (!held) return held.error();
  if (warnings) tell_left_out(given, *recipe, *held, *warnings);
  return code;
}

}  // namespace mien::command
