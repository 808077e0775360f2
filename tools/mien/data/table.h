#pragma once
// Tables of data: CSV files (RFC 4180) with a heading.

#include <mien/expected.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mien::command {

struct Table {
  std::string name;                  ///< of its file
  std::vector<std::string> columns;  ///< their headings, no two alike
  std::vector<std::vector<std::string>>
      rows;  ///< a cell for each column; UTF-8 as it stands in the file

  /// The index of a column. The error names the nearest heading.
  Expected<std::size_t> column(std::string_view heading) const;
  /// The finite number in a cell. The error names row and column, counted from 1 below the heading.
  Expected<double> number(std::size_t row, std::size_t column) const;
  /// Whether every row has a finite number there; the error is that of the first cell that has none.
  Expected<Done> numeric(std::size_t column) const;
  /// What errors call a cell: `states.csv: row 7, column "Murder"`.
  std::string place(std::size_t row, std::size_t column) const;
};

/// Reads a table. Errors: a file that cannot be read, quotes that do not end, no rows, two columns of
/// one heading, a row with more or fewer cells than the heading, too much of anything.
Expected<Table> read_table(const std::filesystem::path& path);

/// Appends a cell to a line of CSV, in quotes where it needs them.
void add_cell(std::string& line, std::string_view cell);

}  // namespace mien::command
