#include "lib/parts/recipe/own_part.h"

#include "lib/base/folder_names.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_copy.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/library/part_library.h"
#include "lib/parts/recipe/part_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien {
namespace {

constexpr std::string_view kEnd = ".part.json";

/// What a library's part has and one's own has not, and what is written first.
constexpr std::array<std::string_view, 10> kWrittenOrLeft{
    "format",  "format_version", "family",  "name",    "number",
    "tickets", "avoids",         "neutral", "comment", "features"};

Error unknown_family(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Family& family : PartLibrary::shipped().families()) names.push_back(family.name);
  return {{}, unknown_name("family of parts", one_line(name, 60), names)};
}

/// The shipped part to begin with: the family's plainest, or else the first without numbers of its own. Null: parts
/// of this family draw nothing.
const Part* model_of(const Family& family) {
  const auto serves = [](const Part& part) {
    const Reading& in = part.at.in();
    return in.find(*part.at.node, "features") && !in.find(*part.at.node, "numbers");
  };
  const Part* usual = family.find(family.usual);
  if (usual && serves(*usual)) return usual;
  const auto found = std::find_if(family.parts.begin(), family.parts.end(), serves);
  return found == family.parts.end() ? nullptr : &*found;
}

std::string comment(std::string_view family, std::string_view begun_as) {
  std::string text = " \"comment\": [";
  const auto add = [&](std::string_view line) {
    text += fmt::format("{}\n  {}", text.ends_with('[') ? "" : ",", json_string(line));
  };
  add(fmt::format("Begun as the family's \"{}\". docs/parts.md explains every word.", begun_as));
  add("Draw upwards with y and to the right with x. \"half\": true draws one half and its image.");
  add("[x, y, \"bend\"] is a smooth point, [x, y] a corner.");
  add("slot: between which features it is drawn. role: its colour, and how styles paint it.");
  std::string_view guide = part_guide(family);
  while (!guide.empty()) {
    const std::size_t end = std::min(guide.find('\n'), guide.size());
    add(guide.substr(0, end));
    guide.remove_prefix(std::min(end + 1, guide.size()));
  }
  add(fmt::format("Look at it: mien sheet --parts FILE -o {}.png. Try it: mien parts check FILE.",
                  family));
  return text + "],\n";
}

/// JSON broken between its values into lines of at most kWidest bytes, as far as its words allow: where the fewest
/// brackets are open, and before numbers, which belong together, only where there is nothing else.
std::string in_lines(std::string_view json) {
  constexpr std::size_t kWidest = 118;
  constexpr int kBeforeNumber = 1000;
  struct Place {
    std::size_t at;
    int open;
  };
  std::string text;
  std::size_t line = 0;
  std::vector<Place> places;  // to break this line
  int open = 0;
  bool inside = false;  // of a string
  for (const char c : json) {
    if (!inside && text.ends_with(", "))
      places.push_back(
          {text.size(), open + (c == '[' || c == '{' || c == '"' ? 0 : kBeforeNumber)});
    const bool escaped = inside && text.ends_with('\\') && !text.ends_with("\\\\");
    if (c == '"' && !escaped) inside = !inside;
    if (!inside) open += int(c == '[' || c == '{') - int(c == ']' || c == '}');
    text += c;
    if (c == '\n') line = text.size(), places.clear();
    if (text.size() - line <= kWidest || places.empty()) continue;
    const auto best = std::min_element(places.rbegin(), places.rend(),
                                       [](Place a, Place b) { return a.open < b.open; });
    line = best->at;
    text.replace(line - 1, 1, "\n    ");
    places.erase(places.begin(), best.base());
    for (Place& later : places) later.at += 4;
  }
  return text;
}

}  // namespace

Expected<FoundPart> read_part_file(const std::filesystem::path& path) {
  const FaceLimits limits;
  auto text = read_bytes(path, limits.bytes);
  if (!text) return text.error();
  const auto tree = JsonTree::read(*text, path.string(), limits);
  if (!tree) return tree.error();
  const Reading in(*tree, limits, nullptr);
  try {
    in.expect(tree->root(), JsonKind::object);
    const JsonNode& format = in.need(tree->root(), "format");
    if (in.string(format) != "mien-part")
      in.refuse(format,
                fmt::format("expected \"mien-part\", got {}", in_quotes(in.string(format))));
    const JsonNode& family = in.need(tree->root(), "family");
    const std::string name(in.string(family));
    if (const auto known = PartLibrary::shipped_or_why(); !known) return known.error();
    if (!PartLibrary::shipped().find_family(name)) in.refuse(family, unknown_family(name).what);
    return FoundPart{name, {path.string(), *std::move(text)}};
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

Expected<std::vector<FoundPart>> read_part_folder(const std::filesystem::path& folder) {
  const auto names = folder_names(folder);
  if (!names) return names.error();
  std::vector<std::filesystem::path> files;
  for (const std::string& name : *names)
    if (name.ends_with(kEnd)) files.push_back(folder / name);
  if (files.empty())
    return Error{folder.string(), fmt::format("no file's name ends with {}", kEnd)};
  std::sort(files.begin(), files.end());
  std::vector<FoundPart> parts;
  for (const std::filesystem::path& file : files) {
    auto part = read_part_file(file);
    if (!part) return part.error();
    parts.push_back(*std::move(part));
  }
  return parts;
}

void wear(Recipe& recipe, const FoundPart& part) {
  const std::string name = std::filesystem::path(part.part.path).filename().string();
  recipe.parts[part.family] = name;
  recipe.own_parts[name] = part.part;
}

Expected<std::string> part_skeleton(std::string_view family_name, std::string_view name) {
  if (const auto known = PartLibrary::shipped_or_why(); !known) return known.error();
  const Family* family = PartLibrary::shipped().find_family(std::string(family_name));
  if (!family) return unknown_family(family_name);
  constexpr std::string_view kSigns = "abcdefghijklmnopqrstuvwxyz0123456789_";
  if (name.empty() || name.size() > 60 || name.find_first_not_of(kSigns) != std::string_view::npos)
    return Error{
        {},
        fmt::format("a part's name has small letters, digits and _ only, got {}", in_quotes(name))};
  const Part* model = model_of(*family);
  if (!model)
    return Error{{},
                 fmt::format("parts of family \"{}\" are colours: they draw nothing", family_name)};
  const Reading& in = model->at.in();
  std::string text = fmt::format(
      "{{\"format\": \"mien-part\", \"format_version\": 1, \"family\": {}, \"name\": {},\n",
      json_string(family_name), json_string(name));
  text += comment(family_name, model->name);
  in.for_each(*model->at.node, [&](const JsonNode& member, int) {
    if (std::find(kWrittenOrLeft.begin(), kWrittenOrLeft.end(), in.tree.key(member)) !=
        kWrittenOrLeft.end())
      return;
    text += fmt::format(" {}: ", json_string(in.tree.key(member)));
    add_json(in.tree, member, text);
    text += ",\n";
  });
  text += " \"features\": [";
  in.for_each(in.need(*model->at.node, "features"), [&](const JsonNode& feature, int i) {
    text += i > 0 ? ",\n  " : "\n  ";
    add_json(in.tree, feature, text);
  });
  return in_lines(text) + "]}\n";
}

}  // namespace mien
