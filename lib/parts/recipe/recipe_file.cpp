#include "lib/parts/recipe/recipe_file.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/code/edition.h"
#include "lib/parts/compose/chosen_parts.h"
#include "lib/parts/library/part_library.h"

#include <fmt/format.h>

#include <algorithm>

namespace mien {
namespace {

class RecipeReader {
 public:
  RecipeReader(Reading& in, const std::filesystem::path* folder) : in_(in), folder_(folder) {}

  Recipe read(const JsonNode& root) {
    in_.expect_object(root,
                      {"$schema", "format", "format_version", "name", "edition", "code", "parts",
                       "numbers", "style"},
                      "recipe");
    read_base(in_.find(root, "edition"), in_.find(root, "code"));
    if (const JsonNode* name = in_.find(root, "name")) recipe_.name = in_.string(*name);
    if (const JsonNode* parts = in_.find(root, "parts")) {
      in_.expect(*parts, JsonKind::object);
      in_.for_each(*parts, [&](const JsonNode& node, int) { read_part(node); });
    }
    if (const JsonNode* numbers = in_.find(root, "numbers")) {
      in_.expect(*numbers, JsonKind::object);
      in_.for_each(*numbers, [&](const JsonNode& node, int) {
        read_number(node, std::string(in_.tree.key(node)));
      });
    }
    if (const JsonNode* style = in_.find(root, "style")) {
      const std::vector<std::string>& styles = library_->styles();
      const std::vector<std::string_view> names(styles.begin(), styles.end());
      const std::string* known = library_->find_style(in_.string(*style));
      recipe_.style = known ? *known : styles[in_.word(*style, "style", names)];
    }
    return std::move(recipe_);
  }

 private:
  void read_base(const JsonNode* edition, const JsonNode* code) {
    if (edition && in_.string(*edition) != std::string_view(&kEdition, 1))
      in_.refuse(*edition, unknown_edition(in_.string(*edition)));
    const auto library = PartLibrary::shipped_or_why();
    if (!library) throw Refusal{library.error()};
    library_ = *library;
    if (code) recipe_ = of_code(*code);
  }

  Recipe of_code(const JsonNode& node) const {
    const auto code = read_face_code(in_.string(node));
    if (!code) in_.refuse(node, code.error().what);
    auto recipe = recipe_from_code(*code);
    if (!recipe) in_.refuse(node, recipe.error().what);
    return *std::move(recipe);
  }

  template <class Things>
  [[noreturn]] void refuse_unknown(const JsonNode& node, std::string_view what,
                                   std::string_view wanted, const Things& things) const {
    std::vector<std::string_view> names;
    for (const auto& thing : things) names.push_back(thing.name);
    in_.refuse(node, unknown_name(what, one_line(wanted, 60), names));
  }

  /// Why a path is no file of the folder; empty: it is one. Links may not lead elsewhere: a recipe of a stranger reads
  /// nothing but what lies beside it.
  static std::string why_no_part(const std::filesystem::path& folder,
                                 const std::filesystem::path& path) {
    namespace fs = std::filesystem;
    std::error_code failed;
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::not_found) return "is not there";
    if (failed) return "cannot be read: " + failed.message();
    if (status.type() == fs::file_type::directory) return "is a folder, no file";
    if (status.type() != fs::file_type::regular) return "is a pipe or a device, no file";
    const fs::path real = fs::canonical(path, failed);
    const fs::path home =
        failed ? fs::path() : fs::canonical(folder.empty() ? "." : folder, failed);
    if (failed) return "cannot be read: " + failed.message();
    return real.parent_path() == home ? "" : "is a link that leads out of the recipe's folder";
  }

  /// A file beside the recipe.
  void read_own_part(const JsonNode& node) {
    const std::string name(in_.string(node));
    if (!folder_)
      in_.refuse(node, "a part of one's own lies beside the recipe, and this recipe is of no file");
    if (name.find_first_of("/\\") != std::string::npos)
      in_.refuse(node,
                 "a part of one's own lies in the recipe's own folder: a name without slashes");
    const std::filesystem::path path = *folder_ / name;
    if (const std::string wrong = why_no_part(*folder_, path); !wrong.empty())
      in_.refuse(node, fmt::format("{} {}", in_quotes(path.string()), wrong));
    auto text = read_bytes(path, in_.limits.bytes);
    if (!text) in_.refuse(node, sentence(text.error()));
    recipe_.own_parts[name] = {path.string(), *std::move(text)};
  }

