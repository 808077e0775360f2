#pragma once
// Chernoff faces (Herman Chernoff, 1973): a row of a table is a face, each column one of its features.

#include "tools/mien/data/chernoff_map.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace mien::command {

/// A face of data before it is drawn.
struct ChernoffFace {
  std::string label;
  Recipe recipe;
  std::vector<std::pair<std::string, double>> emotions;  ///< "joy" and its strength
};

/// A face for each row. Errors name the cell: a value that is missing, no number, outside a given `from`,
/// or a text without a part; or the map's place for a column that the table does not have.
Expected<std::vector<ChernoffFace>> chernoff_faces(const Table& table, const ChernoffMap& map);

/// A warning where columns have one value in every row, of which the faces show nothing.
std::optional<Error> constant_columns(const Table& table, const ChernoffMap& map);

/// What a feature's column says at three places, for a legend: its least, middle and largest value, the middle
/// being the median where places go by order; or each text with a part. All else is at rest.
Expected<std::vector<ChernoffFace>> chernoff_legend(const Table& table, const ChernoffMap& map,
                                                    const ChernoffFeature& feature);

}  // namespace mien::command
