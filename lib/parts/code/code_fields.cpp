#include "lib/parts/code/code_fields.h"
#include "lib/parts/compose/chosen_parts.h"

#include <cmath>

namespace mien {
namespace {

constexpr int kNoPart = 1023, kMostStep = 1023;

Recipe without_own_parts(Recipe recipe) {
  std::erase_if(recipe.parts,
                [&](const auto& chosen) { return recipe.own_parts.contains(chosen.second); });
  return recipe;
}

}  // namespace

CodeFields code_fields(const Recipe& recipe) {
  const PartLibrary& library = PartLibrary::shipped();
  const Recipe whole = completed(library, without_own_parts(recipe));
  CodeFields fields;
  for (const Family& family : library.families()) {
    const auto chosen = whole.parts.find(family.name);
    const Part* part = chosen == whole.parts.end() ? nullptr : family.find(chosen->second);
    fields[family.number] = part ? part->number : kNoPart;
  }
  for (const LibraryNumber& number : library.numbers()) {
    const auto given = recipe.numbers.find(number.name);
    const double value = given == recipe.numbers.end() ? number.rest : given->second;
    const double share = (value - number.lo) / (number.hi - number.lo);
    fields[number.number] = int(std::floor(share * kMostStep + 0.5));
  }
  return fields;
}

FaceCode code_of_fields(const CodeFields& fields, std::uint64_t seed) {
  FaceCode code{.seed = seed, .held = {}};
  // What is held changes what depends on it: an age, numbers; a skin, hair. Each round holds more, until all is said.
  for (std::size_t held = 1; held > 0;) {
    const std::size_t before = code.held.size();
    for (const auto& [field, value] : code_fields(recipe_from_code(code).value()))
      if (fields.at(field) != value) code.held.push_back({field, fields.at(field)});
    held = code.held.size() - before;
  }
  return code;
}

Expected<FaceCode> code_of_recipe(const Recipe& recipe) {
  const auto library = PartLibrary::shipped_or_why();
  if (!library) return library.error();
  if (auto wrong = wrong_in(**library, recipe)) return *std::move(wrong);
  const CodeFields fields = code_fields(recipe);
  const auto own = read_face_code(recipe.code);
  if (!own) return code_of_fields(fields, 0);
  const auto said = recipe_from_code(*own);
  const bool same = said && code_fields(*said) == fields;
  return same ? *own : code_of_fields(fields, own->seed);
}

}  // namespace mien
