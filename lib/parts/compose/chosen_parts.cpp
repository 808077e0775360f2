#include "lib/parts/compose/chosen_parts.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/parts/compose/styled_recipe.h"
#include "lib/parts/recipe/person_seed.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace mien {
namespace {

template <class Things>
std::string unknown(std::string_view what, std::string_view wanted, const Things& things) {
  std::vector<std::string_view> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return unknown_name(what, wanted, names);
}

/// A key of a part, and what it holds.
struct PartKey {
  std::string_view name;
  std::optional<JsonKind> kind;  ///< none: not looked at here
};
constexpr std::array<PartKey, 18> kPartKeys{{{"format", {}},
                                             {"format_version", {}},
                                             {"$schema", {}},
                                             {"comment", {}},
                                             {"family", {}},
                                             {"name", {}},
                                             {"number", {}},   // a library's, as are its
                                             {"tickets", {}},  // tickets and what it avoids:
                                             {"avoids", {}},   // nothing draws lots here,
                                             {"neutral", {}},  // and its user has chosen it
                                             {"in", JsonKind::string},
                                             {"color", JsonKind::array},
                                             {"points", JsonKind::object},
                                             {"values", JsonKind::object},
                                             {"covers", JsonKind::array},
                                             {"gone", JsonKind::array},
                                             {"groups", JsonKind::object},
                                             {"features", JsonKind::array}}};

/// What a part has of a kind, by name: {"points": {"hairline": …}}, {"features": [{"name": "hat"}, …]}.
std::set<std::string_view> names_in(const LibraryNode& part, std::string_view kind) {
  const Reading& in = part.in();
  std::set<std::string_view> names;
  if (const JsonNode* all = in.find(*part.node, kind))
    in.for_each(*all, [&](const JsonNode& one, int) {
      names.insert(all->kind == JsonKind::object ? in.tree.key(one)
                                                 : in.string(in.need(one, "name")));
    });
  return names;
}

/// All names that a file mentions: of "@lens/points/3", "lens".
void add_names_said_in(const LibraryFile& file, std::set<std::string_view>& to) {
  const JsonTree& tree = file.tree;
  const auto add = [&](std::string_view text) {
    if (text.starts_with('@')) text.remove_prefix(1);
    to.insert(text.substr(0, text.find('/')));
  };
  for (const JsonNode& node : tree.nodes) {
    if (node.key >= 0) add(tree.key(node));
    if (node.kind == JsonKind::string) add(tree.string(node));
  }
}

std::set<std::string_view> names_said_outside(const PartLibrary& library, const Family& family) {
  std::set<std::string_view> said;
  add_names_said_in(*library.topology().file, said);
  for (const Family& other : library.families())
    if (&other != &family)
      for (const Part& part : other.parts) add_names_said_in(*part.at.file, said);
  return said;
}

/// Other parts and the rig build on what every part of a family's has and they call by name.
void check_has_what_others_need(const LibraryNode& part, const PartLibrary& library,
                                const Family& family) {
  const std::set<std::string_view> said = names_said_outside(library, family);
  for (const auto& [kind, what] :
       {std::pair{"features", "feature"}, {"points", "point"}, {"values", "value"}}) {
    const std::set<std::string_view> has = names_in(part, kind);
    for (const std::string_view name : names_in(family.parts.at(0).at, kind))
      if (said.contains(name) && !has.contains(name) &&
          std::all_of(family.parts.begin(), family.parts.end(),
                      [&, kind = kind](const Part& other) {
                        return names_in(other.at, kind).contains(name);
                      }))
        part.in().refuse(
            *part.node,
            fmt::format("every part of family \"{}\" has a {} named \"{}\", on which others build",
                        family.name, what, name));
  }
  if (part.in().find(*family.parts[0].at.node, "color")) part.in().need(*part.node, "color");
}

/// A family that a part covers, or one part of it: "aid/hearing_aid".
void check_covered(const Reading& in, const JsonNode& node, const PartLibrary& library) {
  const std::string_view name = in.string(node), family_name = name.substr(0, name.find('/'));
  const Family* family = library.find_family(family_name);
  if (!family)
    in.refuse(node, unknown("family of parts", one_line(family_name, 60), library.families()));
  if (family_name.size() == name.size()) return;
  const std::string_view part = name.substr(family_name.size() + 1);
  if (!family->find(part)) in.refuse(node, unknown(family_name, one_line(part, 60), family->parts));
}

/// Shipped parts are right: tests draw every one of them. A part of one's own is read with care.
void check_own_part(const Reading& in, const JsonNode& root, const PartLibrary& library,
                    const Family& family) {
  in.expect(root, JsonKind::object);
  const JsonNode& format = in.need(root, "format");
  if (in.string(format) != "mien-part")
    in.refuse(format, fmt::format("expected \"mien-part\", got {}", in_quotes(in.string(format))));
  const JsonNode& version = in.need(root, "format_version");
  if (in.number(version) != 1)
    in.refuse(version, fmt::format("expected the integer 1, got {}", in.number(version)));
  const JsonNode& of = in.need(root, "family");
  if (in.string(of) != family.name)
    in.refuse(of, fmt::format("the recipe takes this as \"{}\", but it says {}", family.name,
                              in_quotes(in.string(of))));
  in.for_each(root, [&](const JsonNode& member, int) {
    const std::string_view key = in.tree.key(member);
    if (key == "numbers")
      in.refuse(member, "a part of one's own has no numbers of its own, only the library's");
    const auto known =
        std::find_if(std::begin(kPartKeys), std::end(kPartKeys),
                     [&](const PartKey& known_key) { return known_key.name == key; });
    if (known == kPartKeys.end())
      in.refuse(member, unknown("key of a part", one_line(key, 60), kPartKeys));
    if (known->kind) in.expect(member, *known->kind);
  });
  if (const JsonNode* covers = in.find(root, "covers"))
    in.for_each(*covers, [&](const JsonNode& node, int) { check_covered(in, node, library); });
}

}  // namespace

