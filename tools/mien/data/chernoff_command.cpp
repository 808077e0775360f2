// mien chernoff: each row of a table as a face.

#include <mien/composed_face.h>
#include <mien/pose.h>
#include <mien/scene_from_face.h>
#include "lib/base/one_line.h"
#include "lib/file/json/json_text.h"
#include "lib/rig/pose/expression_setting.h"
#include "render/image/file/written_file.h"
#include "render/image/load_encoder.h"
#include "render/image/write_pieces.h"
#include "tools/mien/cli/parse_values.h"
#include "tools/mien/commands/commands.h"
#include "tools/mien/data/chernoff_faces.h"
#include "tools/mien/output/captioned_sheet.h"
#include "tools/mien/output/drawn_picture.h"
#include "tools/mien/output/letters.h"
#include "tools/mien/output/sha256.h"
#include "tools/mien/terminal/messages.h"
#include "tools/mien/terminal/watched_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace mien::command {
namespace {

constexpr int kDefaultFace = 160, kSmallestFace = 16, kLargestFace = 4096;  // [px] the longer side
constexpr int kFacesInARow = 10, kLegendColumns = 3;

Expected<SheetCell> cell_of(const ChernoffFace& what, int size) {
  const auto face = face_from_recipe(what.recipe, face_letters());
  if (!face) return face.error();
  Pose pose;
  for (const auto& [emotion, strength] : what.emotions) {
    const auto setting = read_expression(*face, "emotion", fmt::format("{}={}", emotion, strength));
    if (!setting) return setting.error();
    pose.settings.push_back(*setting);
  }
  const Scene scene = scene_from_face(pose_face(*face, pose));
  const glm::dvec2 extent = scene.canvas().box.size();
  const auto pixels = read_size(std::to_string(size), extent.x / extent.y);
  if (!pixels) return pixels.error();
  return SheetCell{what.label,
                   sheet_picture(scene, {.width = pixels->width, .height = pixels->height})};
}

Expected<std::vector<SheetCell>> cells_of(const std::vector<ChernoffFace>& faces, int size,
                                          const std::string& phase) {
  std::vector<std::optional<Expected<SheetCell>>> made(faces.size());
  watched_for(phase, int(faces.size()), {},
              [&](int i) { made[std::size_t(i)] = cell_of(faces[std::size_t(i)], size); });
  std::vector<SheetCell> cells;
  for (auto& cell : made) {
    if (!*cell) return cell->error();
    cells.push_back(**std::move(cell));
  }
  return cells;
}

/// A row for each face: what it is called, its cells of the table, what they moved where, and the SHA-256 of its
/// pixels.
std::string manifest(const Table& table, const ChernoffMap& map,
                     const std::vector<ChernoffFace>& faces, const std::vector<SheetCell>& cells) {
  std::string text = "face";
  const auto add = [&](std::string_view cell) { text += ',', add_cell(text, cell); };
  for (const ChernoffFeature& feature : map.features) add(feature.column), add(feature.name);
  text += ",sha256\n";
  for (std::size_t row = 0; row < faces.size(); ++row) {
    add_cell(text, faces[row].label);
    auto emotion = faces[row].emotions.begin();
    for (const ChernoffFeature& feature : map.features) {
      add(table.rows[row][*table.column(feature.column)]);
      if (feature.kind == ChernoffFeatureKind::number)
        add(json_number(faces[row].recipe.numbers.at(feature.name)));
      else if (feature.kind == ChernoffFeatureKind::emotion)
        add(json_number((emotion++)->second));
      else
        add(feature.values.at(table.rows[row][*table.column(feature.column)]));
    }
    text += ',' + sha256(cells[row].image.bytes) + '\n';
  }
  return text;
}

Expected<Done> write_cells(const std::vector<SheetCell>& cells, const SheetLayout& layout,
                           const std::string& path) {
  const auto sheet = captioned_sheet(cells, layout);
  if (!sheet) return sheet.error();
  return write_image_by(load_encoder, *sheet, path, {});
}

bool differ(const ChernoffFace& a, const ChernoffFace& b) {
  return a.recipe.numbers != b.recipe.numbers || a.recipe.parts != b.recipe.parts ||
         a.emotions != b.emotions;
}

/// What each column moves, a row each: its least, middle and largest value. A column that nobody sees, as one that moves
/// the age, by which only parts are chosen, is a warning.
Expected<std::vector<std::vector<SheetCell>>> legend_rows(const Table& table,
                                                          const ChernoffMap& map, int size,
                                                          std::vector<Error>& warnings) {
  std::vector<std::vector<SheetCell>> rows;
  for (const ChernoffFeature& feature : map.features) {
    const auto faces = chernoff_legend(table, map, feature);
    if (!faces) return faces.error();
    auto row = cells_of(*faces, size, "legend");
    if (!row) return row.error();
    const auto looks_alike = [&](const SheetCell& cell) {
      return cell.image.bytes == row->front().image.bytes;
    };
    if (std::ranges::all_of(*row, looks_alike) && differ(faces->front(), faces->back()))
      warnings.push_back(
          {feature.where, fmt::format("{} moves {}, which changes nothing that is seen",
                                      in_quotes(feature.column), in_quotes(feature.name))});
    rows.push_back(*std::move(row));
  }
  return rows;
}

Expected<Done> write_legend(std::vector<std::vector<SheetCell>> rows, int gap,
                            const std::string& path) {
  std::vector<SheetCell> cells;
  for (std::vector<SheetCell>& row : rows) {
    while (row.size() % kLegendColumns != 0) {  // each feature begins a row
      row.push_back({{}, row.front().image});
      std::ranges::fill(row.back().image.bytes, std::byte{255});
    }
    std::ranges::move(row, std::back_inserter(cells));
  }
  return write_cells(cells, {kLegendColumns, gap}, path);
}

}  // namespace

int chernoff_command(const ChernoffArguments& arguments) {
  const auto layout = read_sheet_layout(arguments.columns, kFacesInARow, arguments.gap);
  if (!layout) return complain(layout.error(), kUsedWrongly);
  const auto size = read_whole("--cell", arguments.cell.value_or(std::to_string(kDefaultFace)),
                               kSmallestFace, kLargestFace);
  if (!size) return complain(size.error(), kUsedWrongly);
  std::vector<Error> warnings;
  const auto table = read_table(arguments.table, &warnings);
  if (!table) return complain(table.error(), kFailed);
  auto map = arguments.map ? read_chernoff_map(*arguments.map, &warnings)
                           : default_chernoff_map(*table, &warnings);
  warn(warnings);
  if (!map) return complain(map.error(), kFailed);
  if (arguments.style) map->face.style = *arguments.style;
  const auto faces = chernoff_faces(*table, *map);
  if (!faces) return complain(faces.error(), kFailed);
  if (const auto constant = constant_columns(*table, *map)) warn({*constant});
  const auto cells = cells_of(*faces, int(*size), "faces");
  if (!cells) return complain(cells.error(), kFailed);
  warnings.clear();
  auto legend = legend_rows(*table, *map, int(*size), warnings);
  if (!legend) return complain(legend.error(), kFailed);
  warn(warnings);
  auto done = write_cells(*cells, *layout, arguments.output);
  if (done && arguments.legend)
    done = write_legend(*std::move(legend), layout->gap, *arguments.legend);
  if (done && arguments.manifest)
    done = write_file(*arguments.manifest, [&](const PutBytes& put) {
      const std::string text = manifest(*table, *map, *faces, *cells);
      return put(text.data(), text.size());
    });
  return done ? int(kDone) : complain(done.error(), kFailed);
}

}  // namespace mien::command
