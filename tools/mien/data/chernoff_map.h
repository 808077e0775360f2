#pragma once
// Which column of a table moves which feature of a Chernoff face.

#include <mien/expected.h>
#include <mien/recipe.h>
#include "tools/mien/data/table.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mien::command {

/// How a column's values become places between 0 and 1.
enum class ChernoffScale {
  linear,   ///< evenly between the ends of `from`
  rank,     ///< by their order; equals share the mean of their ranks
  quartile  ///< by the quarter of the rows they are in: 0, 1/3, 2/3, 1
};

enum class ChernoffFeatureKind { number, emotion, part };

/// One column and what it moves.
struct ChernoffFeature {
  std::string column;
  std::string where = {};  ///< the map's place that names the column; empty: there is no map
  ChernoffFeatureKind kind = ChernoffFeatureKind::number;
  std::string name;  ///< the recipe's number, "joy", or the family of parts
  ChernoffScale scale = ChernoffScale::linear;
  std::optional<std::pair<double, double>> from =
      {};                                          ///< none: from the least to the largest value
  std::pair<double, double> to = {0, 1};           ///< the number at 0 and at 1; may fall
  std::map<std::string, std::string> values = {};  ///< a part for each text of the column
};

struct ChernoffMap {
  std::optional<std::string> label =
      {};                        ///< the column that names the faces; none: they are counted
  std::string label_where = {};  ///< the map's place that names it
  Recipe face = {};              ///< what no column moves
  std::vector<ChernoffFeature> features = {};
};

/// Reads a map (docs/data.md). Every name is known afterwards, but those of the table's columns. A
/// column that moves two features is a warning; two columns for one feature are an error.
Expected<ChernoffMap> read_chernoff_map(const std::filesystem::path& path,
                                        std::vector<Error>* warnings);

/// The map of a table without one: its numeric columns move, in their order, what people read most exactly
/// from faces; its first other column is the label. Columns for which nothing is left are warnings.
Expected<ChernoffMap> default_chernoff_map(const Table& table, std::vector<Error>* warnings);

}  // namespace mien::command
