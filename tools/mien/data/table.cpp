#include "tools/mien/data/table.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include "lib/base/from_chars.h"

namespace mien::command {
namespace {

constexpr std::size_t kMostTableBytes = 64u << 20;
constexpr std::size_t kMostRows = 100'000, kMostColumns = 1000;
constexpr std::size_t kLongest = 60;  // signs of a heading or cell in an error

/// What the parser has found so far.
struct Rows {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  bool too_many = false;
};

void end_cell(void* text, std::size_t length, void* to) {
  Rows& rows = *static_cast<Rows*>(to);
  if (rows.row.size() > kMostColumns || rows.too_many) return;
  rows.row.emplace_back(static_cast<const char*>(text), length);
}

void end_row(int, void* to) {
  Rows& rows = *static_cast<Rows*>(to);
  rows.too_many = rows.too_many || rows.rows.size() > kMostRows;
  if (!rows.too_many) rows.rows.push_back(std::move(rows.row));
  rows.row.clear();
}

Expected<std::vector<std::vector<std::string>>> rows_of(const std::string& text,
                                                        const std::string& name) {
  csv_parser parser{};
  if (csv_init(&parser, CSV_STRICT | CSV_STRICT_FINI) != 0) return Error{name, "cannot be read"};
  const std::unique_ptr<csv_parser, void (*)(csv_parser*)> freed(&parser, csv_free);
  constexpr std::string_view kMark = "\xEF\xBB\xBF";  // some programs begin UTF-8 with it
  const std::size_t begin = text.starts_with(kMark) ? kMark.size() : 0;
  Rows rows;
  const std::size_t read =
      csv_parse(&parser, text.data() + begin, text.size() - begin, end_cell, end_row, &rows);
  if (read != text.size() - begin || csv_fini(&parser, end_cell, end_row, &rows) != 0)
    return Error{fmt::format("{}: row {}", name, rows.rows.size()),
                 "quotes that do not end, or that stand inside a cell without quotes"};
  if (rows.too_many) return Error{name, fmt::format("more than {} rows", kMostRows)};
  return std::move(rows.rows);
}

std::optional<double> finite(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, wrong] = from_chars(text.data(), text.data() + text.size(), value);
  if (wrong != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace

Expected<std::size_t> Table::column(std::string_view heading) const {
  const auto found = std::ranges::find(columns, heading);
  if (found != columns.end()) return std::size_t(found - columns.begin());
  const std::vector<std::string_view> names(columns.begin(), columns.end());
  return Error{name, unknown_name("column", one_line(heading, kLongest), names)};
}

std::string Table::place(std::size_t row, std::size_t column) const {
  return fmt::format("{}: row {}, column {}", name, row + 1, in_quotes(columns[column]));
}

Expected<double> Table::number(std::size_t row, std::size_t column) const {
  const std::string& cell = rows[row][column];
  if (const auto value = finite(cell)) return *value;
  if (cell.find_first_not_of(' ') == std::string::npos)
    return Error{place(row, column), "the number is missing"};
  return Error{place(row, column),
               fmt::format("expected a finite number, got {}", in_quotes(cell))};
}

Expected<Done> Table::numeric(std::size_t column) const {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (const auto value = number(row, column); !value) return value.error();
  return Done{};
}

Expected<Table> read_table(const std::filesystem::path& path) {
  const auto text = read_bytes(path, kMostTableBytes);
  if (!text) return text.error();
  Table table{.name = path.string(), .columns = {}, .rows = {}};
  auto rows = rows_of(*text, table.name);
  if (!rows) return rows.error();
  if (rows->size() < 2) return Error{table.name, "expected a heading and rows below it"};
  table.columns = std::move(rows->front());
  table.rows.assign(std::make_move_iterator(rows->begin() + 1),
                    std::make_move_iterator(rows->end()));
  if (table.columns.size() > kMostColumns)
    return Error{table.name, fmt::format("more than {} columns", kMostColumns)};
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (std::find(table.columns.begin(), table.columns.begin() + long(i), table.columns[i]) !=
        table.columns.begin() + long(i))
      return Error{table.name,
                   fmt::format("two columns are called {}", in_quotes(table.columns[i]))};
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    if (table.rows[i].size() != table.columns.size())
      return Error{
          fmt::format("{}: row {}", table.name, i + 1),
          fmt::format("{} cells, the heading has {}", table.rows[i].size(), table.columns.size())};
  return table;
}

void add_cell(std::string& line, std::string_view cell) {
  std::string written(2 * cell.size() + 2, '\0');
  written.resize(csv_write(written.data(), written.size(), cell.data(), cell.size()));
  const bool plain = cell.find_first_of(",\"\r\n") == std::string_view::npos;
  line += plain ? std::string(cell) : written;
}

}  // namespace mien::command
