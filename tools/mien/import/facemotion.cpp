#include "tools/mien/import/facemotion.h"

#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/face/read_muscles.h"
#include "lib/file/json/reading.h"
#include "standard_tables_private.h"
#include "tools/mien/import/javascript_literal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace mien {
namespace {

constexpr double kStrokeWidth = 5;  ///< of weight 1

struct Polyline {
  std::vector<std::array<double, 2>> points;
};
struct Circle {
  std::array<double, 2> center;
  double radius, upper, lower;
};
struct ImportedFeature {
  std::string name;
  double weight;
  bool is_circle;
  Polyline line;
  Circle circle;
};

/// JSON text of a string; names have no quotes or backslashes.
std::string json_quoted(std::string_view text) {
  return fmt::format("\"{}\"", text);
}

std::string join(const std::vector<std::string>& parts, std::string_view between) {
  return fmt::format("{}", fmt::join(parts, between));
}

class Importer {
 public:
  Importer(Reading& in, const FacemotionOptions& options) : in_(in), options_(options) {}

  std::string text() {
    const JsonNode& morphology = chosen();
    strict(morphology, {"version", "stiffness", "damping", "features", "muscleGroups", "recipes"},
           "morphology");
    const JsonNode& version = in_.need(morphology, "version");
    if (in_.number(version) != 1)
      in_.refuse(version, fmt::format("expected version 1, got {}", in_.number(version)));
    read_features(in_.need(morphology, "features"));
    const double stiffness =
        bounded(in_.need(morphology, "stiffness"), kLeastStiffness, kMostStiffness, "stiffness");
    const double damping =
        bounded(in_.need(morphology, "damping"), kLeastDamping, kMostDamping, "damping");
    std::string all = head(in_.tree.key(morphology)) + features_text();
    all += fmt::format(",\n\n  \"muscles\": {{\"stiffness\": {}, \"damping\": {}, \"groups\": [\n",
                       stiffness, damping);
    all += muscles_text(in_.need(morphology, "muscleGroups")) + "\n  ]}";
    if (const JsonNode* recipes = in_.find(morphology, "recipes"))
      all += ",\n\n  \"emotions\": {\n" + recipes_text(*recipes) + "\n  }";
    return all + ",\n\n  \"expressions\": {\n" + tables_text() + "\n  }\n}\n";
  }

 private:
  /// The object whose members are morphologies: the file, or in JSON its only object, {"male": {…}}.
  const JsonNode& named_morphologies() const {
    const JsonNode& root = in_.tree.root();
    const JsonNode* only = root.count == 1 ? in_.tree.first(root) : nullptr;
    if (!only || !in_.tree.key(*only).empty() || in_.find(*only, "version") ||
        in_.find(*only, "features"))
      return root;
    bool objects = only->count > 0;
    in_.for_each(*only, [&](const JsonNode& one, int) { objects &= one.kind == JsonKind::object; });
    return objects ? *only : root;
  }

  /// The morphology asked for, or the only one.
  const JsonNode& chosen() const {
    const JsonNode& root = named_morphologies();
    std::vector<std::string_view> names;
    in_.for_each(root, [&](const JsonNode& child, int) { names.push_back(in_.tree.key(child)); });
    if (options_.morphology.empty()) {
      if (names.empty()) in_.refuse(root, "there is no object literal in it");
      if (names.size() > 1)
        in_.refuse(root, fmt::format("it has {} morphologies, {}: say which", names.size(),
                                     fmt::join(names, ", ")));
      return *in_.tree.first(root);
    }
    const JsonNode* found = in_.find(root, options_.morphology);
    if (!found) in_.refuse(root, unknown_name("morphology", options_.morphology, names));
    return *found;
  }

