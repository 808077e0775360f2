#include "tools/mien/data/stimulus_manifest.h"
#include <mien/version.h>
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/code/edition.h"
#include "lib/parts/recipe/recipe_file.h"
#include "tools/mien/data/file_format.h"
#include "tools/mien/data/stimulus_plan.h"

#include <fmt/format.h>

namespace mien::command {
namespace {

constexpr std::string_view kFormat = "mien-stimuli-manifest";

/// {"a": 1, "b": 2} of pairs whose second is JSON already.
template <class Pairs, class Json>
std::string object(const Pairs& pairs, const Json& json) {
  std::string text = "{";
  for (const auto& [name, value] : pairs)
    text += fmt::format("{}{}: {}", text.size() > 1 ? ", " : "", json_string(name), json(value));
  return text + "}";
}

std::string recipe_object(const Recipe& recipe) {
  return fmt::format(
      "{{\"edition\": \"{}\", \"parts\": {}, \"numbers\": {}, \"style\": {}}}", kEdition,
      object(recipe.parts, [](const std::string& part) { return json_string(part); }),
      object(recipe.numbers, json_number), json_string(recipe.style));
}

std::string line(const ShownStimulus& shown) {
  const Stimulus& one = shown.stimulus;
  return fmt::format(
      "  {{\"file\": {}, \"levels\": {}, \"face\": {}, \"controls\": {}, \"picture\": \"{}\", "
      "\"displacement\": {}, \"sha256\": \"{}\"}}",
      json_string(one.file),
      object(one.levels, [](const std::string& level) { return json_string(level); }),
      recipe_object(one.recipe), object(one.controls, json_number),
      kStimulusPictures[std::size_t(one.picture)], json_number(shown.displacement), shown.sha256);
}

class ManifestReader {
 public:
  explicit ManifestReader(Reading& in) : in_(in) {}

  StimulusManifest read(const JsonNode& root) {
    in_.expect_object(root, {"format", "format_version", "mien", "size", "stimuli"}, "manifest");
    expect_format(in_, root, kFormat);
    const JsonNode& size = in_.need(root, "size");
    StimulusManifest manifest;
    if (!(in_.number(size) >= 1 && in_.number(size) <= 8192))
      in_.refuse(size, "expected 1 to 8192 pixels");
    manifest.size = int(in_.number(size));
    const JsonNode& shown = in_.need(root, "stimuli");
    in_.expect(shown, JsonKind::array);
    if (std::uint64_t(shown.count) > kMostStimuli)
      in_.refuse(shown, fmt::format("more than {} pictures", kMostStimuli));
    in_.for_each(shown, [&](const JsonNode& node, int) { manifest.shown.push_back(one(node)); });
    return manifest;
  }

 private:
  ShownStimulus one(const JsonNode& node) {
    in_.expect_object(node,
                      {"file", "levels", "face", "controls", "picture", "displacement", "sha256"},
                      "picture");
    ShownStimulus shown{.stimulus = {}, .displacement = {}, .sha256 = {}};
    Stimulus& stimulus = shown.stimulus;
    const JsonNode& file = in_.need(node, "file");
    stimulus.file = in_.string(file);
    if (stimulus.file.empty() || stimulus.file.find_first_of("/\\") != std::string::npos)
      in_.refuse(file, "expected a file's name without folders");
    const JsonNode& levels = in_.need(node, "levels");
    in_.expect(levels, JsonKind::object);
    in_.for_each(levels, [&](const JsonNode& level, int) {
      stimulus.levels.emplace_back(in_.tree.key(level), in_.string(level));
    });
    stimulus.recipe = read_recipe(in_, in_.need(node, "face"), nullptr);
    const JsonNode& controls = in_.need(node, "controls");
    in_.expect(controls, JsonKind::object);
    in_.for_each(controls, [&](const JsonNode& control, int) {
      stimulus.controls.emplace_back(in_.tree.key(control), in_.number(control));
    });
    stimulus.picture =
        StimulusPicture(in_.word(in_.need(node, "picture"), "picture", kStimulusPictures));
    shown.displacement = in_.number(in_.need(node, "displacement"));
    shown.sha256 = in_.string(in_.need(node, "sha256"));
    return shown;
  }

  Reading& in_;
};

}  // namespace

std::string manifest_text(const StimulusManifest& manifest) {
  std::string text = fmt::format(
      "{{\"format\": \"{}\", \"format_version\": 1, \"mien\": \"{}\", \"size\": {},\n \"stimuli\": "
      "[\n",
      kFormat, MIEN_VERSION_STRING, manifest.size);
  for (const ShownStimulus& shown : manifest.shown)
    text += line(shown) + (&shown == &manifest.shown.back() ? "\n" : ",\n");
  return text + "]}\n";
}

bool is_stimulus_manifest(const std::filesystem::path& path) {
  const FaceLimits limits{.bytes = 512u << 20, .values = 50'000'000};
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return false;
  const auto tree = JsonTree::read(*text, path.string(), limits);
  if (!tree || tree->root().kind != JsonKind::object) return false;
  const JsonNode* format = tree->member(tree->root(), "format");
  return format && format->kind == JsonKind::string && tree->string(*format) == kFormat;
}

Expected<StimulusManifest> read_stimulus_manifest(const std::filesystem::path& path) {
  const FaceLimits limits{.bytes = 512u << 20, .values = 50'000'000};
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return text.error();
  const auto tree = JsonTree::read(*text, path.string(), limits);
  if (!tree) return tree.error();
  Reading in(*tree, limits, nullptr);
  try {
    return ManifestReader(in).read(tree->root());
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace mien::command
