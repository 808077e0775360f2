#include "tools/mien/data/chernoff_map.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/recipe/recipe_file.h"
#include "tools/mien/data/feelings.h"
#include "tools/mien/data/file_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mien::command {
namespace {

constexpr std::array<std::string_view, 3> kScales{"linear", "rank", "quartile"};
constexpr std::size_t kMostFeatures = 64;

/// What people read from faces, the most exact first: slant of the brows and size of the eyes (Morris, Ebert
/// and Rheingans, 2000), then curve of the mouth, width, distances.
constexpr std::array<std::string_view, 12> kDefaultNumbers{
    "brow.tilt",   "eye.size", "smile", "cheek", "eye.x",    "nose.length",
    "mouth.width", "brow.y",   "lips",  "chin",  "ear.size", "nose.width"};

class MapReader {
 public:
  MapReader(Reading& in, const std::filesystem::path& folder) : in_(in), folder_(folder) {}

  ChernoffMap read(const JsonNode& root) {
    in_.expect_only(root, {"$schema", "format", "format_version", "label", "face", "map"},
                    "map of data");
    expect_format(in_, root, "mien-chernoff");
    if (const JsonNode* label = in_.find(root, "label"))
      map_.label = in_.string(*label), map_.label_where = in_.tree.where(*label);
    if (const JsonNode* face = in_.find(root, "face"))
      map_.face = read_recipe(in_, *face, &folder_);
    const JsonNode& features = in_.need(root, "map");
    in_.expect(features, JsonKind::array);
    if (std::size_t(features.count) > kMostFeatures)
      in_.refuse(features, fmt::format("a face has {} features at most", kMostFeatures));
    in_.for_each(features, [&](const JsonNode& node, int) { read_feature(node); });
    return std::move(map_);
  }

 private:
  void read_feature(const JsonNode& node) {
    in_.expect_only(node, {"column", "number", "emotion", "part", "scale", "from", "to", "values"},
                    "feature");
    const JsonNode& column = in_.need(node, "column");
    ChernoffFeature feature{
        .column = std::string(in_.string(column)), .where = in_.tree.where(column), .name = {}};
    const JsonNode *number = in_.find(node, "number"), *emotion = in_.find(node, "emotion"),
                   *part = in_.find(node, "part");
    if (int(number != nullptr) + int(emotion != nullptr) + int(part != nullptr) != 1)
      in_.refuse(node, "a column moves a \"number\", an \"emotion\" or a \"part\", one of them");
    if (number) read_number(*number, feature);
    if (emotion) {
      feature.kind = ChernoffFeatureKind::emotion;
      feature.name = kFeelings[in_.word(*emotion, "emotion", kFeelings)];
    }
    if (part) read_part(node, *part, feature);
    if (const JsonNode* scale = in_.find(node, "scale"))
      feature.scale = ChernoffScale(in_.word(*scale, "scale", kScales));
    if (const JsonNode* from = in_.find(node, "from")) feature.from = in_.range(*from);
    if (const JsonNode* to = in_.find(node, "to")) read_to(*to, feature);
    know(node, std::move(feature));
  }

  void read_number(const JsonNode& node, ChernoffFeature& feature) const {
    const std::vector<PartNumber> numbers = part_numbers();
    std::vector<std::string_view> names;
    for (const PartNumber& number : numbers) names.push_back(number.name);
    const PartNumber& number = numbers[in_.word(node, "number", names)];
    feature.name = number.name;
    feature.to = {number.lo, number.hi};
  }

  void read_part(const JsonNode& whole, const JsonNode& node, ChernoffFeature& feature) const {
    const std::vector<PartFamily> families = part_families();
    std::vector<std::string_view> names;
    for (const PartFamily& family : families) names.push_back(family.name);
    const PartFamily& family = families[in_.word(node, "family of parts", names)];
    feature.kind = ChernoffFeatureKind::part;
    feature.name = family.name;
    std::vector<std::string_view> parts(family.parts.begin(), family.parts.end());
    if (family.optional) parts.push_back("none");
    const JsonNode& values = in_.need(whole, "values");
    in_.expect(values, JsonKind::object);
    in_.for_each(values, [&](const JsonNode& value, int) {
      feature.values[std::string(in_.tree.key(value))] =
          parts[in_.word(value, feature.name, parts)];
    });
  }

  /// The ends of a number or of an emotion, in its range, in either order.
  void read_to(const JsonNode& node, ChernoffFeature& feature) const {
    if (feature.kind == ChernoffFeatureKind::part)
      in_.refuse(node, "parts have no range; \"values\" says which text is which part");
    const auto [lo, hi] = feature.to;
    const glm::dvec2 to = in_.pair(node);
    if (std::min(to.x, to.y) < lo || std::max(to.x, to.y) > hi)
      in_.refuse(node, fmt::format("{} goes from {} to {}, got {} and {}", feature.name, lo, hi,
                                   to.x, to.y));
    feature.to = {to.x, to.y};
  }

  void know(const JsonNode& node, ChernoffFeature feature) {
    for (const ChernoffFeature& other : map_.features) {
      if (other.kind == feature.kind && other.name == feature.name)
        in_.refuse(node,
                   fmt::format("{} is moved by {} already", feature.name, in_quotes(other.column)));
      if (other.column == feature.column)
        in_.warn(node, fmt::format("{} moves {}, too: one value is seen twice",
                                   in_quotes(feature.column), other.name));
    }
    map_.features.push_back(std::move(feature));
  }

  Reading& in_;
  const std::filesystem::path& folder_;
  ChernoffMap map_;
};

}  // namespace

Expected<ChernoffMap> read_chernoff_map(const std::filesystem::path& path,
                                        std::vector<Error>* warnings) {
  const FaceLimits limits;
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return text.error();
  const auto tree = JsonTree::read(*text, path.string(), limits);
  if (!tree) return tree.error();
  Reading in(*tree, limits, warnings);
  const std::filesystem::path folder = path.parent_path();
  try {
    return MapReader(in, folder).read(tree->root());
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

Expected<ChernoffMap> default_chernoff_map(const Table& table, std::vector<Error>* warnings) {
  const std::vector<PartNumber> numbers = part_numbers();
  ChernoffMap map;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string& column = table.columns[i];
    if (const auto numeric = table.numeric(i); !numeric) {
      if (!map.label && table.has_texts(i))
        map.label = column;
      else
        warnings->push_back(
            {numeric.error().where, numeric.error().what + ": the column is not shown"});
      continue;
    }
    if (map.features.size() == kDefaultNumbers.size()) {
      warnings->push_back(
          {table.name, in_quotes(column) + ": no feature is left for it: not shown"});
      continue;
    }
    const auto number =
        std::ranges::find(numbers, kDefaultNumbers[map.features.size()], &PartNumber::name);
    map.features.push_back(
        {.column = column, .name = number->name, .to = {number->lo, number->hi}});
  }
  if (map.features.empty()) return Error{table.name, "no column of numbers"};
  return map;
}

}  // namespace mien::command
