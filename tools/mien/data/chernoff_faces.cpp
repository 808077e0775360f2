#include "tools/mien/data/chernoff_faces.h"
#include "lib/base/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mien::command {
namespace {

/// How a column's numbers become places.
class Column {
 public:
  /// Its values, all finite.
  Column(const ChernoffFeature& feature, std::vector<double> values)
      : feature_(feature), sorted_(std::move(values)) {
    std::ranges::sort(sorted_);
    from_ = feature.from.value_or(std::pair(sorted_.front(), sorted_.back()));
  }

  /// What a legend shows: the ends and the middle between them; by order, the least, median and largest value.
  std::array<double, 3> landmarks() const {
    const auto [lo, hi] = from_;
    if (feature_.scale == ChernoffScale::linear) return {lo, 0.5 * lo + 0.5 * hi, hi};
    const std::size_t half = sorted_.size() / 2;
    const double below = sorted_[(sorted_.size() - 1) / 2];
    return {sorted_.front(), 0.5 * below + 0.5 * sorted_[half], sorted_.back()};
  }

  /// 0 … 1. A column whose values are all equal is in the middle; by order, what is between two values is half-way.
  double place(double value) const {
    const auto [lo, hi] = from_;
    if (feature_.scale == ChernoffScale::linear) {
      if (!(hi > lo)) return 0.5;
      if (std::isfinite(hi - lo)) return (value - lo) / (hi - lo);
      return (0.5 * value - 0.5 * lo) / (0.5 * hi - 0.5 * lo);
    }
    if (sorted_.front() == sorted_.back()) return 0.5;
    const auto [first, last] = std::equal_range(sorted_.begin(), sorted_.end(), value);
    const double rank = 0.5 * double(first - sorted_.begin() + (last - 1) - sorted_.begin());
    const double share = rank / double(sorted_.size() - 1);
    if (feature_.scale == ChernoffScale::rank) return share;
    return std::min(std::floor(4 * share), 3.0) / 3;
  }

 private:
  const ChernoffFeature& feature_;
  std::vector<double> sorted_;
  std::pair<double, double> from_;
};

void wear(ChernoffFace& face, const ChernoffFeature& feature, double place) {
  const auto [lo, hi] = feature.to;
  const double value = std::clamp(lo + place * (hi - lo), std::min(lo, hi), std::max(lo, hi));
  if (feature.kind == ChernoffFeatureKind::emotion)
    face.emotions.emplace_back(feature.name, value);
  else
    face.recipe.numbers[feature.name] = value;
}

void wear(ChernoffFace& face, const ChernoffFeature& feature, const std::string& part) {
  const std::vector<PartFamily> families = part_families();
  const auto family = std::ranges::find(families, feature.name, &PartFamily::name);
  if (part == "none" && family->optional)
    face.recipe.parts.erase(feature.name);
  else
    face.recipe.parts[feature.name] = part;
}

Expected<Column> column_of(const Table& table, const ChernoffFeature& feature, std::size_t column) {
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const auto value = table.number(row, column);
    if (!value) return value.error();
    if (feature.from && (*value < feature.from->first || *value > feature.from->second))
      return Error{table.place(row, column),
                   fmt::format("{} is outside the map's {} … {}", *value, feature.from->first,
                               feature.from->second)};
    values.push_back(*value);
  }
  return Column(feature, std::move(values));
}

/// The index of a column that a map names at `where`.
Expected<std::size_t> named_column(const Table& table, const std::string& column,
                                   const std::string& where) {
  auto at = table.column(column);
  if (at || where.empty()) return at;
  return Error{where, table.name + " has " + at.error().what};
}

Expected<Done> wear_column(const Table& table, const ChernoffFeature& feature,
                           std::vector<ChernoffFace>& faces) {
  const auto at = named_column(table, feature.column, feature.where);
  if (!at) return at.error();
  if (feature.kind == ChernoffFeatureKind::part) {
    for (std::size_t row = 0; row < faces.size(); ++row) {
      const auto part = feature.values.find(table.rows[row][*at]);
      if (part == feature.values.end())
        return Error{table.place(row, *at), fmt::format("the map has no {} for {}", feature.name,
                                                        in_quotes(table.rows[row][*at]))};
      wear(faces[row], feature, part->second);
    }
    return Done{};
  }
  const auto column = column_of(table, feature, *at);
  if (!column) return column.error();
  for (std::size_t row = 0; row < faces.size(); ++row)
    wear(faces[row], feature, column->place(*table.number(row, *at)));
  return Done{};
}

/// Whether all rows have one value there, of which nothing can be read off the faces.
bool is_constant(const Table& table, const ChernoffFeature& feature) {
  const auto at = table.column(feature.column);
  if (!at || feature.kind == ChernoffFeatureKind::part || feature.from) return false;
  for (std::size_t row = 1; row < table.rows.size(); ++row)
    if (*table.number(row, *at) != *table.number(0, *at)) return false;
  return true;
}

}  // namespace

std::optional<Error> constant_columns(const Table& table, const ChernoffMap& map) {
  std::string columns;
  for (const ChernoffFeature& feature : map.features)
    if (is_constant(table, feature))
      columns += (columns.empty() ? "" : ", ") + in_quotes(feature.column);
  if (columns.empty()) return {};
  if (table.rows.size() == 1)
    return Error{table.name, "has one row: its face has the middle of each range"};
  return Error{table.name, fmt::format("the same value in every row: {}; all faces have the middle "
                                       "of the range there",
                                       columns)};
}

Expected<std::vector<ChernoffFace>> chernoff_faces(const Table& table, const ChernoffMap& map) {
  std::vector<ChernoffFace> faces(table.rows.size(),
                                  {.label = {}, .recipe = map.face, .emotions = {}});
  std::optional<std::size_t> label;
  if (map.label) {
    const auto found = named_column(table, *map.label, map.label_where);
    if (!found) return found.error();
    label = *found;
  }
  for (std::size_t row = 0; row < faces.size(); ++row)
    faces[row].label = label ? table.rows[row][*label] : std::to_string(row + 1);
  for (const ChernoffFeature& feature : map.features)
    if (const auto done = wear_column(table, feature, faces); !done) return done.error();
  return faces;
}

Expected<std::vector<ChernoffFace>> chernoff_legend(const Table& table, const ChernoffMap& map,
                                                    const ChernoffFeature& feature) {
  std::vector<ChernoffFace> faces;
  const auto add = [&](std::string label, const auto& what) {
    faces.push_back({std::move(label), map.face, {}});
    wear(faces.back(), feature, what);
  };
  if (feature.kind == ChernoffFeatureKind::part) {
    for (const auto& [text, part] : feature.values)
      add(fmt::format("{}: {}", feature.column, text), part);
    return faces;
  }
  const auto at = table.column(feature.column);
  if (!at) return at.error();
  const auto column = column_of(table, feature, *at);
  if (!column) return column.error();
  for (const double value : column->landmarks())
    add(fmt::format("{}: {:.6g}", feature.column, value), column->place(value));
  return faces;
}

}  // namespace mien::command
