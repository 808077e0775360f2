#include "lib/parts/compose/styled_recipe.h"
#include "lib/base/nearest_name.h"

#include <algorithm>

namespace mien {
namespace {

template <class Things>
[[noreturn]] void refuse_name(const Reading& in, const JsonNode& node, std::string_view what,
                              std::string_view wanted, const Things& things) {
  std::vector<std::string_view> names;
  for (const auto& thing : things) names.push_back(thing.name);
  in.refuse(node, unknown_name(what, wanted, names));
}

void take_part(const PartLibrary& library, const Reading& in, const JsonNode& part,
               Recipe& recipe) {
  const std::string family_name(in.tree.key(part));
  const Family* family = library.find_family(family_name);
  if (!family) refuse_name(in, part, "family of parts", family_name, library.families());
  if (part.kind == JsonKind::null) {
    recipe.parts.erase(family_name);
    return;
  }
  const std::string name(in.string(part));
  if (!family->find(name)) refuse_name(in, part, family_name, name, family->parts);
  recipe.parts[family_name] = name;
}

void move_number(const PartLibrary& library, const Reading& in, const JsonNode& move,
                 Recipe& recipe) {
  const std::string name(in.tree.key(move));
  const LibraryNumber* number = library.find_number(name);
  if (!number) refuse_name(in, move, "number", name, library.numbers());
  const auto given = recipe.numbers.find(name);
  double value = given == recipe.numbers.end() ? number->rest : given->second;
  if (const JsonNode* times = in.find(move, "times")) value *= in.number(*times);
  if (const JsonNode* adds = in.find(move, "adds")) value += in.number(*adds);
  recipe.numbers[name] = std::clamp(value, number->lo, number->hi);
}

}  // namespace

Recipe styled(const PartLibrary& library, Recipe recipe) {
  const Reading& in = library.topology().in();
  const JsonNode& style = in.need(in.need(*library.topology().node, "styles"), recipe.style);
  if (const JsonNode* parts = in.find(style, "parts"))
    in.for_each(*parts, [&](const JsonNode& part, int) { take_part(library, in, part, recipe); });
  if (const JsonNode* numbers = in.find(style, "numbers"))
    in.for_each(*numbers,
                [&](const JsonNode& move, int) { move_number(library, in, move, recipe); });
  return recipe;
}

}  // namespace mien