  /// "hair": "bob", or {"part": "bob", "length": 0.2} with the part's own numbers, or null or "none"; "quiff.part.json":
  /// a part of one's own.
  void read_part(const JsonNode& node) {
    const std::string_view name = in_.tree.key(node);
    const Family* family = library_->find_family(name);
    if (!family) refuse_unknown(node, "family of parts", name, library_->families());
    const bool none = node.kind == JsonKind::string && in_.string(node) == "none";
    if (node.kind == JsonKind::null || (none && !family->find("none"))) {
      if (family->find("none")) {
        recipe_.parts[family->name] = "none";
        return;
      }
      if (!family->optional)
        in_.refuse(node, fmt::format("a face has one of \"{}\" always", family->name));
      recipe_.parts.erase(family->name);
      return;
    }
    const JsonNode& part = node.kind == JsonKind::object ? in_.need(node, "part") : node;
    if (in_.string(part).ends_with(".part.json"))
      read_own_part(part);
    else if (!family->find(in_.string(part)))
      refuse_unknown(part, family->name, in_.string(part), family->parts);
    recipe_.parts[family->name] = in_.string(part);
    if (node.kind != JsonKind::object) return;
    in_.for_each(node, [&](const JsonNode& own, int) {
      const std::string_view key = in_.tree.key(own);
      if (key != "part" && key != "comment")
        read_number(own, fmt::format("{}.{}", family->name, key));
    });
  }

  void read_number(const JsonNode& node, const std::string& name) {
    const LibraryNumber* number = library_->find_number(name);
    if (!number) refuse_unknown(node, "number", name, library_->numbers());
    const double value = in_.number(node);
    if (!(value >= number->lo && value <= number->hi))
      in_.refuse(node,
                 fmt::format("{} goes from {} to {}, got {}", name, number->lo, number->hi, value));
    recipe_.numbers[name] = value;
  }

  Reading& in_;
  const std::filesystem::path* folder_;
  const PartLibrary* library_ = nullptr;
  Recipe recipe_;
};

}  // namespace

Recipe read_recipe(Reading& in, const JsonNode& root, const std::filesystem::path* folder) {
  return RecipeReader(in, folder).read(root);
}

namespace {

/// `folder`: of its own parts; null: it can have none.
Expected<Recipe> recipe_of(std::string_view text, std::string_view name,
                           const std::filesystem::path* folder, std::vector<Error>* warnings) {
  const FaceLimits limits;
  const auto tree = JsonTree::read(text, name, limits);
  if (!tree) return tree.error();
  Reading in(*tree, limits, warnings);
  try {
    const JsonNode& root = tree->root();
    in.expect(root, JsonKind::object);
    const JsonNode& format = in.need(root, "format");
    if (in.string(format) != "mien-face")
      in.refuse(format,
                fmt::format("expected \"mien-face\", got {}", in_quotes(in.string(format))));
    const JsonNode& version = in.need(root, "format_version");
    if (in.number(version) == 1)
      in.refuse(
          version,
          "a face in full has its own paints and no recipe: codes and styles are for version 2");
    if (in.number(version) != 2)
      in.refuse(version, fmt::format("expected the integer 2, got {}", in.number(version)));
    return read_recipe(in, root, folder);
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace

Expected<Recipe> read_recipe_text(std::string_view text, std::string_view name) {
  return recipe_of(text, name, nullptr, nullptr);
}

Expected<Recipe> read_recipe_file(const std::filesystem::path& path, std::vector<Error>* warnings) {
  const auto text = read_bytes(path, FaceLimits{}.bytes);
  if (!text) return text.error();
  const std::filesystem::path folder = path.parent_path();
  return recipe_of(*text, path.string(), &folder, warnings);
}

std::string recipe_text(const Recipe& recipe) {
  std::string text = fmt::format(
      "{{\"format\": \"mien-face\", \"format_version\": 2, \"edition\": \"{}\",\n", kEdition);
  if (!recipe.name.empty()) text += fmt::format(" \"name\": {},\n", json_string(recipe.name));
  if (!recipe.code.empty()) text += fmt::format(" \"code\": {},\n", json_string(recipe.code));
  text += " \"parts\": {";
  const char* before = "\n  ";
  // Families without a part are said to have none: the code may say otherwise.
  for (const PartFamily& family : part_families()) {
    const auto part = recipe.parts.find(family.name);
    if (part == recipe.parts.end() && !family.optional) continue;
    text += fmt::format("{}{}: {}", before, json_string(family.name),
                        part == recipe.parts.end() ? "null" : json_string(part->second));
    before = ",\n  ";
  }
  text += "},\n \"numbers\": {";
  before = "\n  ";
  for (const auto& [name, value] : recipe.numbers) {
    text += fmt::format("{}{}: {}", before, json_string(name), json_number(value));
    before = ",\n  ";
  }
  return text + fmt::format("}},\n \"style\": {}}}\n", json_string(recipe.style));
}

}  // namespace mien
