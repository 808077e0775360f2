#include "tools/mien/data/stimulus_plan.h"
#include <mien/crowd.h>
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/file/json/read_bytes.h"
#include "lib/parts/recipe/recipe_file.h"
#include "tools/mien/data/feelings.h"
#include "tools/mien/data/file_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mien::command {
namespace {

constexpr std::array<std::string_view, 3> kEquals{"number", "displacement", "picture"};
constexpr int kMostSteps = 1000, kMostFactors = 32, kMostPeople = 10'000;
constexpr double kMostCaricature = 10;  // times as far from the mean
constexpr double kLargest = 8192;       // [px] of a picture

/// The numbers' means and each family's most frequent part.
Recipe mean_of(const std::vector<Recipe>& people) {
  Recipe mean = people[0];
  mean.code.clear();
  for (const PartNumber& number : part_numbers()) {
    double sum = 0;
    for (const Recipe& one : people) {
      const auto own = one.numbers.find(number.name);
      sum += own == one.numbers.end() ? number.rest : own->second;
    }
    mean.numbers[number.name] = sum / double(people.size());
  }
  for (const PartFamily& family : part_families()) {
    std::map<std::string, int> votes;
    for (const Recipe& one : people) {
      const auto part = one.parts.find(family.name);
      ++votes[part == one.parts.end() ? "" : part->second];
    }
    const auto most = std::ranges::max_element(
        votes, [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most->first.empty())
      mean.parts.erase(family.name);
    else
      mean.parts[family.name] = most->first;
  }
  return mean;
}

class PlanReader {
 public:
  PlanReader(Reading& in, const std::filesystem::path& folder) : in_(in), folder_(folder) {}

  StimulusPlan read(const JsonNode& root) {
    in_.expect_only(root,
                    {"$schema", "format", "format_version", "face", "size", "factors", "sample",
                     "seed", "pairs", "neutral"},
                    "plan");
    expect_format(in_, root, "mien-stimuli");
    if (const JsonNode* neutral = in_.find(root, "neutral")) plan_.neutral = in_.boolean(*neutral);
    if (const JsonNode* face = in_.find(root, "face")) read_face(*face);
    if (const JsonNode* size = in_.find(root, "size")) plan_.size = whole(*size, 16, kLargest);
    if (const JsonNode* seed = in_.find(root, "seed")) plan_.seed = word(*seed);
    const JsonNode& factors = in_.need(root, "factors");
    in_.expect(factors, JsonKind::array);
    if (factors.count < 1 || factors.count > kMostFactors)
      in_.refuse(factors, fmt::format("expected 1 to {} factors", kMostFactors));
    in_.for_each(factors, [&](const JsonNode& node, int) { read_factor(node); });
    if (const JsonNode* pairs = in_.find(root, "pairs")) read_pairs(*pairs);
    const double most = double(kMostStimuli) / (plan_.pairs ? 2 : 1);
    if (const JsonNode* sample = in_.find(root, "sample"))
      plan_.sample = whole(*sample, 1, std::min(combinations(), most));
    else
      check_count(factors, most);
    return std::move(plan_);
  }

 private:
  /// A smile that the plan itself asks for stays.
  void read_face(const JsonNode& node) {
    const Recipe read = read_recipe(in_, node, &folder_);
    plan_.face = plan_.neutral && !read.code.empty() ? neutral_recipe(read) : read;
    if (const JsonNode* parts = in_.find(node, "parts"))
      in_.for_each(*parts, [&](const JsonNode& part, int) {
        const std::string family(in_.tree.key(part));
        if (!read.parts.contains(family)) plan_.without.push_back(family);
      });
    if (const JsonNode* numbers = in_.find(node, "numbers"))
      in_.for_each(*numbers, [&](const JsonNode& number, int) {
        const std::string name(in_.tree.key(number));
        plan_.face.numbers[name] = read.numbers.at(name);
      });
  }

  /// A seed: a word, or a whole number, which is the word of its digits as after --seed.
  std::string word(const JsonNode& node) const {
    if (node.kind == JsonKind::number) {
      constexpr double kExact = 9007199254740992;  // 2^53
      const double number = in_.number(node);
      if (number >= 0 && number <= kExact && number == std::floor(number))
        return fmt::format("{:.0f}", number);
      in_.refuse(node, fmt::format("expected a word or a whole number, got {}", number));
    }
    const std::string_view text = in_.string(node);
    if (text.empty()) in_.refuse(node, "an empty word is no seed");
    return std::string(text);
  }

  int whole(const JsonNode& node, double least, double most) const {
    const double value = in_.number(node);
    if (value != double(int(std::clamp(value, -1e9, 1e9))) || value < least || value > most)
      in_.refuse(node,
                 fmt::format("expected a whole number from {} to {}, got {}", least, most, value));
    return int(value);
  }

  void read_factor(const JsonNode& node) {
    in_.expect_only(
        node,
        {"name", "codes", "people", "seed", "mean", "number", "emotion", "emotions", "control",
         "part", "caricature", "picture", "values", "steps", "from", "to", "equal"},
        "factor");
    static constexpr std::array<std::string_view, 9> kKinds{"codes",   "people",     "number",
                                                            "emotion", "emotions",   "control",
                                                            "part",    "caricature", "picture"};
    const JsonNode* kind = nullptr;
    for (const std::string_view key : kKinds)
      if (const JsonNode* found = in_.find(node, key)) {
        if (kind)
          in_.refuse(*found, fmt::format("a factor varies one thing, this one \"{}\"",
                                         in_.tree.key(*kind)));
        kind = found;
      }
    if (!kind) in_.refuse(node, fmt::format("a factor varies one of {}", fmt::join(kKinds, ", ")));
    Factor factor{.name = std::string(in_.tree.key(*kind)),
                  .where = in_.tree.where(*kind),
                  .what = {},
                  .levels = {},
                  .values = {},
                  .each = {},
                  .people = {},
                  .mean = {}};
    const std::string_view key = in_.tree.key(*kind);
    if (key == "codes") in_.expect(*kind, JsonKind::array);
    if (key == "codes" || key == "people") read_people(node, *kind, factor);
    if (key == "number") read_number(node, *kind, factor);
    if (key == "emotion" || key == "control") read_control(node, *kind, factor);
    if (key == "emotions") read_emotions(node, *kind, factor);
    if (key == "part") read_part(node, *kind, factor);
    if (key == "caricature") read_caricature(*kind, factor);
    if (key == "picture") read_picture(*kind, factor);
    if (const JsonNode* name = in_.find(node, "name")) factor.name = in_.string(*name);
    for (const Factor& other : plan_.factors)
      for (const std::string& column : factor.columns())
        if (std::ranges::count(other.columns(), column) > 0)
          in_.refuse(node, fmt::format("two factors are called {}", in_quotes(column)));
    refuse_same(*kind, factor);
    plan_.factors.push_back(std::move(factor));
  }

  static bool vary_one(const Factor& a, const Factor& b) {
    const auto varies = [](const Factor& factor, const std::string& what) {
      return factor.each.empty() ? factor.what == what : std::ranges::count(factor.each, what) > 0;
    };
    if (a.each.empty()) return varies(b, a.what);
    return std::ranges::any_of(a.each, [&](const std::string& what) { return varies(b, what); });
  }

  /// Of two factors that vary the same thing, one would void the other.
  void refuse_same(const JsonNode& kind, const Factor& factor) const {
    for (const Factor& other : plan_.factors)
      if (other.kind == factor.kind && vary_one(other, factor))
        in_.refuse(kind, fmt::format("{} is varied by {} already",
                                     factor.what.empty() ? in_.tree.key(kind) : factor.what,
                                     in_quotes(other.name)));
  }

  /// Levels are told apart: two equal ones would be the same pictures.
  template <class Levels>
  void refuse_equal(const JsonNode& node, const Levels& levels) const {
    const JsonNode* at = node.kind == JsonKind::array ? in_.tree.first(node) : nullptr;
    for (auto level = levels.begin(); at && level != levels.end(); ++level, at = in_.tree.next(*at))
      if (std::find(levels.begin(), level, *level) != level)
        in_.refuse(*at, fmt::format("{} is a level already", *level));
  }

  void read_people(const JsonNode& node, const JsonNode& kind, Factor& factor) const {
    factor.kind = FactorKind::person;
    std::vector<std::string> codes;
    if (kind.kind == JsonKind::array) {
      in_.for_each(kind, [&](const JsonNode& code, int) {
        const auto read = read_face_code(in_.string(code));
        if (!read) in_.refuse(code, read.error().what);
        auto recipe = recipe_from_code(*read);
        if (!recipe) in_.refuse(code, recipe.error().what);
        factor.people.push_back(*std::move(recipe));
        factor.levels.push_back(face_code_text(*read));
      });
      refuse_equal(kind, factor.levels);
    } else {
      const JsonNode* seed = in_.find(node, "seed");
      for (const FaceCode& code : crowd(seed ? word(*seed) : "1", whole(kind, 1, kMostPeople))) {
        factor.people.push_back(recipe_from_code(code).value());
        factor.levels.push_back(face_code_text(code));
      }
    }
    if (factor.people.empty()) in_.refuse(kind, "nobody is named");
    factor.mean = mean_of(factor.people);
    if (const JsonNode* mean = in_.find(node, "mean"); mean && in_.boolean(*mean)) {
      factor.people.push_back(factor.mean);
      factor.levels.emplace_back("mean");
    }
  }

  void read_number(const JsonNode& node, const JsonNode& kind, Factor& factor) const {
    const std::vector<PartNumber> numbers = part_numbers();
    std::vector<std::string_view> names;
    for (const PartNumber& number : numbers) names.push_back(number.name);
    const PartNumber& number = numbers[in_.word(kind, "number", names)];
    factor.what = number.name;
    read_scale(node, number.lo, number.hi, factor);
  }

  /// An emotion's control: "joy", or "left.joy".
  std::string emotion(const JsonNode& node) const {
    const std::string_view text = in_.string(node);
    std::string_view whole = text;
    for (const std::string_view side : {"left.", "right."})
      if (text.starts_with(side)) whole.remove_prefix(side.size());
    if (std::ranges::count(kFeelings, whole) == 0)
      in_.refuse(node, unknown_name("emotion", text, {kFeelings.begin(), kFeelings.end()}));
    return "emotion." + std::string(text);
  }

  void read_control(const JsonNode& node, const JsonNode& kind, Factor& factor) const {
    factor.kind = FactorKind::control;
    const bool feeling = in_.tree.key(kind) == "emotion";
    factor.what = feeling ? emotion(kind) : std::string(in_.string(kind));
    factor.name = in_.string(kind);
    read_scale(node, 0, 1, factor);
  }

  /// One emotion after the other, each at every strength.
  void read_emotions(const JsonNode& node, const JsonNode& kind, Factor& factor) const {
    factor.kind = FactorKind::control;
    in_.expect(kind, JsonKind::array);
    std::vector<std::string> names;
    in_.for_each(kind, [&](const JsonNode& one, int) {
      emotion(one);
      names.emplace_back(in_.string(one));
    });
    if (names.empty()) in_.refuse(kind, "no emotion is named");
    refuse_equal(kind, names);
    if (const JsonNode* equal = in_.find(node, "equal"))
      in_.refuse(*equal, "steps are equal along one emotion, and there are several");
    read_scale(node, 0, 1, factor);
    const std::vector<double> strengths = std::exchange(factor.values, {});
    factor.levels.clear();
    for (const std::string& name : names)
      for (const double strength : strengths) {
        factor.each.push_back("emotion." + name);
        factor.values.push_back(strength);
        factor.levels.push_back(name);
      }
  }

  /// "values": […], or "steps" from "from" to "to", which are in the range and are its ends if not given.
  void read_scale(const JsonNode& node, double lo, double hi, Factor& factor) const {
    if (factor.kind == FactorKind::number) factor.name = factor.what;
    const auto in_range = [&](const JsonNode& at, double value) {
      if (factor.kind == FactorKind::number && !(value >= lo && value <= hi))
        in_.refuse(at, fmt::format("{} goes from {} to {}, got {}", factor.what, lo, hi, value));
      return value;
    };
    if (const JsonNode* values = in_.find(node, "values")) {
      factor.values = in_.numbers(*values, 1, kMostSteps);
      for (const double value : factor.values) in_range(*values, value);
      refuse_equal(*values, factor.values);
    } else {
      const JsonNode* const steps_node = in_.find(node, "steps");
      if (!steps_node) in_.refuse(node, "\"values\" are missing, or \"steps\" between two ends");
      const JsonNode& from = *steps_node;
      const int steps = whole(from, 2, kMostSteps);
      if (const JsonNode* end = in_.find(node, "from")) lo = in_range(*end, in_.number(*end));
      if (const JsonNode* end = in_.find(node, "to")) hi = in_range(*end, in_.number(*end));
      if (lo == hi)
        in_.refuse(from, fmt::format("{} steps from {} to {} are equal", steps, lo, hi));
      for (int i = 0; i < steps; ++i)
        factor.values.push_back(i == steps - 1 ? hi : lo + (hi - lo) * i / (steps - 1));
    }
    if (const JsonNode* equal = in_.find(node, "equal")) {
      factor.equal = EqualIn(in_.word(*equal, "measure", kEquals));
      if (factor.equal != EqualIn::number && factor.values.size() < 2)
        in_.refuse(*equal, "equal steps have two ends at least");
    }
    factor.levels.resize(factor.values.size());
  }

  void read_part(const JsonNode& node, const JsonNode& kind, Factor& factor) const {
    const std::vector<PartFamily> families = part_families();
    std::vector<std::string_view> names;
    for (const PartFamily& family : families) names.push_back(family.name);
    const PartFamily& family = families[in_.word(kind, "family of parts", names)];
    factor.kind = FactorKind::part;
    factor.name = factor.what = family.name;
    std::vector<std::string_view> parts(family.parts.begin(), family.parts.end());
    if (family.optional) parts.push_back("none");
    const JsonNode* values = in_.find(node, "values");
    if (!values) {
      factor.levels.assign(parts.begin(), parts.end());
      return;
    }
    in_.expect(*values, JsonKind::array);
    in_.for_each(*values, [&](const JsonNode& value, int) {
      const bool none = value.kind == JsonKind::null && family.optional;
      factor.levels.emplace_back(none ? "none" : parts[in_.word(value, family.name, parts)]);
    });
    if (factor.levels.empty()) in_.refuse(*values, "no part is named");
    refuse_equal(*values, factor.levels);
  }

  void read_caricature(const JsonNode& kind, Factor& factor) const {
    const bool people = std::ranges::any_of(plan_.factors, [](const Factor& one) {
      return one.kind == FactorKind::person && one.people.size() > 1;
    });
    if (!people)
      in_.refuse(kind,
                 "a caricature leads away from the mean of people: name two or more before it");
    factor.kind = FactorKind::caricature;
    factor.values = in_.numbers(kind, 1, kMostSteps);
    for (const double value : factor.values)
      if (!(std::abs(value) <= kMostCaricature))
        in_.refuse(kind, fmt::format("a caricature goes from -{0} to {0}, got {1}", kMostCaricature,
                                     value));
    refuse_equal(kind, factor.values);
    factor.levels.resize(factor.values.size());
  }

  void read_picture(const JsonNode& kind, Factor& factor) const {
    factor.kind = FactorKind::picture;
    in_.expect(kind, JsonKind::array);
    in_.for_each(kind, [&](const JsonNode& value, int) {
      const std::size_t word = in_.word(value, "picture", kStimulusPictures);
      factor.levels.emplace_back(kStimulusPictures[word]);
      factor.values.push_back(double(word));
    });
    if (factor.levels.empty()) in_.refuse(kind, "no picture is named");
    refuse_equal(kind, factor.levels);
  }

  void read_pairs(const JsonNode& node) {
    std::vector<std::string_view> names;
    for (const Factor& factor : plan_.factors) names.push_back(factor.name);
    plan_.pairs = in_.word(node, "factor", names);
    Factor& factor = plan_.factors[*plan_.pairs];
    if (factor.levels.size() < 2)
      in_.refuse(node, "a pair differs in two levels, and this factor has one");
  }

  /// Pairs count once. As a double, which does not overflow here.
  double combinations() const {
    double all = 1;
    for (std::size_t i = 0; i < plan_.factors.size(); ++i)
      if (i != plan_.pairs) all *= double(plan_.factors[i].levels.size());
    return all;
  }

  void check_count(const JsonNode& node, double most) const {
    if (combinations() <= most) return;
    std::string product;
    for (std::size_t i = 0; i < plan_.factors.size(); ++i)
      product += fmt::format("{}{}", i > 0 ? " × " : "",
                             i == plan_.pairs ? 2 : plan_.factors[i].levels.size());
    in_.refuse(node,
               fmt::format("{} = {:.0f} pictures; a plan has {} at most, or \"sample\" draws "
                           "some of them by lot",
                           product, combinations() * double(kMostStimuli) / most, kMostStimuli));
  }

  Reading& in_;
  const std::filesystem::path& folder_;
  StimulusPlan plan_;
};

}  // namespace

Expected<StimulusPlan> read_stimulus_plan(const std::filesystem::path& path,
                                          std::vector<Error>* warnings) {
  const FaceLimits limits;
  const auto text = read_bytes(path, limits.bytes);
  if (!text) return text.error();
  const auto tree = JsonTree::read(*text, path.string(), limits);
  if (!tree) return tree.error();
  Reading in(*tree, limits, warnings);
  const std::filesystem::path folder = path.parent_path();
  try {
    return PlanReader(in, folder).read(tree->root());
  } catch (const Refusal& refusal) {
    return refusal.error;
  }
}

}  // namespace mien::command