std::optional<Error> wrong_in(const PartLibrary& library, const Recipe& recipe) {
  const std::string where = "recipe";
  for (const auto& [family_name, part] : recipe.parts) {
    const Family* family = library.find_family(family_name);
    if (!family)
      return Error{where,
                   unknown("family of parts", one_line(family_name, 60), library.families())};
    if (!recipe.own_parts.contains(part) && !family->find(part))
      return Error{where, unknown(family_name, one_line(part, 60), family->parts)};
  }
  for (const auto& [name, value] : recipe.numbers) {
    const LibraryNumber* number = library.find_number(name);
    if (!number) return Error{where, unknown("number", one_line(name, 60), library.numbers())};
    if (!(value >= number->lo && value <= number->hi))
      return Error{
          where, fmt::format("{} goes from {} to {}, got {}", name, number->lo, number->hi, value)};
  }
  const std::vector<std::string>& styles = library.styles();
  if (!library.find_style(recipe.style))
    return Error{where,
                 unknown_name("style", one_line(recipe.style, 60), {styles.begin(), styles.end()})};
  return {};
}

Recipe completed(const PartLibrary& library, Recipe recipe) {
  for (const Family& family : library.families())
    if (!family.optional && !recipe.parts.contains(family.name) && !family.parts.empty())
      recipe.parts[family.name] = family.usual;
  if (const std::string* style = library.find_style(recipe.style)) recipe.style = *style;
  return recipe;
}

const Part* chosen_part(const PartLibrary& library, const Recipe& recipe, std::string_view family) {
  const auto chosen = recipe.parts.find(std::string(family));
  return chosen == recipe.parts.end() ? nullptr : library.find_family(family)->find(chosen->second);
}

const Part* ChosenParts::of(std::string_view family) const {
  const auto own = own_.find(family);
  return own == own_.end() ? chosen_part(*library_, recipe_, family) : &own->second;
}

bool ChosenParts::wears(const Reading& in, const JsonNode& parts) const {
  bool worn = false;
  in.for_each(parts, [&](const JsonNode& names, int) {
    const Part* part = of(in.tree.key(names));
    in.for_each(names, [&](const JsonNode& name, int) {
      worn = worn || (part && part->name == in.string(name));
    });
  });
  return worn;
}

void ChosenParts::read_own(const Family& family, const OwnPart& own) {
  const FaceLimits limits;
  if (own.text.size() > limits.bytes)
    throw Refusal{{own.path, fmt::format("longer than {} bytes (limit: bytes)", limits.bytes)}};
  auto tree = JsonTree::read(own.text, own.path, limits);
  if (!tree) throw Refusal{tree.error()};
  const LibraryFile& file = files_.emplace_back(own.path, own.text, *std::move(tree));
  const JsonNode& root = file.tree.root();
  check_own_part(file.reading, root, *library_, family);
  check_has_what_others_need({&file, &root}, *library_, family);
  own_.emplace(family.name,
               Part{file.reading.name(file.reading.need(root, "name")), -1, {&file, &root}});
}

Expected<ChosenParts> ChosenParts::read(const Recipe& recipe) {
  const auto library = PartLibrary::shipped_or_why();
  if (!library) return library.error();
  return read(**library, recipe);
}

Expected<ChosenParts> ChosenParts::read(const PartLibrary& library, const Recipe& recipe) {
  if (auto wrong = wrong_in(library, recipe)) return *std::move(wrong);
  try {
    ChosenParts chosen(library, styled(library, completed(library, recipe)), person_seed(recipe));
    for (const auto& [family, part] : chosen.recipe_.parts)
      if (const auto own = chosen.recipe_.own_parts.find(part);
          own != chosen.recipe_.own_parts.end())
        chosen.read_own(*library.find_family(family), own->second);
    return chosen;
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace mien