  /// An object whose keys must all be known; those that begin with _ are remarks.
  void strict(const JsonNode& node, const std::vector<std::string_view>& known,
              std::string_view whose) const {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string_view key = in_.tree.key(child);
      if (!key.starts_with('_') && std::find(known.begin(), known.end(), key) == known.end())
        in_.refuse(child, unknown_name(fmt::format("key of a {}", whose), key, known));
    });
  }

  double bounded(const JsonNode& node, double lo, double hi, std::string_view what) const {
    const double number = in_.number(node);
    if (!(number >= lo && number <= hi))
      in_.refuse(node, fmt::format("{} goes from {} to {}, got {}", what, lo, hi, number));
    return number;
  }

  std::array<double, 2> point(const JsonNode& node) const {
    strict(node, {"x", "y"}, "point");
    return {in_.number(in_.need(node, "x")), in_.number(in_.need(node, "y"))};
  }

  void read_features(const JsonNode& node) {
    in_.expect(node, JsonKind::object);
    in_.for_each(node, [&](const JsonNode& child, int) {
      ImportedFeature feature{.name = in_.name(child, in_.tree.key(child))};
      if (feature.name == "palette" || feature.name.ends_with(".left") ||
          feature.name.ends_with(".right"))
        in_.refuse(child, fmt::format("no feature may be called {}", in_quotes(feature.name)));
      const JsonNode* type = in_.find(child, "type");
      constexpr std::array<std::string_view, 1> kTypes{"circle"};
      feature.is_circle = type && in_.word(*type, "type of feature", kTypes) == 0;
      feature.weight = bounded(in_.need(child, "weight"), 0, in_.limits.magnitude, "a weight");
      if (feature.is_circle) {
        strict(child, {"type", "center", "radius", "weight", "upperChord", "lowerChord"}, "circle");
        const auto length = [&](std::string_view key) {
          return bounded(in_.need(child, key), 0, in_.limits.magnitude, key);
        };
        feature.circle = {point(in_.need(child, "center")), length("radius"), length("upperChord"),
                          length("lowerChord")};
      } else {
        strict(child, {"points", "weight", "type"}, "feature");
        const JsonNode& points = in_.need(child, "points");
        in_.expect(points, JsonKind::array);
        if (points.count < 1) in_.refuse(points, "expected at least 1 point, got 0");
        in_.for_each(points,
                     [&](const JsonNode& p, int) { feature.line.points.push_back(point(p)); });
      }
      features_.push_back(std::move(feature));
    });
  }

  /// A square about the axis with a margin around the features. Three fifths of the upright margin are
  /// above them, for a forehead.
  std::array<double, 3> canvas() const {
    double far = 1, low = std::numeric_limits<double>::infinity(), high = -low;
    const auto cover = [&](const std::array<double, 2>& p, double around) {
      far = std::max(far, std::abs(p[0]) + around);
      low = std::min(low, p[1] - around), high = std::max(high, p[1] + around);
    };
    for (const ImportedFeature& f : features_) {
      for (const auto& p : f.line.points) cover(p, 0);
      if (f.is_circle) cover(f.circle.center, f.circle.radius);
    }
    if (!(low <= high)) low = high = 0;
    const double side = 2 * std::max(1.4 * far, 0.725 * (high - low));
    const double grid = std::pow(10, std::floor(std::log10(side) - 1));
    const double half = grid * std::ceil(0.5 * side / grid);
    const double top = grid * std::round((low - 0.6 * (2 * half - (high - low))) / grid);
    return {half, top, top + 2 * half};
  }

  std::string head(std::string_view name) const {
    const auto [half, top, bottom] = canvas();
    return fmt::format(R"({{
  "$schema": "../docs/face.schema.json",
  "format": "mien-face",
  "format_version": 1,
  "name": {0},
  "credit": "The \"{1}\" morphology of facemotion.js, Copyright (c) 2014 Paul Mandel, MIT License",
  "comment": "Written by mien import facemotion. Strokes are 5 times their weight wide, the eyeball is filled.",

  "canvas": {{"x": [{2}, {3}], "y": [{4}, {5}], "y_axis": "down", "unit": "units"}},
  "background": "paper",
  "palette": {{"paper": "#ffffff", "ink": "#000000"}},

  "features": [
)",
                       json_quoted(name.empty() ? "facemotion" : one_line(name, 60)),
                       one_line(name.empty() ? "facemotion" : name, 60), -half, half, top, bottom);
  }

  std::string features_text() const {
    std::vector<std::string> lines;
    for (const ImportedFeature& f : features_) {
      std::string line = fmt::format(
          "    {{\"name\": {}, \"kind\": \"{}\", \"side\": \"left\", "
          "\"paint\": \"ink\",",
          json_quoted(f.name), f.is_circle ? "cut_disc" : "polyline");
      if (f.is_circle) {
        const Circle& c = f.circle;
        line += fmt::format("\n     \"center\": [{}, {}], \"radius\": {}, \"chords\": [{}, {}]}}",
                            c.center[0], c.center[1], c.radius, c.upper, c.lower);
      } else {
        std::vector<std::string> points;
        for (const auto& p : f.line.points) points.push_back(fmt::format("[{}, {}]", p[0], p[1]));
        line += fmt::format(" \"half_width\": {},{}\n     \"points\": [{}]}}",
                            0.5 * kStrokeWidth * f.weight,
                            options_.smooth ? " \"smooth\": true," : "", join(points, ", "));
      }
      lines.push_back(std::move(line));
    }
    return join(lines, ",\n") + "\n  ]";
  }

  std::string muscles_text(const JsonNode& node) {
    in_.expect(node, JsonKind::object);
    std::vector<std::string> lines;
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string name = in_.name(child, in_.tree.key(child));
      if (name.find('.') != std::string::npos)
        in_.refuse(child, fmt::format("the name of a muscle has no dots, got {}", in_quotes(name)));
      strict(child, {"strength", "stroke", "origin", "muscles"}, "muscle group");
      const double strength = bounded(in_.need(child, "strength"), 0, kMostStrength, "a strength");
      const double stroke = bounded(in_.need(child, "stroke"), 0, in_.limits.magnitude, "a stroke");
      const auto origin = point(in_.need(child, "origin"));
      std::vector<std::string> holds;
      const JsonNode& muscles = in_.need(child, "muscles");
      in_.expect(muscles, JsonKind::object);
      in_.for_each(muscles, [&](const JsonNode& hold, int) {
        holds.push_back(fmt::format("\"{}\": {}", attachment(hold, in_.tree.key(hold)),
                                    bounded(hold, 0, 1, "a weight")));
      });
      lines.push_back(fmt::format(
          "    {{\"name\": {}, \"side\": \"left\", \"strength\": {}, "
          "\"stroke\": {}, \"origin\": [{}, {}],\n     \"attach\": {{{}}}}}",
          json_quoted(name), strength, stroke, origin[0], origin[1], join(holds, ", ")));
      muscle_names_.push_back(name);
    });
    return join(lines, ",\n");
  }

  /// "mouth:2" → "mouth/points/2", "eyeball:scale" → "eyeball/scale".
  std::string attachment(const JsonNode& node, std::string_view name) const {
    std::vector<std::string> known;
    for (const ImportedFeature& f : features_) {
      if (f.is_circle) {
        known.push_back(f.name + ":scale");
        if (known.back() == name) return f.name + "/scale";
      }
      for (std::size_t i = 0; i < f.line.points.size(); ++i) {
        known.push_back(fmt::format("{}:{}", f.name, i));
        if (known.back() == name) return fmt::format("{}/points/{}", f.name, i);
      }
    }
    in_.refuse(node, unknown_name("attachment", name, {known.begin(), known.end()}));
  }

  std::string recipes_text(const JsonNode& node) {
    in_.expect(node, JsonKind::object);
    std::vector<std::string> lines;
    in_.for_each(node, [&](const JsonNode& child, int) {
      const std::string name = in_.name(child, in_.tree.key(child));
      in_.expect(child, JsonKind::object);
      std::vector<std::string> parts;
      in_.for_each(child, [&](const JsonNode& part, int) {
        const std::string_view muscle = in_.tree.key(part);
        if (std::find(muscle_names_.begin(), muscle_names_.end(), muscle) == muscle_names_.end())
          in_.refuse(part,
                     unknown_name("muscle", muscle, {muscle_names_.begin(), muscle_names_.end()}));
        parts.push_back(fmt::format("\"{}\": {}", muscle, bounded(part, 0, 1, "an engagement")));
      });
      lines.push_back(fmt::format("    {}: {{{}}}", json_quoted(name), join(parts, ", ")));
      emotion_names_.push_back(name);
    });
    return join(lines, ",\n");
  }

  bool has(std::string_view name) const {
    const auto among = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    return among(muscle_names_) || among(emotion_names_);
  }

  std::string tables_text() const {
    std::vector<std::string> sets;
    for (const StandardTable& table : standard_tables()) {
      std::vector<std::string> lines;
      std::string_view rest = table.lines.substr(1);
      for (; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        if (line.substr(0, line.find(' ')).find('*') == std::string_view::npos) {
          lines.push_back(table_line(line, {}));
        } else {
          lines.push_back(table_line(line, "Left"));
          lines.push_back(table_line(line, "Right"));
        }
      }
      sets.push_back(fmt::format("    \"{}\": {{\n{}\n    }}", table.set, join(lines, ",\n")));
    }
    return join(sets, ",\n");
  }

  /// Only of muscles and emotions that there are.
  std::string table_line(std::string_view line, std::string_view side) const {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = std::min(line.find(' ', at), line.size());
      words.emplace_back(line.substr(at, end - at));
      at = end + 1;
    }
    if (!side.empty()) words[0].replace(words[0].find('*'), 1, side);
    const std::string prefix = side.empty() ? "" : side == "Left" ? "left." : "right.";
    std::vector<std::string> parts;
    for (std::size_t i = 1; i + 1 < words.size(); i += 2) {
      const std::string& name = words[i];
      if (has(name.substr(name.find('.') == std::string::npos ? 0 : name.find('.') + 1)))
        parts.push_back(fmt::format("\"{}{}\": {}", prefix, name, words[i + 1]));
    }
    return fmt::format("      {}: {{{}}}", json_quoted(words[0]), join(parts, ", "));
  }

  Reading& in_;
  const FacemotionOptions& options_;
  std::vector<ImportedFeature> features_;
  std::vector<std::string> muscle_names_, emotion_names_;
};

}  // namespace

Expected<std::string> face_text_from_facemotion(std::string_view text, std::string_view name,
                                                const FacemotionOptions& options) {
  const FaceLimits& limits = options.limits;
  if (text.size() > limits.bytes || text.size() > std::numeric_limits<std::uint32_t>::max())
    return Error{one_line(name), fmt::format("longer than {} bytes (limit: bytes)", limits.bytes)};
  try {
    const Expected<JsonTree> tree = read_javascript(text, name, limits);
    if (!tree) return tree.error();
    Reading in(*tree, limits, nullptr);
    std::string made = Importer(in, options).text();
    // What is made must read as a face, so the importer is neither stricter than the reader nor laxer.
    if (const Expected<Face> face = read_face_text(made, one_line(name), limits); !face)
      return Error{one_line(name), fmt::format("makes no face: {}", sentence(face.error()))};
    return made;
  } catch (const Refusal& refusal) {
    return refusal.error;
  } catch (const std::exception& e) {
    return Error{one_line(name), fmt::format("cannot be read: {}", one_line(e.what()))};
  }
}

}  // namespace mien
