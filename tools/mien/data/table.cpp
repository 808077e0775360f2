#include "tools/mien/data/table.h"
#include "lib/base/nearest_name.h"
#include "lib/base/one_line.h"
#include "lib/file/json/read_bytes.h"
#include "tools/mien/data/csv_rows.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>

namespace mien::command {
namespace {

constexpr std::size_t kMostTableBytes = 64u << 20;
constexpr std::size_t kLongest = 60;  // signs of a heading or cell in an error

/// Without blanks around, those that do not break a line among them.
std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks[] = {" ", "\t", "\xC2\xA0"};
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view blank : kBlanks) {
      if (text.starts_with(blank)) text.remove_prefix(blank.size()), again = true;
      if (text.ends_with(blank)) text.remove_suffix(blank.size()), again = true;
    }
  }
  return text;
}

/// The cell that first shows that numbers have decimal commas.
Error decimal_commas_told(const Table& table) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const std::string& cell = table.rows[row][column];
      if (cell.find(',') != std::string::npos && table.number(row, column))
        return {table.place(row, column),
                fmt::format("numbers are read with decimal commas: {} is {}", in_quotes(cell),
                            *table.number(row, column))};
    }
  return {table.name, "numbers are read with decimal commas"};
}

Expected<Done> check_headings(const Table& table) {
  const auto& columns = table.columns;
  for (auto at = columns.begin(); at != columns.end(); ++at)
    if (std::find(columns.begin(), at, *at) != at)
      return Error{table.name, fmt::format("two columns are called {}", in_quotes(*at))};
  return Done{};
}

}  // namespace

Expected<std::size_t> Table::column(std::string_view heading) const {
  const auto found = std::ranges::find(columns, trimmed(heading));
  if (found != columns.end()) return std::size_t(found - columns.begin());
  const std::vector<std::string_view> names(columns.begin(), columns.end());
  return Error{name, unknown_name("column", one_line(heading, kLongest), names)};
}

std::string Table::place(std::size_t row, std::size_t column) const {
  return fmt::format("{}:{}: column {}", name, lines[row], in_quotes(columns[column]));
}

Expected<double> Table::number(std::size_t row, std::size_t column) const {
  const std::string& cell = rows[row][column];
  if (const auto value = csv_number(cell, decimal_commas)) return *value;
  if (trimmed(cell).empty()) return Error{place(row, column), "the number is missing"};
  const bool comma = !decimal_commas && csv_number(cell, true);
  return Error{place(row, column),
               fmt::format("expected a finite number, got {}{}", in_quotes(cell),
                           comma ? "; a comma is no decimal point here" : "")};
}

Expected<Done> Table::numeric(std::size_t column) const {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (const auto value = number(row, column); !value) return value.error();
  return Done{};
}

bool Table::has_texts(std::size_t column) const {
  std::size_t texts = 0, filled = 0;
  for (const std::vector<std::string>& row : rows) {
    if (trimmed(row[column]).empty()) continue;
    ++filled, texts += csv_number(row[column], decimal_commas) ? 0 : 1;
  }
  return filled > 0 && 2 * texts >= filled;
}

Expected<Table> read_table(const std::filesystem::path& path, std::vector<Error>* warnings) {
  const auto bytes = read_bytes(path, kMostTableBytes);
  if (!bytes) return bytes.error();
  Table table{.name = one_line(path.string()),
              .columns = {},
              .rows = {},
              .lines = {},
              .decimal_commas = false};
  auto csv = read_csv(*bytes, table.name);
  if (!csv) return csv.error();
  if (csv->rows.size() < 2) return Error{table.name, "expected a heading and rows below it"};
  for (const std::string& heading : csv->rows.front()) table.columns.emplace_back(trimmed(heading));
  table.rows.assign(std::make_move_iterator(csv->rows.begin() + 1),
                    std::make_move_iterator(csv->rows.end()));
  table.lines.assign(csv->lines.begin() + 1, csv->lines.end());
  table.decimal_commas = csv->decimal_commas;
  if (const auto checked = check_headings(table); !checked) return checked.error();
  if (table.decimal_commas) warnings->push_back(decimal_commas_told(table));
  return table;
}

void add_cell(std::string& line, std::string_view cell) {
  std::string written(2 * cell.size() + 2, '\0');
  written.resize(csv_write(written.data(), written.size(), cell.data(), cell.size()));
  const bool plain = cell.find_first_of(",\"\r\n") == std::string_view::npos;
  line += plain ? std::string(cell) : written;
}

}  // namespace mien::command
